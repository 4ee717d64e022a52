#include <bit>
#include <leadscrew/gcode/interpreter.hpp>
#include <leadscrew/gcode/number.hpp>
#include <limits>
#include <utility>

namespace leadscrew::gcode {

namespace {
// A programmed inch is rounded when it becomes millimetres: that is no excursion.
constexpr double travel_rounding = 1e-9;  // mm or degrees
}  // namespace

Interpreter::Interpreter(const machine::Machine& machine, const machine::ToolTable& tools, const ReaderOptions& options,
                         Parameters& parameters, Frame& frame, Reporter& reporter)
    : machine_(machine),
      tools_(tools),
      options_(options),
      parameters_(parameters),
      frame_(frame),
      reporter_(reporter),
      tolerance_(machine.tolerance) {
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const bool has = machine_.has(axis);
    travel_low_[i] =
        has ? machine_.limits(axis).travel_min - travel_rounding : -std::numeric_limits<double>::infinity();
    travel_high_[i] =
        has ? machine_.limits(axis).travel_max + travel_rounding : std::numeric_limits<double>::infinity();
    if (has) machine_letters_ |= letter_bit(base::letter(axis));
  }
  frame_.position = options_.start;
  note_outside();
  set_path_control({});
}

void Interpreter::execute(const Block& block, base::Line line) {
  line_ = line;
  outbox_size_ = outbox_next_ = 0;
  if (reporter_.failed()) reporter_.mute();
  if (reporter_.errors() != draft_.errors) draft_.spoiled = true;
  if (!block.complete) {
    // The words that were lost may have said what the next blocks rely on.
    assume_feed();
    if (motion_ == 800) motion_ = 0;
  }
  check(block);
  if (reporter_.failed()) reporter_.mute();

  set_feed(block);
  set_spindle_and_tool(block);
  set_coolant(block);
  dwell(block);
  set_modes(block);
  execute_nonmodal(block);
  execute_motion(block);
  stop(block);

  draft_.errors = reporter_.errors();
  if (!reporter_.failed()) return;
  draft_.spoiled = true;
  outbox_size_ = 0;
  if (cycle_.active()) frame_.position = cycle_.end();
  cycle_ = {};
  note_outside();
  if (!ended_) stop_.reset();
}

// A move of no length from where the program stands, which takes no time. Field by field, in the memory of the move before: this is
// done once a block.
void Interpreter::prepare(Move& move, Move::Kind kind, base::Line line) const {
  move.kind = kind;
  move.path_mode = effective_mode_;
  move.plane = plane_;
  move.line = line;
  move.start = frame_.position;
  move.end = frame_.position;
  move.feed = {};
  move.tolerance = effective_tolerance_;
  move.naive_cam_tolerance = effective_naive_cam_tolerance_;
  move.center_first = move.center_second = 0;
  move.turns = 0;
  move.curve.clear();
  move.dwell_seconds = 0;
  move.event = {};
}

Interpreter::Plain Interpreter::execute_plain(const Block& block, base::Line line, Move& move) {
  constexpr std::uint32_t plain_words = axis_letter_bits | letter_bit('F') | letter_bit('N');
  const std::uint32_t axes = block.words & axis_letter_bits;
  const GCode motion = block.g_groups ? block.g[index(Group::motion)] : motion_;
  if ((block.words & ~plain_words) || (block.g_groups & ~bit(Group::motion)) || block.m_groups || motion > 10 ||
      (axes & ~machine_letters_) || axes == 0 || feed_mode_ != FeedMode::per_minute || frame_.is_rotated() ||
      (block.has('F') && !(block['F'] > 0)) || (motion == 10 && !feed_known_ && !block.has('F')) || draft_.code >= 0) {
    return Plain::no;
  }
  // No state changes before all axis words are known to be inside.
  const base::AxisVector& offset = frame_.sum();
  base::AxisVector target;  // of the axes that stand in the block
  bool moves = false;
  bool linear = false;
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    const std::size_t i = base::index(axis);
    const double along = block.value[letter] * frame_.unit(axis);
    const double before = frame_.position[i];
    target[i] = along + (distance_ == Distance::absolute ? offset[i] : before);
    if (!(travel_low_[i] <= target[i] && target[i] <= travel_high_[i])) return Plain::no;
    moves |= target[i] != before;
    linear |= target[i] != before && !base::is_rotary(axis);
  }
  if (!outside_.empty()) return Plain::no;
  if (block.has('F')) set_feed(block);
  motion_ = motion;
  series_.reset();
  if (!moves) return Plain::no_move;
  prepare(move, Move::Kind::line, line);
  if (motion != 0) move.feed = {Feed::Mode::units_per_second, linear ? linear_feed_ : angular_feed_};
  // Axis by axis: a vector that is read as a whole where parts of it have just been written waits for them.
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const std::size_t i = base::index(axis_of_letter(static_cast<unsigned>(std::countr_zero(rest))));
    move.end[i] = frame_.position[i] = target[i];
  }
  return Plain::move;
}

