#include <array>
#include <cstdint>
#include <leadscrew/config/file_text.hpp>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/config/rotary_keys.hpp>
#include <span>

namespace leadscrew::config {

namespace {

namespace field = machine::field;
using base::Subject;

/// Three numbers; empty where it is anything else.
std::optional<machine::Vector> triple_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() != 3) return std::nullopt;
  machine::Vector triple{};
  for (std::size_t i = 0; i < triple.size(); ++i) {
    const auto number = (*list)[i].value<double>();
    if (!(*list)[i].is_number() || !number) return std::nullopt;
    triple[i] = *number;
  }
  return triple;
}

/// Reads single values over those of a preset.
class ChainReader {
 public:
  explicit ChainReader(const KeysTold& told) : told_(told) {}

  void take(const toml::table& table, std::string_view key, const Subject& subject, machine::Vector& value) {
    const toml::node* node = find(table, key, subject);
    if (node == nullptr) return;
    if (const auto triple = triple_of(*node)) {
      value = *triple;
      return;
    }
    const toml::array* list = node->as_array();
    const bool is_of_another_size = list != nullptr && list->size() != value.size();
    wrong_type(*node, is_of_another_size ? fmt::format("a list of {}", list->size()) : std::string(type_text(*node)),
               key, "a list of three numbers", "such as [0, 0, -50]");
  }

  void take(const toml::table& table, std::string_view key, const Subject& subject, std::int64_t& value) {
    const toml::node* node = find(table, key, subject);
    if (node == nullptr) return;
    if (const auto number = node->value_exact<std::int64_t>()) {
      value = *number;
      return;
    }
    wrong_type(*node, key, "a whole number", fmt::format("write {} = 1", key));
  }

  void take(const toml::table& table, std::string_view key, const Subject& subject, double& value) {
    const toml::node* node = find(table, key, subject);
    if (node == nullptr) return;
    const auto number = node->value<double>();
    if (node->is_number() && number) {
      value = *number;
      return;
    }
    wrong_type(*node, key, "a number that double precision holds", fmt::format("write {} = 0.05", key));
  }

  void take_carries(const toml::table& table, const Subject& subject, machine::Carries& value) {
    const toml::node* node = find(table, carries_key, subject);
    if (node == nullptr) return;
    const auto word = node->value_exact<std::string>();
    if (word == "workpiece") {
      value = machine::Carries::workpiece;
    } else if (word == "tool") {
      value = machine::Carries::tool;
    } else {
      const std::string found = word ? fmt::format("\"{}\"", shown(*word)) : std::string(type_text(*node));
      told_.problem("machine-carries", node->source().begin, fmt::format("{} is {}", carries_key, found),
                    "\"workpiece\" or \"tool\"");
    }
  }

 private:
  const toml::node* find(const toml::table& table, std::string_view key, const Subject& subject) {
    const toml::node* node = table.get(key);
    told_.place(subject, node == nullptr ? table.source().begin : node->source().begin);
    return node;
  }

  void wrong_type(const toml::node& node, std::string_view key, std::string_view right, std::string hint) {
    wrong_type(node, std::string(type_text(node)), key, right, std::move(hint));
  }
  void wrong_type(const toml::node& node, const std::string& found, std::string_view key, std::string_view right,
                  std::string hint) {
    told_.problem("machine-type", node.source().begin, fmt::format("{} is {}, not {}", key, found, right),
                  std::move(hint));
  }

  const KeysTold& told_;
};

const toml::table* axis_table(const toml::table& root, base::Axis axis) {
  const toml::node* axes = root.get("axis");
  const toml::table* table = axes == nullptr ? nullptr : axes->as_table();
  const toml::node* entry = table == nullptr ? nullptr : table->get(axis_names[base::index(axis)]);
  return entry == nullptr ? nullptr : entry->as_table();
}

/// Keys that stand where no chain of rotary axes could take them.
void report_useless(const toml::table& table, std::span<const std::string_view> keys, const std::string& why,
                    const KeysTold& told) {
  for (const std::string_view key : keys) {
    const toml::node* node = table.get(key);
    if (node == nullptr) continue;
    told.problem("machine-kinematics", node->source().begin, fmt::format("{} has no meaning {}", key, why),
                 "name a chain of rotary axes, such as kinematics = \"table-table-ac\", or leave the key out");
  }
}

void read_chain_axis(const toml::table& table, machine::RotaryAxis& axis, ChainReader& reader) {
  const auto subject = [&](std::string_view field) { return Subject{.axis = axis.axis, .field = field}; };
  reader.take_carries(table, subject(field::carries), axis.carries);
  reader.take(table, point_key, subject(field::point), axis.point);
  reader.take(table, direction_key, subject(field::direction), axis.direction);
  reader.take(table, order_key, subject(field::order), axis.order);
  reader.take(table, sign_key, subject(field::sign), axis.sign);
}

}  // namespace

std::optional<machine::RotaryChain> read_rotary_chain(const toml::table& root, std::string_view kinematics,
                                                      const KeysTold& told) {
  std::optional<machine::RotaryChain> chain = machine::preset_chain(kinematics);
  if (!chain && kinematics != machine::cartesian) return chain;  // which has been told
  const std::string why = fmt::format("with {} kinematics", kinematics);
  for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::C}) {
    const toml::table* table = axis_table(root, axis);
    const bool is_in_chain = chain && (chain->axes[0].axis == axis || chain->axes[1].axis == axis);
    if (table != nullptr && !is_in_chain) report_useless(*table, chain_axis_keys, why, told);
  }
  if (!chain) {
    report_useless(root, std::array{orientation_tolerance_key, pole_cone_key, geometry_key}, why, told);
    return chain;
  }
  ChainReader reader(told);
  for (machine::RotaryAxis& axis : chain->axes) {
    if (const toml::table* table = axis_table(root, axis.axis)) read_chain_axis(*table, axis, reader);
  }
  reader.take(root, orientation_tolerance_key, {.field = field::orientation_tolerance}, chain->orientation_tolerance);
  reader.take(root, pole_cone_key, {.field = field::pole_cone}, chain->pole_cone);
  const toml::node* geometry = root.get(geometry_key);
  if (geometry != nullptr && geometry->is_table()) {
    reader.take(*geometry->as_table(), tool_zero_key, {.field = field::tool_zero}, chain->tool_zero);
  }
  return chain;
}

}  // namespace leadscrew::config
