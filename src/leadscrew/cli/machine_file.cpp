#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <leadscrew/cli/machine_file.hpp>
#include <leadscrew/cli/nearest.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace leadscrew::cli {

namespace {

constexpr std::array<std::string_view, 6> machine_keys = {"name",         "kinematics",     "period_us",
                                                          "tolerance_mm", "chord_error_mm", "axis"};

struct AxisKeys {
  std::string_view travel, velocity, acceleration, jerk, blu;

  std::array<std::string_view, 5> all() const { return {travel, velocity, acceleration, jerk, blu}; }
};

constexpr AxisKeys linear_keys = {"travel_mm", "max_velocity_mm_s", "max_acceleration_mm_s2", "max_jerk_mm_s3",
                                  "blu_mm"};
constexpr AxisKeys rotary_keys = {"travel_deg", "max_velocity_deg_s", "max_acceleration_deg_s2", "max_jerk_deg_s3",
                                  "blu_deg"};

constexpr const AxisKeys& keys_of(base::Axis axis) {
  return base::is_rotary(axis) ? rotary_keys : linear_keys;
}

constexpr std::array<std::string_view, base::axis_count> axis_names = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};

/// Named by the contract, and not yet more than names.
constexpr std::array<std::string_view, 6> later_kinematics = {"table-table-ac", "table-table-bc", "head-head-bc",
                                                              "head-head-ac",   "head-b-table-c", "head-b-table-a"};

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
    std::stable_sort(result_.diagnostics.begin(), result_.diagnostics.end(),
                     [](auto& a, auto& b) { return a.place.line < b.place.line; });
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
      machine.period = base::Period{std::llround(std::clamp(*period, -1e9, 1e9) * 1e3)};
      if (std::isnan(*period)) machine.period = base::Period{0};
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
    const std::string section = fmt::format("axis.{}", base::letter(axis));
    const std::set<std::string_view> misspelt = check_keys(table, keys.all(), section);
    positions_[section] = table.source().begin;
    // What is missing or wrong has been reported; a sound value in its place keeps machine::validate() from doing so
    // again.
    machine::AxisLimits limits{
        .travel_min = -1, .travel_max = 1, .velocity = 1, .acceleration = 1, .jerk = 1, .blu = 1};
    const auto take = [&](std::string_view key, double& value) {
      if (const auto given = required(table, key, section, misspelt)) value = *given;
    };
    take(keys.velocity, limits.velocity);
    take(keys.acceleration, limits.acceleration);
    take(keys.jerk, limits.jerk);
    take(keys.blu, limits.blu);
    read_travel(table, keys.travel, section, misspelt, limits);
    result_.machine.axes[base::index(axis)] = limits;
  }

  void read_travel(const toml::table& table, std::string_view key, const std::string& section,
                   const std::set<std::string_view>& misspelt, machine::AxisLimits& limits) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return missing(table, key, section, misspelt);
    const toml::array* pair = node->as_array();
    const bool is_pair = pair != nullptr && pair->size() == 2 && (*pair)[0].is_number() && (*pair)[1].is_number();
    if (!is_pair) {
      report("machine-type", node->source().begin,
             pair != nullptr ? fmt::format("{} is a list, but not of two numbers", key)
                             : fmt::format("{} is {}, not a list of two numbers", key, type_text(*node)),
             "such as [-500, 500]");
      return;
    }
    positions_[section + "." + std::string(key)] = node->source().begin;
    limits.travel_min = *(*pair)[0].value<double>();
    limits.travel_max = *(*pair)[1].value<double>();
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

  std::optional<double> required(const toml::table& table, std::string_view key, const std::string& section,
                                 const std::set<std::string_view>& misspelt) {
    if (!table.contains(key)) missing(table, key, section, misspelt);
    return number(table, key, section);
  }

  void missing(const toml::table& table, std::string_view key, const std::string& section,
               const std::set<std::string_view>& misspelt) {
    if (misspelt.contains(key)) return;
    report("machine-missing", table.source().begin, fmt::format("[{}] lacks {}", section, key),
           fmt::format("an axis gives {}", joined(keys_of(axis_of(section)).all())));
  }

  static base::Axis axis_of(std::string_view section) {
    const auto name = std::find(axis_names.begin(), axis_names.end(), section.substr(section.size() - 1));
    return base::all_axes[static_cast<std::size_t>(name - axis_names.begin())];
  }

  /// Whether the values make sense is for the room of machines to say; where they stand is known here.
  void judge() {
    for (base::Diagnostic problem : machine::validate(result_.machine)) {
      // An axis was meant, and what is wrong with it has been said.
      if (problem.code == "machine-axes" && has_axis_) continue;
      if (problem.code == "machine-kinematics") improve_kinematics(problem);
      const Position position = position_of(problem);  // reads the message, which is given away below
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

  Position position_of(const base::Diagnostic& problem) const {
    const auto found = positions_.find(slot_of(problem));
    return found == positions_.end() ? Position{} : found->second;
  }

  /// The key that a problem of machine::validate() is about.
  static std::string slot_of(const base::Diagnostic& problem) {
    if (problem.code == "machine-kinematics") return "kinematics";
    if (problem.code == "machine-period") return "period_us";
    if (problem.code == "machine-tolerance") return "tolerance_mm";
    if (problem.code == "machine-chord-error") return "chord_error_mm";
    constexpr std::string_view opening = "axis ";
    if (!problem.message.starts_with(opening) || problem.message.size() <= opening.size()) return {};
    const std::string section = std::string("axis.") + problem.message[opening.size()];
    const AxisKeys& keys = keys_of(axis_of(section));
    const auto says = [&](std::string_view word) { return problem.message.find(word) != std::string::npos; };
    if (problem.code == "machine-travel") return fmt::format("{}.{}", section, keys.travel);
    if (says("velocity")) return fmt::format("{}.{}", section, keys.velocity);
    if (says("acceleration")) return fmt::format("{}.{}", section, keys.acceleration);
    if (says("jerk")) return fmt::format("{}.{}", section, keys.jerk);
    return fmt::format("{}.{}", section, keys.blu);
  }

  std::string_view text_;
  std::string file_;
  MachineFile result_;
  std::map<std::string, Position> positions_;  ///< of values, by "axis.X.key" or "key"
  bool has_axis_ = false;                      ///< some axis was named that could not be taken
};

}  // namespace

MachineFile read_machine(std::string_view text, const std::string& file) {
  return MachineReader(text, file).read();
}

}  // namespace leadscrew::cli
