#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/config/file_text.hpp>
#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/config/probe_keys.hpp>
#include <leadscrew/config/probe_surface.hpp>
#include <leadscrew/config/rotary_keys.hpp>
#include <leadscrew/config/screw_keys.hpp>
#include <leadscrew/config/spindle_keys.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>

namespace leadscrew::config {

namespace {

using machine::Machine;
using Position = toml::source_position;
namespace field = machine::field;

/// The nearest whole number of them; empty for NaN.
std::optional<std::int64_t> nanoseconds(double microseconds) {
  if (std::isnan(microseconds)) return std::nullopt;
  return std::llround(std::clamp(microseconds, -1e9, 1e9) * 1e3);
}

bool is_before(const base::Diagnostic& a, const base::Diagnostic& b) {
  return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
}

/// One pass over a parsed file.
class MachineReader {
 public:
  MachineReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  MachineOrProblems read() {
    machine_.name = std::filesystem::path(file_).stem();
    if (const auto root = parse()) {
      read_machine_keys(*root);
      read_laser(*root);
      read_probe(*root);
      read_spindle(*root);
      read_axes(*root);
      read_chain(*root);
      judge();
    }
    if (problems_.empty()) return std::move(machine_);
    std::stable_sort(problems_.begin(), problems_.end(), is_before);
    if (untold_ > 0) {
      problems_.push_back(base::problem("too-many-problems", fmt::format("{} more problems are not told", untold_),
                                        "is this a machine file?"));
      problems_.back().place.file = file_;
    }
    return tl::unexpected(std::move(problems_));
  }

 private:
  /// A field of base::Subject, in order.
  using Slot = std::tuple<std::optional<base::Axis>, std::string_view, std::optional<std::size_t>>;

  static Slot slot_of(const base::Subject& subject) { return {subject.axis, subject.field, subject.entry}; }

  bool is_full() const { return problems_.size() >= most_machine_problems; }

  void report(std::string_view code, Position at, std::string message, std::string hint) {
    add(at, base::problem(code, std::move(message), std::move(hint)));
  }

  void add(Position at, base::Diagnostic problem) {
    if (is_full()) {
      ++untold_;
      return;
    }
    problem.place = {file_, static_cast<std::int64_t>(at.line), static_cast<std::int64_t>(at.column)};
    if (at.line > 0) problem.source = line_of(text_, problem.place.line);
    problems_.push_back(std::move(problem));
  }

  /// Text that nests too deep is parsed up to there, for errors of syntax on the lines before.
  std::optional<toml::table> parse() {
    const std::optional<std::size_t> deep = find_deep_nesting(text_);
    const TextPosition at = deep ? position_of(text_, *deep) : TextPosition{};
    auto root = parse_toml(deep ? text_.substr(0, *deep + 1) : text_, file_);
    if (root && !deep) return std::move(*root);
    if (!root && (!deep || root.error().source().begin.line < at.line)) {
      report("machine-syntax", root.error().source().begin, std::string(root.error().description()),
             "machine files are TOML 1.0");
      return std::nullopt;
    }
    report("machine-nesting", {at.line, at.column}, fmt::format("keys or lists nest deeper than {}", deepest_nesting),
           "no machine file needs more than [axis.X.drive] and its keys");
    return std::nullopt;
  }

  void read_machine_keys(const toml::table& root) {
    check_keys(root, machine_keys, false);
    if (const auto name = value<std::string>(root, "name", {})) machine_.name = *name;
    if (const auto kinematics = value<std::string>(root, "kinematics", field::kinematics))
      machine_.kinematics = *kinematics;
    if (const auto waits = value<bool>(root, spindle_waits_key, spindle_waits_key)) machine_.spindle_waits = *waits;
    if (is_second(root, smoothing_key, smoothings, "machine-smoothing"))
      machine_.smoothing = machine::Smoothing::least_time;
    read_dialect(root);
    if (const auto period = number(root, "period_us", {.field = field::period}))
      machine_.period = base::Period{nanoseconds(*period).value_or(0)};
    for (const auto& [field, key, value] : machine_numbers) {
      if (const auto given = number(root, key, {.field = field})) machine_.*value = *given;
    }
  }

