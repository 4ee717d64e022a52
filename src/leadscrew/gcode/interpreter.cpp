#include <bit>
#include <leadscrew/gcode/interpreter.hpp>

namespace leadscrew::gcode {

Interpreter::Interpreter(const Context& context)
    : Part(context),
      outbox_(context),
      events_(context, outbox_),
      travel_(context),
      motion_(context, travel_, outbox_),
      vectors_(context, motion_, travel_, outbox_),
      curves_(context, motion_, travel_, outbox_),
      cycles_(context, motion_, travel_, outbox_),
      threading_(context, motion_, travel_, outbox_),
      lathe_cycles_(context, motion_, travel_),
      cutter_(context),
      compensation_(context, cutter_, travel_),
      planned_(context, travel_, outbox_),
      circular_pockets_(context, motion_, cutter_, planned_),
      pocket_cycle_(context, motion_, cutter_, planned_),
      engraving_(context, motion_, planned_),
      turning_cycles_(context, motion_, threading_, outbox_),
      pecking_cycles_(context, motion_, planned_),
      surface_blocks_(context),
      surface_moves_(context, motion_, travel_, outbox_, surface_blocks_),
      directed_curve_(context, motion_, travel_, outbox_),
      probing_(context, motion_, travel_, outbox_),
      offsets_(context, motion_),
      tilted_planes_(context, travel_, outbox_),
      transforms_(context),
      polar_(context),
      saved_modes_(context, outbox_, offsets_, compensation_),
      check_(context, travel_) {
  modal_.tolerance = machine_.tolerance;
  if (machine_.rotary_chain) modal_.orientation_tolerance = machine_.rotary_chain->orientation_tolerance;
  frame_.position = options_.start;
  parameters_.load(options_.parameters);
  offsets_.begin();
  travel_.note_outside();
  if (options_.dialect == Dialect::leadscrew || options_.dialect == Dialect::linuxcnc)
    modal_.retract = Retract::r_level;
  if (options_.dialect == Dialect::fanuc_lathe) begin_turning();
  set_path_control({});
}

// Lathes of Fanuc's G-code system A: X is a diameter, F of a revolution.
void Interpreter::begin_turning() {
  modal_.plane = Plane::ZX;
  modal_.diameters = true;
  modal_.is_plain = false;
  modal_.feed_mode = FeedMode::per_revolution;
}

void Interpreter::execute(const Block& block, base::Line line) {
  modal_.line = line;
  outbox_.clear();
  if (!modal_.is_plain || block.has(Group::lathe)) return execute_special(block);
  execute_in_axes(block);
}

// Diameters are halved as they are read, whatever X belongs to (LinuxCNC); G7 and G8 hold for X of their own block.
void Interpreter::execute_special(Block block) {
  if (lathe_cycles_.is_open()) {
    if (modal_.diameters && block.has('X')) block.value['X' - 'A'] /= 2;
    return lathe_cycles_.add(block);
  }
  if (pocket_cycle_.is_open()) return pocket_cycle_.add(block);
  if ((surface_blocks_.is_open() || directed_curve_.is_open()) && add_to_surface(block)) return;
  if (block.has(Group::lathe)) modal_.diameters = block.is(Code::G7);
  modal_.is_plain = false;
  if (modal_.diameters && block.has('X')) block.value['X' - 'A'] /= 2;
  execute_in_axes(block);
  modal_.is_plain = is_plain();
}

bool Interpreter::is_plain() const {
  return !modal_.diameters && !modal_.constant_surface_speed && !saved_modes_.any() && !lathe_cycles_.is_open() &&
         !pocket_cycle_.is_open() && !surface_blocks_.is_open() && !directed_curve_.is_open() && !modal_.calls_macro &&
         !tilted_planes_.is_unfinished() && !compensation_.is_active();
}

void Interpreter::end_contour() {
  outbox_.clear();
  lathe_cycles_.is_open() ? end_lathe_contour() : pocket_cycle_.end();
  modal_.is_plain = is_plain();
}

// Compensation with which the contour begins is on before the cycle is planned: travel is then that of the tool's middle.
void Interpreter::end_lathe_contour() {
  const bool is_compensated = lathe_cycles_.compensation().has_value();
  if (is_compensated) {
    const LatheCycles::Compensation& compensation = *lathe_cycles_.compensation();
    const AtKeptPlace there(reporter_, compensation.place);
    compensation_.set(compensation.block);
  }
  lathe_cycles_.end();
  if (compensation_.aside() != 0) lathe_cycles_.check_way_back(compensation_.aside());
  if (is_compensated && !lathe_cycles_.will_end_compensation()) compensation_.end();
}

void Interpreter::execute_in_axes(const Block& block) {
  if (block.has(Group::nonmodal) && is_of_surface(block.code(Group::nonmodal))) return execute_surface(block);
  if (block.words & polar_bits) return execute_polar(block);
  if (modal_.polar && polar_.applies(block)) {
    const Block in_axes = polar_.in_axes(block);
    begin_block(in_axes);
    return finish_block(in_axes);
  }
  begin_block(block);
  finish_block(block);
}

// Where polar words lead depends on the modes of their block, what else may stand in it on their being axis words.
void Interpreter::execute_polar(Block block) {
  polar_.announce(block);
  begin_block(block);
  polar_.resolve(block);
  finish_block(block);
}

void Interpreter::begin_block(const Block& block) {
  if (reporter_.failed()) reporter_.mute();
  curves_.spoil_after_errors();
  if (!block.complete) {
    // The words that were lost may have said what the next blocks rely on.
    motion_.assume_feed();
    if (modal_.motion == Code::G80) modal_.motion = Code::G0;
  }
  curves_.check(block);
  modal_.to_do = check_.motion_of(block);
  check_.check(block);
  if (frame_.is_tilted()) tilted_planes_.check(block);
  if (compensation_.is_active()) compensation_.check(block);
  if (reporter_.failed()) reporter_.mute();

  motion_.set_feed(block);
  events_.execute(block);
  const bool had_tip_control = frame_.tip_control() != nullptr;
  if (block.has(Group::modes) && saved_modes_.execute(block)) follow_modes(had_tip_control);
  set_modes(block);
}

void Interpreter::finish_block(const Block& block) {
  if (block.has(Group::nonmodal)) dispatch(block.code(Group::nonmodal), block);
  execute_motion(block);
  if (modal_.constant_surface_speed) events_.follow_surface();
  if (block.is(Code::G9)) {
    vectors_.settle();  // what follows is rounded again
    set_path_control({});
  }
  stop(block);

  curves_.note_errors();
  if (reporter_.failed()) abandon();
}

// What has been begun is not gone on with behind an error.
void Interpreter::abandon() {
  curves_.spoil();
  outbox_.clear();
  cycles_.abandon();
  threading_.abandon();
  lathe_cycles_.abandon();
  vectors_.settle();
  planned_.abandon();
  pocket_cycle_.abandon();
  surface_moves_.abandon();
  directed_curve_.abandon();
  compensation_.abandon();
  travel_.note_outside();
  if (!ended_) stop_.reset();
}

// Whether nothing but its axis words, F and what else is in `words` says what the block means, and all of that is known.
inline bool Interpreter::is_plain_block(const Block& block, Code motion, std::uint32_t words) const {
  const std::uint32_t axes = block.words & axis_letter_bits;
  return !(block.words & ~words) && !(block.groups & ~bit(Group::motion)) && !(axes & ~machine_letters_) && axes != 0 &&
         modal_.feed_mode == FeedMode::per_minute && frame_.is_offset_only() && !frame_.tip_control() &&
         !modal_.polar && modal_.is_plain && (!block.has('F') || block['F'] > 0) &&
         (motion == Code::G0 || modal_.feed_known || block.has('F')) && !curves_.open();
}

Interpreter::Plain Interpreter::execute_plain(const Block& block, base::Line line, Move& move) {
  const Code motion = block.groups ? block.codes[index(Group::motion)] : modal_.motion;
  if (motion > Code::G1) return execute_plain_arc(block, motion, line, move);
  constexpr std::uint32_t plain_words = axis_letter_bits | letter_bit('F') | letter_bit('N');
  if (!is_plain_block(block, motion, plain_words)) return Plain::no;
  const std::uint32_t axes = block.words & axis_letter_bits;
  // No state changes before all axis words are known to be inside.
  const base::AxisVector& offset = frame_.offset();
  base::AxisVector target;  // of the axes that stand in the block
  bool moves = false;
  bool linear = false;
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    const std::size_t i = base::index(axis);
    const double along = block.value[letter] * frame_.unit(axis);
    const double before = frame_.position[i];
    target[i] = along + (modal_.distance == Distance::absolute ? offset[i] : before);
    if (!(travel_.low()[i] <= target[i] && target[i] <= travel_.high()[i])) return Plain::no;
    moves |= target[i] != before;
    linear |= target[i] != before && !base::is_rotary(axis);
  }
  if (!travel_.all_inside()) return Plain::no;
  if (block.has('F')) motion_.set_feed(block);
  modal_.motion = motion;
  cycles_.end_series();
  if (!moves) return Plain::no_move;
  outbox_.prepare(move, Move::Kind::line, line);
  if (motion != Code::G0) move.feed = {Feed::Mode::units_per_second, linear ? modal_.linear_feed : modal_.angular_feed};
  // Axis by axis: a vector that is read as a whole where parts of it have just been written waits for them.
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const std::size_t i = base::index(axis_of_letter(static_cast<unsigned>(std::countr_zero(rest))));
    move.end[i] = frame_.position[i] = target[i];
  }
  return Plain::move;
}

