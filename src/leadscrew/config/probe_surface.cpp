#include <cmath>
#include <filesystem>
#include <leadscrew/config/load_text.hpp>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/config/probe_surface.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/surfaces/bezier_nets.hpp>
#include <optional>

namespace leadscrew::config {

namespace {

using Forms = std::vector<std::shared_ptr<const surfaces::SurfaceForm>>;

constexpr const char* surface_hint = "a file of G6.4 blocks beside the machine file, such as \"face.ngc\"";
constexpr const char* at_hint = "a list of three numbers, such as [0, 0, -20]";

/// Where the surface's origin lies; the machine's where nothing is said.
std::optional<machine::Vector> read_place(const toml::table& table, const KeysTold& told) {
  const toml::node* node = table.get(probe_surface_at_key);
  machine::Vector place{};
  if (node == nullptr) return place;
  const toml::array* list = node->as_array();
  bool is_sound = list != nullptr && list->size() == place.size();
  for (std::size_t i = 0; is_sound && i < place.size(); ++i) {
    const auto number = (*list)[i].is_number() ? (*list)[i].value<double>() : std::nullopt;
    is_sound = number && std::abs(*number) <= 1e9;
    if (is_sound) place[i] = *number;
  }
  if (is_sound) return place;
  told.problem("machine-type", node->source().begin, fmt::format("{} is not a place", probe_surface_at_key), at_hint);
  return std::nullopt;
}

/// Room for whatever stands in the file beside its surfaces.
machine::Machine wide_machine() {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : base::all_axes)
    machine.axes[base::index(axis)] = {
        .travel_min = -1e9, .travel_max = 1e9, .velocity = 1, .acceleration = 1, .jerk = 1, .blu = 1};
  return machine;
}

/// The surfaces of a text; none where it has an error, of which the first is `problem`.
Forms surfaces_in(std::string_view text, std::string& problem) {
  const machine::Machine machine = wide_machine();
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& each) {
    if (each.severity == base::Severity::error && problem.empty())
      problem = fmt::format("line {}: {}", each.place.line, each.message);
  });
  gcode::Move move;
  while (reader.next(move)) {
  }
  return reader.errors() == 0 ? reader.surfaces() : Forms{};
}

}  // namespace

std::vector<machine::ProbePatch> read_probe_surface(const toml::table& table, const std::string& machine_file,
                                                    const KeysTold& told) {
  const std::optional<machine::Vector> place = read_place(table, told);
  const toml::node* node = table.get(probe_surface_key);
  if (node == nullptr) return {};
  const auto name = node->value_exact<std::string>();
  const toml::source_position at = node->source().begin;
  if (!name) {
    told.problem("machine-type", at, fmt::format("{} is {}, not a file", probe_surface_key, type_text(*node)),
                 surface_hint);
    return {};
  }
  const std::string path = (std::filesystem::path(machine_file).parent_path() / *name).string();
  const auto text = load_text(path, largest_surface_file + 1);
  const bool is_larger = text && text->size() > largest_surface_file;
  std::string problem = !text ? text.error().message : is_larger ? "is larger than 16 MiB" : "";
  const Forms forms = problem.empty() ? surfaces_in(*text, problem) : Forms{};
  if (forms.empty()) {
    told.problem("machine-probe-surface", at,
                 fmt::format("{}: {}", path, problem.empty() ? "defines no surface" : problem), surface_hint);
    return {};
  }
  std::vector<machine::ProbePatch> patches;
  for (const auto& form : forms) {
    for (auto& net : surfaces::bezier_nets(*form)) {
      for (std::array<double, 4>& point : net) {
        for (std::size_t i = 0; place && i < 3; ++i) point[i] += (*place)[i];
      }
      patches.push_back({form->degree, std::move(net)});
    }
  }
  return patches;
}

}  // namespace leadscrew::config