  void read_dialect(const toml::table& root) {
    const toml::node* node = root.get(dialect_key);
    if (node == nullptr) return;
    const auto word = node->value_exact<std::string>();
    const auto dialect = word ? machine::dialect_of(*word) : std::nullopt;
    if (dialect) {
      machine_.dialect = *dialect;
      return;
    }
    const std::string found = word ? fmt::format("\"{}\"", shown(*word)) : std::string(type_text(*node));
    report("machine-dialect", node->source().begin, fmt::format("{} is {}", dialect_key, found),
           fmt::format("one of \"{}\"", fmt::join(machine::dialect_names, "\", \"")));
  }

  /// The table of that key, [name], its keys checked; null where there is none.
  const toml::table* section(const toml::table& parent, std::string_view key, std::string_view name,
                             std::span<const std::string_view> keys) {
    const toml::node* node = parent.get(key);
    const toml::table* table = node == nullptr ? nullptr : table_of(*node, name, fmt::format("[{}]", name), key);
    if (table != nullptr) check_keys(*table, keys, false);
    return table;
  }

  void read_laser(const toml::table& root) {
    const toml::table* table = section(root, "laser", "laser", laser_keys);
    if (table == nullptr) return;
    machine::Laser& laser = machine_.laser.emplace();
    if (is_second(*table, "power", laser_powers, "machine-laser")) laser.power = machine::Laser::Power::spindle_speed;
    if (const auto output = value<std::int64_t>(*table, "output", field::laser_output)) laser.output = *output;
    if (const auto follow = value<bool>(*table, "follow_feed", "follow_feed")) laser.follow_feed = *follow;
  }

  void read_chain(const toml::table& root) {
    section(root, geometry_key, geometry_key, geometry_keys);
    machine_.rotary_chain = read_rotary_chain(root, machine_.kinematics, told());
  }

  /// For parts of the file that are read elsewhere.
  KeysTold told() {
    return {[this](auto code, Position at, std::string message, std::string hint) {
              report(code, at, std::move(message), std::move(hint));
            },
            [this](const base::Subject& subject, Position at) { positions_[slot_of(subject)] = at; }};
  }

  void read_probe(const toml::table& root) {
    const toml::table* table = section(root, "probe", "probe", probe_keys);
    if (table == nullptr) return;
    machine::Probe& probe = machine_.probe.emplace(machine::Probe{.bodies = read_probe_bodies(*table, told())});
    probe.patches = read_probe_surface(*table, file_, told());
    const toml::table* planes = section(*table, probe_planes_key, "probe.plane_mm", linear_axis_names);
    if (planes == nullptr) return;
    for (const std::string_view name : linear_axis_names) {
      const auto i = static_cast<std::size_t>(std::ranges::find(axis_names, name) - axis_names.begin());
      probe.planes[i] = number(*planes, name, {.axis = base::all_axes[i], .field = field::probe_plane});
    }
  }

  void read_spindle(const toml::table& root) {
    const toml::table* table = section(root, "spindle", "spindle", spindle_keys);
    if (table != nullptr) machine_.spindle = read_spindle_keys(*table, told());
  }

  void read_axes(const toml::table& root) {
    const toml::node* node = root.get("axis");
    if (node == nullptr) return;
    const toml::table* axes = table_of(*node, "axis", "[axis.X]", "axis");
    if (axes == nullptr) {
      has_axis_ = true;
      return;
    }
    check_keys(*axes, axis_names, true);
    for (const base::Axis axis : base::all_axes) {
      const toml::node* entry = axes->get(axis_names[base::index(axis)]);
      if (entry == nullptr) continue;
      const std::string section = section_of(axis);
      const toml::table* table = table_of(*entry, section, "[" + section + "]", "axis");
      has_axis_ = has_axis_ || table == nullptr;
      if (table != nullptr) read_axis(*table, axis);
    }
  }

