#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <leadscrew/cli/drive_keys.hpp>
#include <leadscrew/cli/machine_file.hpp>
#include <leadscrew/cli/machine_keys.hpp>
#include <leadscrew/cli/nearest.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>

namespace leadscrew::cli {

namespace {

/// Named by the contract, and not yet more than names.
constexpr std::array<std::string_view, 6> later_kinematics = {"table-table-ac", "table-table-bc", "head-head-bc",
                                                              "head-head-ac",   "head-b-table-c", "head-b-table-a"};

constexpr const char* pitch_hint = "entries [position, error], such as [[-100, 0], [100, 0.012]]";

std::string_view type_text(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::none:
      return "nothing";
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

std::optional<std::array<double, 2>> pair_of(const toml::node& node) {
  const toml::array* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number()) return std::nullopt;
  return std::array{*(*pair)[0].value<double>(), *(*pair)[1].value<double>()};
}

/// Why it is none.
std::string not_a_pair(std::string_view what, const toml::node& node) {
  return node.is_array() ? fmt::format("{} is a list, but not of two numbers", what)
                         : fmt::format("{} is {}, not a list of two numbers", what, type_text(node));
}

/// The nearest whole number of them; nothing where it is no number.
std::optional<std::int64_t> nanoseconds(double microseconds) {
  if (std::isnan(microseconds)) return std::nullopt;
  return std::llround(std::clamp(microseconds, -1e9, 1e9) * 1e3);
}

std::string joined(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string_view line_of(std::string_view text, std::int64_t number) {
  for (std::int64_t line = 1; line < number; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

/// One pass over a parsed file.
class MachineReader {
 public:
  MachineReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  MachineFile read() {
    result_.machine.name = std::filesystem::path(file_).stem();
    if (const auto root = parse()) {
      read_machine_keys(*root);
      read_axes(*root);
      judge();
    }
    std::stable_sort(result_.diagnostics.begin(), result_.diagnostics.end(), [](auto& a, auto& b) {
      return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    return std::move(result_);
  }

 private:
  using Position = toml::source_position;

  void report(std::string_view code, Position at, std::string message, std::string hint) {
    base::Place place{file_, static_cast<std::int64_t>(at.line), static_cast<std::int64_t>(at.column)};
    std::string source = at.line > 0 ? std::string(line_of(text_, place.line)) : std::string();
    result_.diagnostics.push_back(
        {base::Severity::error, code, std::move(message), std::move(hint), std::move(place), std::move(source)});
  }

  std::optional<toml::table> parse() {
    try {
      return toml::parse(text_, file_);
    } catch (const toml::parse_error& error) {
      report("machine-syntax", error.source().begin, std::string(error.description()), "machine files are TOML 1.0");
      return std::nullopt;
    }
  }

  void read_machine_keys(const toml::table& root) {
    machine::Machine& machine = result_.machine;
    check_keys(root, machine_keys, "");
    if (const auto name = string(root, "name")) machine.name = *name;
    if (const auto kinematics = string(root, "kinematics")) machine.kinematics = *kinematics;
    if (const auto period = number(root, "period_us", "")) {
      machine.period = base::Period{nanoseconds(*period).value_or(0)};
    }
    if (const auto tolerance = number(root, "tolerance_mm", "")) machine.tolerance = *tolerance;
    if (const auto chord_error = number(root, "chord_error_mm", "")) machine.chord_error = *chord_error;
  }

  void read_axes(const toml::table& root) {
    const toml::node* node = root.get("axis");
    if (node == nullptr) return;
    const toml::table* axes = node->as_table();
    if (axes == nullptr) {
      has_axis_ = true;
      report("machine-type", node->source().begin, fmt::format("axis is {}", type_text(*node)),
             "write [axis.X] and below it the axis's keys");
      return;
    }
    check_keys(*axes, axis_names, "axis");
    for (const base::Axis axis : base::all_axes) {
      const toml::node* entry = axes->get(axis_names[base::index(axis)]);
      if (entry == nullptr) continue;
      if (const toml::table* table = entry->as_table()) {
        read_axis(*table, axis);
      } else {
        has_axis_ = true;
        report("machine-type", entry->source().begin,
               fmt::format("axis.{} is {}", base::letter(axis), type_text(*entry)),
               fmt::format("write [axis.{}] and below it the axis's keys", base::letter(axis)));
      }
    }
  }

  void read_axis(const toml::table& table, base::Axis axis) {
    const AxisKeys& keys = keys_of(axis);
    const std::string section = section_of(axis);
    const std::set<std::string_view> misspelt = check_keys(table, keys.all(), section);
    positions_[section] = table.source().begin;
    // What is missing or wrong has been reported; a sound value in its place keeps machine::validate() from doing so
    // again.
    machine::AxisLimits limits{
        .travel_min = -1, .travel_max = 1, .velocity = 1, .acceleration = 1, .jerk = 1, .blu = 1};
    const auto take = [&](std::string_view key, double& value) {
      if (const auto given = required(table, key, axis, misspelt)) value = *given;
    };
    take(keys.velocity, limits.velocity);
    take(keys.acceleration, limits.acceleration);
    take(keys.jerk, limits.jerk);
    take(keys.blu, limits.blu);
    read_travel(table, axis, misspelt, limits);
    read_step_times(table, axis, limits.step_times);
    result_.machine.axes[base::index(axis)] = limits;
    read_screw(table, axis);
    read_drive(table, axis);
  }

  void read_travel(const toml::table& table, base::Axis axis, const std::set<std::string_view>& misspelt,
                   machine::AxisLimits& limits) {
    const std::string_view key = keys_of(axis).travel;
    const toml::node* node = table.get(key);
    if (node == nullptr) return missing(table, key, axis, misspelt);
    const auto pair = pair_of(*node);
    if (!pair) return report("machine-type", node->source().begin, not_a_pair(key, *node), "such as [-500, 500]");
    positions_[fmt::format("{}.{}", section_of(axis), key)] = node->source().begin;
    limits.travel_min = pair->front();
    limits.travel_max = pair->back();
  }

  void read_step_times(const toml::table& table, base::Axis axis, machine::StepTimes& times) {
    for (std::size_t k = 0; k < machine::all_step_times.size(); ++k) {
      const auto microseconds = number(table, keys_of(axis).step_times[k], section_of(axis));
      if (microseconds) times.*machine::all_step_times[k].value = nanoseconds(*microseconds).value_or(-1);
    }
  }

  void read_screw(const toml::table& table, base::Axis axis) {
    const AxisKeys& keys = keys_of(axis);
    machine::ScrewErrors& screw = result_.machine.screws[base::index(axis)];
    screw.table = pitch_errors(table, keys.pitch_errors, axis);
    screw.backward_table = pitch_errors(table, keys.pitch_errors_backward, axis);
    if (const auto backlash = number(table, keys.backlash, section_of(axis))) screw.backlash = *backlash;
    if (const auto takeup = number(table, keys.takeup, section_of(axis))) screw.takeup_velocity = *takeup;
  }

  void read_drive(const toml::table& axis_table, base::Axis axis) {
    const toml::node* node = axis_table.get(keys_of(axis).drive);
    if (node == nullptr) return;
    const std::string section = drive_section_of(axis);
    const toml::table* table = node->as_table();
    if (table == nullptr) {
      return report("machine-type", node->source().begin, fmt::format("{} is {}", section, type_text(*node)),
                    fmt::format("write [{}] and below it the drive's keys", section));
    }
    check_keys(*table, all_drive_keys(axis), section);
    machine::AxisDrive& drive = result_.machine.drives[base::index(axis)];
    const auto& keys = drive_keys_of(axis);
    for (std::size_t k = 0; k < keys.size(); ++k)
      drive.*machine::drive_numbers[k].value = number(*table, keys[k], section);
    if (is_second(*table, controller_key, {"cascade", "pid"})) drive.controller = machine::AxisDrive::Controller::pid;
    if (is_second(*table, encoder_key, {"screw", "slide"})) drive.encoder = machine::AxisDrive::Encoder::slide;
  }

  /// Of two words the second; the first where none is told.
  bool is_second(const toml::table& table, std::string_view key, std::array<std::string_view, 2> words) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return false;
    const auto word = node->value_exact<std::string>();
    if (word && (*word == words[0] || *word == words[1])) return *word == words[1];
    const std::string found = word ? fmt::format("\"{}\"", *word) : std::string(type_text(*node));
    report("machine-drive", node->source().begin, fmt::format("{} is {}", key, found),
           fmt::format("\"{}\" or \"{}\"", words[0], words[1]));
    return false;
  }

  /// An entry that is none keeps its place in the list, as no number.
  std::vector<machine::PitchError> pitch_errors(const toml::table& table, std::string_view key, base::Axis axis) {
    std::vector<machine::PitchError> errors;
    const toml::node* node = table.get(key);
    if (node == nullptr) return errors;
    if (!node->is_array()) {
      report("machine-type", node->source().begin, fmt::format("{} is {}, not a list", key, type_text(*node)),
             pitch_hint);
      return errors;
    }
    for (const toml::node& entry : *node->as_array()) {
      const std::size_t index = errors.size();
      const auto pair = pair_of(entry);
      if (pair) {
        positions_[fmt::format("{}.{}[{}]", section_of(axis), key, index)] = entry.source().begin;
      } else {
        report("machine-type", entry.source().begin, not_a_pair(fmt::format("entry {} of {}", index + 1, key), entry),
               pitch_hint);
      }
      errors.push_back(pair ? machine::PitchError{pair->front(), pair->back()} : machine::PitchError{NAN, NAN});
    }
    return errors;
  }

  /// Reports keys that are not known; returns the known ones that were probably meant.
  std::set<std::string_view> check_keys(const toml::table& table, std::span<const std::string_view> known,
                                        const std::string& section) {
    std::set<std::string_view> meant;
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      const auto suggestion = nearest(key.str(), known);
      const bool is_axis = section == "axis";
      report("machine-key", key.source().begin,
             is_axis ? fmt::format("axis \"{}\" is not known", key.str())
                     : fmt::format("key \"{}\" is not known", key.str()),
             suggestion && !is_axis ? fmt::format("did you mean {}?", *suggestion)
                                    : fmt::format("known here: {}", joined(known)));
      if (suggestion && !table.contains(*suggestion)) meant.insert(*suggestion);
      has_axis_ = has_axis_ || is_axis;
    }
    return meant;
  }

  std::optional<std::string> string(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    positions_[std::string(key)] = node->source().begin;
    const auto value = node->value_exact<std::string>();
    if (!value) {
      report("machine-type", node->source().begin, fmt::format("{} is {}, not a string", key, type_text(*node)),
             fmt::format("write {} = \"…\"", key));
    }
    return value;
  }

  std::optional<double> number(const toml::table& table, std::string_view key, const std::string& section) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    positions_[section.empty() ? std::string(key) : section + "." + std::string(key)] = node->source().begin;
    if (!node->is_number()) {
      report("machine-type", node->source().begin, fmt::format("{} is {}, not a number", key, type_text(*node)), "");
      return std::nullopt;
    }
    return node->value<double>();
  }

  std::optional<double> required(const toml::table& table, std::string_view key, base::Axis axis,
                                 const std::set<std::string_view>& misspelt) {
    if (!table.contains(key)) missing(table, key, axis, misspelt);
    return number(table, key, section_of(axis));
  }

  void missing(const toml::table& table, std::string_view key, base::Axis axis,
               const std::set<std::string_view>& misspelt) {
    if (misspelt.contains(key)) return;
    report("machine-missing", table.source().begin, fmt::format("[{}] lacks {}", section_of(axis), key),
           fmt::format("an axis gives {}", joined(keys_of(axis).needed())));
  }

  /// Whether the values make sense is for the room of machines to say; where they stand is known here.
  void judge() {
    for (base::Diagnostic problem : machine::validate(result_.machine)) {
      // An axis was meant, and what is wrong with it has been said.
      if (problem.code == "machine-axes" && has_axis_) continue;
      const auto found = positions_.find(slot_of(problem));
      // Of an entry that is none it has been said too.
      if (problem.code == "pitch-value" && found == positions_.end()) continue;
      if (problem.code == "machine-kinematics") improve_kinematics(problem);
      const Position position = found == positions_.end() ? Position{} : found->second;
      report(problem.code, position, std::move(problem.message), std::move(problem.hint));
    }
  }

  void improve_kinematics(base::Diagnostic& problem) const {
    const std::string_view given = result_.machine.kinematics;
    if (std::find(later_kinematics.begin(), later_kinematics.end(), given) != later_kinematics.end()) {
      problem.message = fmt::format("kinematics \"{}\" is not built yet", given);
      problem.hint = "built: cartesian";
    } else if (nearest(given, std::array<std::string_view, 1>{"cartesian"})) {
      problem.hint = "did you mean cartesian?";
    }
  }

  std::string_view text_;
  std::string file_;
  MachineFile result_;
  std::map<std::string, Position> positions_;  ///< of values, by slot (machine_keys.hpp)
  bool has_axis_ = false;                      ///< some axis was named that could not be taken
};

}  // namespace

MachineFile read_machine(std::string_view text, const std::string& file) {
  return MachineReader(text, file).read();
}

}  // namespace leadscrew::cli
