#include <bit>
#include <leadscrew/gcode/block_check.hpp>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/offsets.hpp>

namespace leadscrew::gcode {

namespace {

constexpr Dialect in_leadscrew = Dialect::leadscrew, in_linuxcnc = Dialect::linuxcnc, in_fanuc = Dialect::fanuc,
                  in_haas = Dialect::haas, in_grbl = Dialect::grbl, in_mach3 = Dialect::mach3,
                  in_marlin = Dialect::marlin, in_fanuc_lathe = Dialect::fanuc_lathe;

constexpr std::array<FormRow, static_cast<std::size_t>(Form::count)> all_forms = {{
    {Form::g80_beside_motion,
     {in_leadscrew, in_linuxcnc, in_fanuc, in_haas, in_mach3, in_fanuc_lathe},
     "G80 stands beside another motion, which is done",
     "G0 G80 X10"},
    {Form::motion_after_g80,
     {in_leadscrew, in_fanuc, in_haas, in_mach3, in_fanuc_lathe},
     "axis words behind G80 go on with the G0 or G1 that was in force before the cycle",
     "G80\nZ10"},
    {Form::zero_offset_outside_plane,
     {in_leadscrew, in_fanuc, in_haas, in_grbl, in_mach3, in_marlin, in_fanuc_lathe},
     "an arc's offset outside its plane, where it is 0",
     "G17 G2 X10 I5 J0 K0"},
    {Form::idle_d,
     {in_fanuc, in_haas, in_mach3},
     "D may stand where no compensation is switched on, which it is for",
     "G43 H1 D31"},
    {Form::idle_g53, {in_leadscrew, in_mach3}, "G53 without axis words does nothing", "G53 G90 G40"},
    {Form::dwell_by_x, {in_leadscrew, in_fanuc, in_fanuc_lathe}, "G4 takes X or U as well, seconds", "G4 X1.5"},
    {Form::dwell_by_s, {in_marlin}, "G4 takes S, seconds", "G4 S2"},
    {Form::dwell_in_milliseconds, {in_marlin}, "P of G4 is milliseconds", "G4 P500"},
    {Form::whole_milliseconds,
     {in_fanuc, in_haas, in_fanuc_lathe},
     "P of a dwell is milliseconds where it is written without a point, seconds with one",
     "G4 P500"},
    {Form::incremental_home,
     {in_leadscrew, in_fanuc, in_haas},
     "G28 and G30 take U, V and W on machines that have no such axes: distances along X, Y and Z",
     "G28 U0 W0"},
    {Form::home_by_letters, {in_marlin}, "G28 takes axes without numbers and goes home straight", "G28 X Y"},
    {Form::repeats_by_k, {in_fanuc}, "K of a canned cycle is how often it is done", "G91 G81 X5 Z-3 R-2 K4"},
    {Form::scale_in_thousandths,
     {in_fanuc},
     "P, I, J and K of G51 are thousandths where they are written without a point",
     "G51 X0 Y0 P2000"},
    {Form::rapid_at_start, {in_haas, in_grbl}, "G0 is in force where a program begins", "G90 X10 Y5"},
    {Form::incremental_letters,
     {in_fanuc_lathe},
     "U and W are distances along X and Z, X and U of the diameter; of G10 they are added to what it sets, "
     "and C to the nose's radius",
     "G0 X20. Z2.\nU-2. W-1.\nG10 P4 U-0.02"},
    {Form::tool_with_offset,
     {in_fanuc_lathe},
     "T is the number of a tool and, of two digits, of its offset; the tool is changed",
     "T0101"},
    {Form::end_of_text,
     {in_leadscrew, in_fanuc, in_haas, in_grbl, in_mach3, in_marlin, in_fanuc_lathe},
     "a program may end without M2, M30 or %",
     "G0 X10"},
    {Form::program_name,
     {in_leadscrew, in_fanuc, in_fanuc_lathe},
     "a program's name stands between < and >",
     "<PLATE>"},
    {Form::checksum, {in_leadscrew, in_marlin}, "a line ends with the checksum of what stands before", "N3 G28*16"},
    {Form::controller_commands,
     {in_grbl},
     "lines that begin with $, and the characters ! ~ ?, are commands to the controller, which are passed over",
     "$H"},
    {Form::printer_commands,
     {in_marlin},
     "commands of printers that are no motion of axes, and E words, are passed over",
     "M104 S200"},
}};

constexpr bool forms_in_order() {
  for (std::size_t i = 0; i < all_forms.size(); ++i) {
    if (static_cast<std::size_t>(all_forms[i].form) != i) return false;
  }
  return true;
}
static_assert(forms_in_order());

constexpr double milliseconds = 1e-3;  // s
constexpr double thousandths = 1e-3;

// Whether a word's number is written out in digits without a point; what is computed counts as that.
bool is_whole(const TextLine& line, std::uint32_t column) {
  const char* p = line.begin + column;  // behind the letter
  while (is_blank(*p) || *p == '+' || *p == '-') ++p;
  while (is_digit(*p) || is_blank(*p)) ++p;
  return *p != '.';
}

void drop(Block& block, char letter) {
  block.words &= ~letter_bit(letter);
}

void move_word(Block& block, char from, char to, double factor = 1) {
  const auto source = static_cast<std::size_t>(from - 'A'), target = static_cast<std::size_t>(to - 'A');
  block.words = (block.words & ~letter_bit(from)) | letter_bit(to);
  block.value[target] = block.value[source] * factor;
  block.column[target] = block.column[source];
}

}  // namespace

std::span<const FormRow> form_rows() {
  return all_forms;
}

bool has_form(Dialect dialect, Form form) {
  return all_forms[static_cast<std::size_t>(form)].dialects.has(dialect);
}

std::string names_of(Dialects dialects) {
  std::string names;
  for (std::size_t i = 0; i < index(Dialect::count); ++i) {
    const auto dialect = static_cast<Dialect>(i);
    if (dialects.has(dialect)) names += (names.empty() ? "" : ", ") + std::string(name(dialect));
  }
  return names;
}

DialectForms::DialectForms(const Context& context) : Part(context) {
  for (const FormRow& each : all_forms) {
    if (each.dialects.has(options_.dialect)) forms_ |= 1u << static_cast<unsigned>(each.form);
  }
  if (has(Form::rapid_at_start)) modal_.motion = Code::G0;
}

void DialectForms::rewrite(Block& block, const TextLine& line) {
  if (has(Form::printer_commands) && block.has('E')) drop_extruder(block);
  follow_g80(block);
  drop_idle_words(block);
  if (block.is(Code::G4)) rewrite_dwell(block, line);
  if (block.is(Code::G51) && has(Form::scale_in_thousandths)) rewrite_scale(block, line);
  if (has(Form::incremental_letters) && !modal_.in_profile) rewrite_turning(block, line);
  if (block.is(Code::G28) || block.is(Code::G30)) rewrite_home(block);
  const Code motion = block.has(Group::motion) ? block.code(Group::motion) : modal_.motion;
  if (is_canned_cycle(motion) && !block.is(Code::G4)) rewrite_cycle(block, line);
}

// A cycle leaves the motion of G0 and G1 alone, which are of another group there.
void DialectForms::follow_g80(Block& block) {
  if (!has(Form::motion_after_g80)) return;
  if (block.has(Group::motion) && block.code(Group::motion) != Code::G80) {
    const bool straight = modal_.motion == Code::G0 || modal_.motion == Code::G1;
    if (!is_canned_cycle(block.code(Group::motion))) {
      before_cycle_ = Code::none;
    } else if (!is_canned_cycle(modal_.motion)) {
      before_cycle_ = straight ? modal_.motion : Code::none;
    }
  }
  const std::uint32_t axes = block.words & axis_letter_bits;
  if (modal_.motion != Code::G80 || before_cycle_ == Code::none || axes == 0 || block.has(Group::motion)) return;
  for (std::uint32_t rest = block.groups; rest != 0; rest &= rest - 1) {
    if (row(block.codes[static_cast<std::size_t>(std::countr_zero(rest))]).takes_axes) return;
  }
  block.groups |= bit(Group::motion);
  block.codes[index(Group::motion)] = before_cycle_;
  block.code_columns[index(Group::motion)] = block.column[static_cast<unsigned>(std::countr_zero(axes))];
}

void DialectForms::drop_idle_words(Block& block) const {
  const Code motion = block.has(Group::motion) ? block.code(Group::motion) : modal_.motion;
  if (has(Form::zero_offset_outside_plane) && is_arc(motion)) {
    const Plane plane = plane_after(block, modal_);
    const char outside = plane == Plane::XY ? 'K' : plane == Plane::ZX ? 'J' : 'I';
    if (block.has(outside) && block[outside] == 0) drop(block, outside);
  }
  if (has(Form::idle_d) && block.has('D')) drop_idle_d(block);
  constexpr std::uint32_t no_place = letter_bit('F') | letter_bit('N') | letter_bit('S') | letter_bit('T');
  if (has(Form::idle_g53) && block.is(Code::G53) && !(block.words & ~no_place)) {
    block.groups &= ~bit(Group::nonmodal);
  }
}

// D that no code of the block takes is that of the next cycle that needs one.
void DialectForms::drop_idle_d(Block& block) const {
  const bool is_same = modal_.cutter == block['D'];
  modal_.cutter = block['D'];
  const Code code = block.code(Group::nonmodal);
  const bool taken = block.has(Group::cutter_radius) || (code != Code::none && row(code).words.has('D'));
  if (!taken && (modal_.cutter_side == Code::G40 || is_same)) drop(block, 'D');
}

void DialectForms::rewrite_dwell(Block& block, const TextLine& line) const {
  if (block.has('P')) {
    const bool short_unit =
        has(Form::dwell_in_milliseconds) || (has(Form::whole_milliseconds) && is_whole(line, block.column_of('P')));
    if (short_unit) move_word(block, 'P', 'P', milliseconds);
    return;
  }
  if (has(Form::dwell_by_s) && block.has('S')) return move_word(block, 'S', 'P');
  if (!has(Form::dwell_by_x)) return;
  for (const char letter : {'X', 'U'}) {
    if (block.has(letter)) return move_word(block, letter, 'P');
  }
}

void DialectForms::rewrite_home(Block& block) const {
  if (has(Form::home_by_letters)) return;
  if (!has(Form::incremental_home) || !(block.words & (letter_bit('U') | letter_bit('V') | letter_bit('W')))) return;
  const base::AxisVector program = frame_.to_program(frame_.position);
  for (const auto& [letter, axis] : {std::pair{'U', base::Axis::X}, {'V', base::Axis::Y}, {'W', base::Axis::Z}}) {
    const char absolute = base::letter(axis);
    if (!block.has(letter) || (machine_letters_ & letter_bit(letter)) || block.has(absolute)) continue;
    move_word(block, letter, absolute);
    if (distance_after(block, modal_) == Distance::incremental) continue;
    block.value[static_cast<std::size_t>(absolute - 'A')] += program[base::index(axis)] / frame_.length_unit;
  }
}

void DialectForms::rewrite_scale(Block& block, const TextLine& line) const {
  for (const char letter : {'P', 'I', 'J', 'K'}) {
    if (block.has(letter) && is_whole(line, block.column_of(letter))) move_word(block, letter, letter, thousandths);
  }
}

void DialectForms::rewrite_cycle(Block& block, const TextLine& line) const {
  if (has(Form::whole_milliseconds) && block.has('P') && is_whole(line, block.column_of('P'))) {
    move_word(block, 'P', 'P', milliseconds);
  }
  if (has(Form::repeats_by_k) && block.has('K') && !block.has('L')) move_word(block, 'K', 'L');
}

// What U and W of a turning program are added to, mm: where the tool stands, or, of G10, what it sets.
base::AxisVector DialectForms::base_of_distances(const Block& block) const {
  const base::AxisVector stands = frame_.to_program(frame_.position);
  if (!block.is(Code::G10) || !block.has('L') || !block.has('P')) return stands;
  if (block['L'] == 1) {
    const machine::Tool* const tool = tools_.find(as_integer(block['P']).value_or(0));
    return tool ? tool->offset : base::AxisVector{};
  }
  if (sets_shift_of_all(block, options_.dialect)) return parameters_.axes(Parameters::external_offset);
  const std::optional<int> system = system_set_by(block, options_.dialect, modal_.system);
  return system ? parameters_.system(*system).origin : stands;
}

// U, W and C of G10 without L are added to the offset that it sets.
void DialectForms::rewrite_offset(Block& block, const LatheOffsetValues& before) const {
  rewrite_distances(block, before.offset);
  if (!block.has('C') || block.has('R')) return;
  move_word(block, 'C', 'R');
  block.value['R' - 'A'] += before.nose_radius / frame_.length_unit;
}

// U and W are distances from a place, mm.
void DialectForms::rewrite_distances(Block& block, const base::AxisVector& from) const {
  for (const auto& [by, along, axis] : {std::tuple{'U', 'X', base::Axis::X}, {'W', 'Z', base::Axis::Z}}) {
    if (!block.has(by) || block.has(along)) continue;
    move_word(block, by, along);
    const double stands = from[base::index(axis)] / frame_.length_unit;
    block.value[static_cast<std::size_t>(along - 'A')] +=
        axis == base::Axis::X && modal_.diameters ? 2 * stands : stands;
  }
}

// U and W are distances, but for those that a code of the block takes.
void DialectForms::rewrite_turning(Block& block, const TextLine& line) const {
  const Code code = block.code(Group::nonmodal);
  if (code != Code::none && row(code).words.has('U')) return;
  const std::optional<LatheOffset> offset = code == Code::G10 ? lathe_offset_of(block) : std::nullopt;
  if (offset) return rewrite_offset(block, values_of(*offset, tools_));
  rewrite_distances(block, base_of_distances(block));
  const bool pecks = block.is(Code::G74_face) || block.is(Code::G75);
  if (!pecks && !block.is(Code::G76_profile)) return;
  // Depths that take no point: thousandths of a millimetre, or ten-thousandths of an inch.
  const double least = frame_.length_unit == 1 ? 1e-3 : 1e-4;
  for (const char letter : {'P', 'Q'}) {
    const bool is_length = pecks || letter == 'Q' || block.has('X') || block.has('Z');
    if (block.has(letter) && is_length && is_whole(line, block.column_of(letter)))
      move_word(block, letter, letter, least);
  }
}

void DialectForms::drop_extruder(Block& block) {
  if (!told_of_extruder_) {
    reporter_.warning("no-extruder", block.column_of('E'), "E is passed over: there is no axis for material",
                      "moves of X, Y and Z are made as they are");
  }
  told_of_extruder_ = true;
  drop(block, 'E');
  if (block.is(Code::G92) && !(block.words & axis_letter_bits)) block.groups &= ~bit(Group::nonmodal);
}

}  // namespace leadscrew::gcode