// The same of an arc without P, of which nothing is to be reported.
Interpreter::Plain Interpreter::execute_plain_arc(const Block& block, Code motion, base::Line line, Move& move) {
  constexpr std::uint32_t plain_words = axis_letter_bits | letter_bit('F') | letter_bit('N') | letter_bit('I') |
                                        letter_bit('J') | letter_bit('K') | letter_bit('R');
  if (!is_arc(motion) || modal_.motion > Code::G3 || !travel_.all_inside() ||
      !is_plain_block(block, motion, plain_words)) {
    return Plain::no;
  }
  const base::AxisVector target = motion_.target_of(block);
  const std::optional<ArcCircle> circle = motion_.plain_circle(block, motion, target);
  if (!circle) return Plain::no;
  if (block.has('F')) motion_.set_feed(block);
  modal_.motion = motion;
  outbox_.prepare(move, Move::Kind::arc, line);
  move.end = frame_.position = target;
  move.center_first = circle->center.first;
  move.center_second = circle->center.second;
  move.turns = motion == Code::G3 ? 1 : -1;
  move.feed = {Feed::Mode::units_per_second, modal_.linear_feed};
  return Plain::move;
}

void Interpreter::settle() {
  vectors_.settle();
  compensation_.settle();
}

const KeptPlace* Interpreter::place_of(base::Line line) const {
  const KeptPlace* const place = vectors_.place_of(line);
  return place ? place : compensation_.place_of(line);
}

