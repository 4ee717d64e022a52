#include <fmt/format.h>

#include <array>
#include <leadscrew/cli/simulate_arguments.hpp>

namespace leadscrew::cli {

namespace {

template <class... Values>
auto wrong(fmt::format_string<Values...> text, Values&&... values) {
  return tl::unexpected<std::string>(fmt::format(text, std::forward<Values>(values)...));
}

struct Material {
  std::string_view name;
  double cutting_coefficient;  ///< Kt, N/mm²: specific cutting force, as handbooks have it
};
constexpr std::array<Material, 4> materials = {
    {{"aluminium", 800}, {"cast-iron", 1200}, {"steel", 2000}, {"titanium", 1700}}};

/// A number with its option, in a range.
struct Number {
  std::string_view option;
  const std::optional<std::string>& text;
  double least, most;
};

Parsed<void> take(const Number& number, double& target) {
  if (!number.text) return {};
  const auto value = parse_number(*number.text);
  if (!value) return wrong("{} {}: {}", number.option, *number.text, value.error());
  if (*value < number.least || *value > number.most)
    return wrong("{} {}: give {:g} to {:g}", number.option, *number.text, number.least, number.most);
  target = *value;
  return {};
}

Parsed<double> material_of(const std::optional<std::string>& text) {
  for (const Material& material : materials) {
    if (text.value_or("steel") == material.name) return material.cutting_coefficient;
  }
  return wrong("--material {}: is none of aluminium, cast-iron, steel, titanium", *text);
}

Parsed<std::vector<servo::DepthStep>> steps_of(std::string_view text) {
  std::vector<servo::DepthStep> steps;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(','), colon = rest.substr(0, comma).find(':');
    if (colon == std::string_view::npos) return wrong("write PLACE:DEPTH, such as 0:2,40:4");
    const auto from = parse_number(rest.substr(0, colon));
    const auto depth = parse_number(rest.substr(0, comma).substr(colon + 1));
    if (!from || !depth) return wrong("write PLACE:DEPTH in mm, such as 0:2,40:4");
    if (*from < 0 || *depth < 0) return wrong("places and depths are 0 or more");
    if (!steps.empty() && *from <= steps.back().from) return wrong("places rise");
    steps.push_back({*from, *depth});
    if (comma == std::string_view::npos) return steps;
    rest.remove_prefix(comma + 1);
  }
}

Parsed<servo::SensorFault> fault_of(std::string_view text) {
  const std::size_t at = text.find('@');
  const auto time = at == std::string_view::npos ? Parsed<double>(0.0) : parse_number(text.substr(at + 1));
  if (!time || *time < 0) return wrong("write the time in seconds, such as stuck@1.5");
  const std::string_view kind = text.substr(0, at);
  if (kind == "nan") return servo::SensorFault{servo::SensorFailure::not_a_number, *time};
  if (kind == "stuck") return servo::SensorFault{servo::SensorFailure::stuck, *time};
  if (kind == "silent") return servo::SensorFault{servo::SensorFailure::silent, *time};
  return wrong("is none of nan, stuck, silent");
}

/// The first of the options that are given, where --adaptive is not.
Parsed<void> check_asked_for(const AdaptiveTexts& texts) {
  if (texts.asked_for) return {};
  for (const auto& [option, text] : {std::pair("--material", &texts.material),
                                     {"--depth", &texts.depth},
                                     {"--depth-steps", &texts.depth_steps},
                                     {"--width", &texts.width},
                                     {"--teeth", &texts.teeth},
                                     {"--diameter", &texts.diameter},
                                     {"--spindle", &texts.spindle},
                                     {"--edge-force", &texts.edge_force},
                                     {"--force-limit", &texts.force_limit},
                                     {"--noise", &texts.noise},
                                     {"--seed", &texts.seed},
                                     {"--safe-factor", &texts.safe_factor},
                                     {"--sensor-fault", &texts.sensor_fault}}) {
    if (*text) return wrong("{} is of --adaptive, which is missing", option);
  }
  return {};
}

}  // namespace

Parsed<std::optional<AdaptiveArguments>> parse_adaptive(const AdaptiveTexts& texts) {
  if (auto asked = check_asked_for(texts); !asked) return tl::unexpected(asked.error());
  if (!texts.asked_for) return std::optional<AdaptiveArguments>();
  AdaptiveArguments adaptive;
  servo::AdaptiveCutOptions& cut = adaptive.cut;
  double depth = 2, teeth = 4, spindle = 3000, seed = 1, noise = 5, limit = 0;
  const auto material = material_of(texts.material);
  if (!material) return tl::unexpected(material.error());
  cut.milling.cutting_coefficient = *material;
  for (const Parsed<void>& taken :
       {take({"--depth", texts.depth, 0, 1000}, depth), take({"--teeth", texts.teeth, 1, 64}, teeth),
        take({"--diameter", texts.diameter, 0.01, 1000}, cut.milling.diameter),
        take({"--spindle", texts.spindle, 1, 300'000}, spindle),
        take({"--edge-force", texts.edge_force, 0, 1e4}, cut.milling.edge_coefficient),
        take({"--force-limit", texts.force_limit, 0.001, 1e6}, limit), take({"--noise", texts.noise, 0, 100}, noise),
        take({"--seed", texts.seed, 0, 1e15}, seed), take({"--safe-factor", texts.safe_factor, 0.01, 1}, cut.safe)}) {
    if (!taken) return tl::unexpected(taken.error());
  }
  cut.width = 0.4 * cut.milling.diameter;
  if (auto taken = take({"--width", texts.width, 0, cut.milling.diameter}, cut.width); !taken)
    return tl::unexpected(taken.error());
  cut.milling.teeth = static_cast<int>(teeth);
  cut.milling.spindle_speed = spindle / 60;
  cut.milling.seed = static_cast<std::uint64_t>(seed);
  cut.depths = {{0, depth}};
  if (texts.depth_steps) {
    auto steps = steps_of(*texts.depth_steps);
    if (!steps) return wrong("--depth-steps {}: {}", *texts.depth_steps, steps.error());
    if (steps->front().from > 0) steps->insert(steps->begin(), {0, depth});
    cut.depths = std::move(*steps);
  }
  if (texts.sensor_fault) {
    const auto fault = fault_of(*texts.sensor_fault);
    if (!fault) return wrong("--sensor-fault {}: {}", *texts.sensor_fault, fault.error());
    cut.fault = *fault;
  }
  if (noise == 0 && cut.fault && cut.fault->kind == servo::SensorFailure::stuck)
    return wrong("--sensor-fault {}: shows by noise that is missing; give --noise above 0", *texts.sensor_fault);
  if (texts.force_limit) adaptive.limit = limit;
  adaptive.noise = noise / 100;
  return std::optional(adaptive);
}

}  // namespace leadscrew::cli