  void read_axis(const toml::table& table, base::Axis axis) {
    const std::set<std::string_view> misspelt = check_keys(table, all_axis_keys(axis), false);
    report_missing(table, axis, misspelt);
    // What is missing or wrong has been reported; a sound value in its place keeps machine::validate() from doing so
    // again.
    machine::AxisLimits limits{
        .travel_min = -1, .travel_max = 1, .velocity = 1, .acceleration = 1, .jerk = 1, .blu = 1};
    take(table, axis, field::velocity, limits.velocity);
    take(table, axis, field::acceleration, limits.acceleration);
    take(table, axis, field::jerk, limits.jerk);
    take(table, axis, field::blu, limits.blu);
    read_travel(table, axis, limits);
    read_step_times(table, axis, limits.step_times);
    machine_.axes[base::index(axis)] = limits;
    read_screw(table, axis);
    read_drive(table, axis);
  }

  /// An axis' value, where it is given.
  void take(const toml::table& table, base::Axis axis, std::string_view field, double& value) {
    const auto given = number(table, axis_key_of(axis, field), {.axis = axis, .field = field});
    if (given) value = *given;
  }

  void report_missing(const toml::table& table, base::Axis axis, const std::set<std::string_view>& misspelt) {
    const auto needed = needed_keys(axis);
    for (const std::string_view key : needed) {
      if (table.contains(key) || misspelt.contains(key)) continue;
      report("machine-missing", table.source().begin, fmt::format("[{}] lacks {}", section_of(axis), key),
             fmt::format("an axis gives {}", fmt::join(needed, ", ")));
    }
  }

  void read_travel(const toml::table& table, base::Axis axis, machine::AxisLimits& limits) {
    const std::string_view key = axis_key_of(axis, field::travel);
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const auto pair = pair_of(*node);
    if (!pair) {
      auto [message, hint] = not_a_pair(key, *node, "such as [-500, 500]");
      return report("machine-type", node->source().begin, std::move(message), std::move(hint));
    }
    positions_[slot_of({.axis = axis, .field = field::travel})] = node->source().begin;
    limits.travel_min = pair->front();
    limits.travel_max = pair->back();
  }

  void read_step_times(const toml::table& table, base::Axis axis, machine::StepTimes& times) {
    for (const machine::StepTime& time : machine::all_step_times) {
      const auto microseconds = number(table, axis_key_of(axis, time.name), {.axis = axis, .field = time.name});
      if (microseconds) times.*time.value = nanoseconds(*microseconds).value_or(-1);
    }
  }

  void read_screw(const toml::table& table, base::Axis axis) {
    machine::ScrewErrors& screw = machine_.screws[base::index(axis)];
    screw.table = read_pitch_errors(table, axis, field::pitch_errors, told());
    screw.backward_table = read_pitch_errors(table, axis, field::backward_pitch_errors, told());
    take(table, axis, field::backlash, screw.backlash);
    take(table, axis, field::takeup_velocity, screw.takeup_velocity);
  }

  void read_drive(const toml::table& axis_table, base::Axis axis) {
    const toml::table* table = section(axis_table, drive_key, drive_section_of(axis), all_drive_keys(axis));
    if (table == nullptr) return;
    machine::AxisDrive& drive = machine_.drives[base::index(axis)];
    for (std::size_t k = 0; k < drive_keys.size(); ++k) {
      drive.*machine::drive_numbers[k].value =
          number(*table, text_of(drive_keys[k], axis), {.axis = axis, .field = drive_keys[k].field});
    }
    if (is_second(*table, controller_key, {"cascade", "pid"})) drive.controller = machine::AxisDrive::Controller::pid;
    if (is_second(*table, encoder_key, {"screw", "slide"})) drive.encoder = machine::AxisDrive::Encoder::slide;
  }

  /// Is the value the second of two words? Not where the key is missing.
  bool is_second(const toml::table& table, std::string_view key, std::array<std::string_view, 2> words,
                 std::string_view code = "machine-drive") {
    const toml::node* node = table.get(key);
    if (node == nullptr) return false;
    const auto word = node->value_exact<std::string>();
    if (word && (*word == words[0] || *word == words[1])) return *word == words[1];
    const std::string found = word ? fmt::format("\"{}\"", shown(*word)) : std::string(type_text(*node));
    report(code, node->source().begin, fmt::format("{} is {}", key, found),
           fmt::format("\"{}\" or \"{}\"", words[0], words[1]));
    return false;
  }