bool Interpreter::next(Move& move) {
  if (compensation_.is_active()) return next_compensated(move);
  return next_uncompensated(move);
}

bool Interpreter::next_uncompensated(Move& move) {
  return vectors_.any() ? next_with_vectors(move) : next_of_block(move);
}

// What the block makes comes behind the lines that are kept back.
bool Interpreter::next_with_vectors(Move& move) {
  while (vectors_.is_open() && next_of_block(move)) vectors_.keep(move);
  return vectors_.take(move) || (!vectors_.is_open() && next_of_block(move));
}

// A move of the tool's middle is known where the motion behind it is.
bool Interpreter::next_compensated(Move& move) {
  while (!compensation_.take(move)) {
    if (lathe_cycles_.ends_compensation()) {
      // G40 in a contour waits like any other until all before it has been handed out.
      if (compensation_.keeps_back()) {
        compensation_.settle();
        continue;
      }
      lathe_cycles_.compensation_has_ended();
      compensation_.end();
    }
    if (!next_uncompensated(move)) return false;
    const KeptPlace* const place = lathe_cycles_.place_of(move);
    place ? compensation_.add(move, *place) : compensation_.add(move);
  }
  return true;
}

bool Interpreter::next_of_block(Move& move) {
  if (outbox_.take(move) || cycles_.next(move) || threading_.next(move) || planned_.next(move)) return true;
  if ((surface_moves_.is_active() || directed_curve_.is_active()) && next_of_surface(move)) return true;
  if (lathe_cycles_.next(move, outbox_)) {
    outbox_.clear();
    if (modal_.constant_surface_speed && lathe_cycles_.is_profile()) events_.follow_surface();
    return true;
  }
  if (!stop_) return false;
  outbox_.prepare(move, Move::Kind::event, modal_.line);
  move.event = {*stop_, 0, modal_.line};
  stop_.reset();
  return true;
}

void Interpreter::end(base::Line line) {
  modal_.line = line;
  vectors_.settle();
  curves_.end();
  surface_blocks_.end();
  directed_curve_.end();
  outbox_.clear();
  stop_ = base::Event::Kind::program_end;
  ended_ = true;
}

void Interpreter::execute_motion(const Block& block) {
  // A motion that could not be told keeps the one in force.
  if (block.has(Group::motion)) {
    const Code motion = block.code(Group::motion);
    // LinuxCNC goes on with what was in force before (manual, G Codes, "Modal Groups": G5 is not among them).
    const bool is_once = options_.dialect == Dialect::linuxcnc && (motion == Code::G5 || motion == Code::G5_1);
    if (motion != modal_.motion && !is_once) curves_.forget_tangent();
    if (!is_once) modal_.motion = motion;
  }
  const Code to_do = modal_.to_do;
  if (modal_.motion == Code::G80 || (to_do != Code::none && !is_canned_cycle(to_do))) cycles_.end_series();
  if (to_do != Code::none) dispatch(to_do, block);
}

void Interpreter::stop(const Block& block) {
  switch (block.code(Group::stop)) {
    case Code::none:
      break;
    case Code::M0:
      stop_ = base::Event::Kind::pause;
      break;
    case Code::M1:
      stop_ = base::Event::Kind::optional_pause;
      break;
    case Code::M60:
      stop_ = base::Event::Kind::pallet_pause;
      break;
    default:
      stop_ = base::Event::Kind::program_end;
      ended_ = true;
      break;
  }
}

}  // namespace leadscrew::gcode