bool Interpreter::next(Move& move) {
  if (outbox_next_ < outbox_size_) {
    // The memory of a curve comes back for the next.
    NurbsCurve memory = std::move(move.curve);
    move = std::move(outbox_[outbox_next_]);
    outbox_[outbox_next_++].curve = std::move(memory);
    return true;
  }
  while (cycle_.active()) {
    const DrillCycle::Step step = cycle_.next();
    if (step.kind == DrillCycle::Step::Kind::dwell) {
      prepare(move, Move::Kind::dwell, line_);
      move.dwell_seconds = cycle_.plan().dwell_seconds;
      return true;
    }
    if (step.target == frame_.position) continue;
    prepare(move, Move::Kind::line, line_);
    move.end = step.target;
    if (step.kind == DrillCycle::Step::Kind::feed) move.feed = cycle_feed_;
    frame_.position = step.target;
    return true;
  }
  if (!stop_) return false;
  prepare(move, Move::Kind::event, line_);
  move.event = {*stop_, 0, line_};
  stop_.reset();
  return true;
}

void Interpreter::end(base::Line line) {
  line_ = line;
  if (draft_.code >= 0 && !draft_.spoiled && reporter_.errors() == draft_.errors) {
    reporter_.report(base::Severity::error, "unfinished-curve", {reporter_.file(), base::number(line), 1},
                     unfinished_message(), unfinished_hint());
  }
  abandon_curve();
  outbox_size_ = outbox_next_ = 0;
  stop_ = base::Event::Kind::program_end;
  ended_ = true;
}

Move& Interpreter::emit(Move::Kind kind) {
  Move& move = outbox_[outbox_size_++];
  prepare(move, kind, line_);
  return move;
}

void Interpreter::emit_event(base::Event::Kind kind, double value, std::int32_t output) {
  using Kind = base::Event::Kind;
  const bool turns_spindle =
      kind == Kind::spindle_clockwise || kind == Kind::spindle_counterclockwise || kind == Kind::spindle_stop;
  const bool waits = kind == Kind::tool_change || (turns_spindle && machine_.spindle_waits);
  emit(Move::Kind::event).event = {kind, value, line_, output, waits};
}

void Interpreter::set_feed(const Block& block) {
  if (block.has(Group::feed_mode)) {
    const FeedMode mode = block.code(Group::feed_mode) == 930 ? FeedMode::inverse_time : FeedMode::per_minute;
    // A number that was a duration is no speed.
    if (mode != feed_mode_) feed_known_ = false;
    feed_mode_ = mode;
  }
  if (!block.has('F')) return;
  const double value = block['F'];
  constexpr double least = 1e-6;  // a millimetre in two years
  if (!(value >= least)) {
    error("bad-value", block.column_of('F'), "the feed is " + text(value), "F must be 0.000001 or more");
    assume_feed();
    return;
  }
  feed_known_ = true;
  linear_feed_ = value * frame_.length_unit / seconds_per_minute;
  angular_feed_ = value / seconds_per_minute;
  if (block.has(Group::units) && (block.code(Group::units) == 200) != (frame_.length_unit != 1)) {
    reporter_.warning("feed-before-units", block.column_of('F'),
                      "F" + text(value) + " is read in the units that held before " + g_name(block.code(Group::units)),
                      "put the units into a block before");
  }
}

// Said once that there is none, what follows is read as if there were one.
void Interpreter::assume_feed() {
  if (!feed_known_) linear_feed_ = angular_feed_ = 1;
  feed_known_ = true;
}

void Interpreter::set_spindle_and_tool(const Block& block) {
  using Kind = base::Event::Kind;
  if (block.has('S')) {
    if (block['S'] < 0) {
      error("bad-value", block.column_of('S'), "the spindle speed is " + text(block['S']), "S must be 0 or more");
    } else {
      spindle_speed_ = block['S'];
      emit_event(Kind::spindle_speed, spindle_speed_);
    }
  }
  if (block.has('T')) {
    const std::optional<int> tool = as_integer(block['T']);
    if (!tool || *tool < 0) {
      error("bad-value", block.column_of('T'), "the tool number is " + text(block['T']),
            "T must be an integer of 0 or more");
      if (!selected_tool_) selected_tool_ = 0;
    } else {
      if (*tool != 0 && !tools_.tools().empty() && !tools_.find(*tool)) {
        reporter_.warning("unknown-tool", block.column_of('T'),
                          "tool " + std::to_string(*tool) + " is not in the tool table", "its offsets are not known");
      }
      selected_tool_ = tool;
      emit_event(Kind::tool_prepare, *tool);
    }
  }
  set_outputs(block);
  if (block.has_m(6)) {
    if (!selected_tool_) {
      error("missing-word", block.m_column[6], "M6 changes to no tool", "select it with T before");
      selected_tool_ = 0;
    }
    loaded_tool_ = *selected_tool_;
    emit_event(Kind::tool_change, loaded_tool_);
  }
  if (block.has_m(7)) {
    switch (block.m[7]) {
      case 3:
        emit_event(Kind::spindle_clockwise, spindle_speed_);
        break;
      case 4:
        emit_event(Kind::spindle_counterclockwise, spindle_speed_);
        break;
      default:
        emit_event(Kind::spindle_stop);
        break;
    }
  }
}