  /// Reports keys that are not known; returns the known ones that were probably meant.
  std::set<std::string_view> check_keys(const toml::table& table, std::span<const std::string_view> known,
                                        bool is_of_axes) {
    std::set<std::string_view> meant;
    for (const toml::key* key : unknown_keys(table, known)) {
      has_axis_ = has_axis_ || is_of_axes;
      const auto suggestion = is_full() ? std::nullopt : base::nearest(key->str(), known);
      report("machine-key", key->source().begin,
             fmt::format("{} \"{}\" is not known", is_of_axes ? "axis" : "key", shown(key->str())),
             suggestion && !is_of_axes ? fmt::format("did you mean {}?", *suggestion)
                                       : fmt::format("known here: {}", fmt::join(known, ", ")));
      if (suggestion && !table.contains(*suggestion)) meant.insert(*suggestion);
    }
    return meant;
  }

  /// Null, and reported, where it is no table: `header` with the keys of a `thing` is what would be right.
  const toml::table* table_of(const toml::node& node, std::string_view name, std::string_view header,
                              std::string_view thing) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      report("machine-type", node.source().begin, fmt::format("{} is {}", name, type_text(node)),
             fmt::format("write {} and below it the {}'s keys", header, thing));
    }
    return table;
  }

  /// A string, a whole number, or true or false.
  template <typename T>
  std::optional<T> value(const toml::table& table, std::string_view key, std::string_view field) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    positions_[slot_of({.field = field})] = node->source().begin;
    const auto value = node->value_exact<T>();
    if (!value) {
      const auto [kind, example] = std::is_same_v<T, bool>          ? std::pair("true or false", "true")
                                   : std::is_same_v<T, std::string> ? std::pair("a string", "\"…\"")
                                                                    : std::pair("a whole number", "0");
      report("machine-type", node->source().begin, fmt::format("{} is {}, not {}", key, type_text(*node), kind),
             fmt::format("write {} = {}", key, example));
    }
    return value;
  }

  std::optional<double> number(const toml::table& table, std::string_view key, const base::Subject& subject) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    positions_[slot_of(subject)] = node->source().begin;
    if (!node->is_number()) {
      report("machine-type", node->source().begin, fmt::format("{} is {}, not a number", key, type_text(*node)), "");
      return std::nullopt;
    }
    if (is_inexact(*node)) {
      report("machine-type", node->source().begin,
             fmt::format("{} is {}, which no double-precision number is", key, *node->value<std::int64_t>()),
             exact_hint);
      return std::nullopt;
    }
    return node->value<double>();
  }

  /// Whether the values make sense is for the room of machines to say; where they stand is known here.
  void judge() {
    for (base::Diagnostic& problem : machine::validate(machine_)) {
      // An axis was meant, and what is wrong with it has been said.
      if (problem.code == "machine-axes" && has_axis_) continue;
      const auto found = positions_.find(slot_of(problem.subject));
      // Of an entry that is none it has been said too.
      const bool may_be_none = problem.code == "pitch-value" || problem.code == "machine-probe";
      if (may_be_none && found == positions_.end()) continue;
      if (problem.code == "machine-kinematics") explain_kinematics(problem, machine_.kinematics);
      const Position position = found == positions_.end() ? Position{} : found->second;
      add(position, std::move(problem));
    }
  }

  std::string_view text_;
  std::string file_;
  Machine machine_;
  std::vector<base::Diagnostic> problems_;
  std::size_t untold_ = 0;
  std::map<Slot, Position> positions_;  ///< of values
  bool has_axis_ = false;               ///< some axis was named that could not be taken
};

}  // namespace

MachineOrProblems read_machine(std::string_view text, const std::string& file) {
  if (text.size() > largest_machine_file) return tl::unexpected(std::vector{too_large(file)});
  return MachineReader(text, file).read();
}

}  // namespace leadscrew::config