void Interpreter::set_outputs(const Block& block) {
  using Kind = base::Event::Kind;
  if (!block.has_m(5)) return;
  const std::uint8_t code = block.m[5];
  const char letter = *letters_of_output(code);
  for (const char* each = letters_of_output(code); *each != 0; ++each) {
    if (!block.has(*each)) return;
  }
  const std::optional<int> output = as_integer(block[letter]);
  if (!output || *output < 0 || *output >= base::most_outputs) {
    error("bad-value", block.column_of(letter), "the number of the output is " + text(block[letter]),
          std::string(1, letter) + " must be an integer of 0 to " + std::to_string(base::most_outputs - 1));
    return;
  }
  constexpr Kind digital[] = {Kind::digital_output_on_with_motion, Kind::digital_output_off_with_motion,
                              Kind::digital_output_on, Kind::digital_output_off};
  if (code <= 65) return emit_event(digital[code - 62], code % 2 == 0 ? 1 : 0, *output);
  emit_event(code == 67 ? Kind::analog_output_with_motion : Kind::analog_output, block['Q'], *output);
}

void Interpreter::set_coolant(const Block& block) {
  using Kind = base::Event::Kind;
  if (!block.has_m(8)) return;
  emit_event(block.m[8] == 7 ? Kind::coolant_mist : block.m[8] == 8 ? Kind::coolant_flood : Kind::coolant_off);
}

void Interpreter::dwell(const Block& block) {
  if (block.code(Group::nonmodal) != 40 || !block.has('P')) return;
  if (block['P'] < 0) {
    error("bad-value", block.column_of('P'), "the dwell is " + text(block['P']) + " s", "P must be 0 or more");
    return;
  }
  emit(Move::Kind::dwell).dwell_seconds = block['P'];
}

void Interpreter::set_modes(const Block& block) {
  plane_ = plane_after(block);
  if (block.has(Group::units)) frame_.length_unit = block.code(Group::units) == 200 ? 25.4 : 1;
  set_tool_length(block);
  if (block.has(Group::system)) {
    const GCode code = block.code(Group::system);
    select_system(code <= 590 ? code / 10 - 53 : code - 584);
  }
  if (block.has(Group::path)) set_path_control(block);
  distance_ = distance_after(block);
  if (block.has(Group::arc_distance)) {
    arc_distance_ = block.code(Group::arc_distance) == 901 ? Distance::absolute : Distance::incremental;
  }
  if (block.has(Group::retract)) {
    retract_ = block.code(Group::retract) == 980 ? Retract::initial_level : Retract::r_level;
  }
}

void Interpreter::set_path_control(const Block& block) {
  switch (block.code(Group::path)) {
    case 610:
      path_mode_ = PathMode::exact_path;
      break;
    case 611:
      path_mode_ = PathMode::exact_stop;
      break;
    case 640:
      path_mode_ = PathMode::blend;
      for (const char letter : {'P', 'Q'}) {
        if (block.value_or(letter, 0) < 0) {
          error("bad-value", block.column_of(letter), "the tolerance is " + text(block[letter]),
                std::string(1, letter) + " must be 0 or more");
          return;
        }
      }
      tolerance_ = block.has('P') ? block['P'] * frame_.length_unit : machine_.tolerance;
      naive_cam_tolerance_.reset();
      if (block.has('Q')) naive_cam_tolerance_ = block['Q'] * frame_.length_unit;
      break;
    default:
      break;
  }
  effective_mode_ = options_.path_mode.value_or(path_mode_);
  const bool blends = effective_mode_ == PathMode::blend;
  effective_tolerance_ = blends ? options_.tolerance.value_or(tolerance_) : 0;
  effective_naive_cam_tolerance_ = blends ? naive_cam_tolerance_.value_or(effective_tolerance_) : 0;
}

void Interpreter::stop(const Block& block) {
  if (!block.has_m(4)) return;
  switch (block.m[4]) {
    case 0:
      stop_ = base::Event::Kind::pause;
      break;
    case 1:
      stop_ = base::Event::Kind::optional_pause;
      break;
    case 60:
      stop_ = base::Event::Kind::pallet_pause;
      break;
    default:
      stop_ = base::Event::Kind::program_end;
      ended_ = true;
      break;
  }
}

}  // namespace leadscrew::gcode
