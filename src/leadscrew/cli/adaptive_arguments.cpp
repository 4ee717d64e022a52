#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/cli/simulate_arguments.hpp>
#include <memory>

namespace leadscrew::cli {

namespace {

/// As they are given; what of them depends on another is settled at the end.
struct GivenCut {
  bool asked_for = false;
  AdaptiveArguments adaptive;
  double cutting_coefficient = 2000;  ///< of steel
  double depth = 2, teeth = 4, spindle = 3000, seed = 1, noise = 5, limit = 0, width = 0;
  std::vector<servo::DepthStep> depths;
};

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

Parsed<std::optional<AdaptiveArguments>> settled(const GivenCut& given, const Command& command) {
  if (!given.asked_for) return std::optional<AdaptiveArguments>();
  AdaptiveArguments adaptive = given.adaptive;
  servo::AdaptiveCutOptions& cut = adaptive.cut;
  cut.milling.cutting_coefficient = given.cutting_coefficient;
  cut.milling.teeth = static_cast<int>(given.teeth);
  cut.milling.spindle_speed = given.spindle / 60;
  cut.milling.seed = static_cast<std::uint64_t>(given.seed);
  cut.width = command.given("--width") ? given.width : 0.4 * cut.milling.diameter;
  if (cut.width > cut.milling.diameter)
    return wrong("--width {}: give 0 to {:g}", command.text_of("--width"), cut.milling.diameter);
  cut.depths = given.depths;
  if (cut.depths.empty() || cut.depths.front().from > 0) cut.depths.insert(cut.depths.begin(), {0, given.depth});
  if (given.noise == 0 && cut.fault && cut.fault->kind == servo::SensorFailure::stuck)
    return wrong("--sensor-fault {}: shows by noise that is missing; give --noise above 0",
                 command.text_of("--sensor-fault"));
  if (command.given("--force-limit")) adaptive.limit = given.limit;
  adaptive.noise = given.noise / 100;
  return std::optional(adaptive);
}

}  // namespace

void add_adaptive(Command& command, Arguments& arguments) {
  // Lives as long as the command's options.
  const auto given = std::make_shared<GivenCut>();
  servo::AdaptiveCutOptions& cut = given->adaptive.cut;
  command.flag("--adaptive", "Hold the cutting force at a limit by the feed override; the cut is:", given->asked_for);
  // Kt, N/mm²: specific cutting force, as handbooks have it.
  command.choice<double>("--material", "NAME", "aluminium, cast-iron, steel (default) or titanium",
                         given->cutting_coefficient,
                         {{"aluminium", 800}, {"cast-iron", 1200}, {"steel", 2000}, {"titanium", 1700}});
  command.number("--depth", "MM", "Along the cutter's axis (default: 2)", given->depth, 0, 1000);
  command.value("--depth-steps", "S:MM,...", "Depths from places along the path on, in place of --depth", given->depths,
                steps_of);
  command.number("--width", "MM", "Across the cutter (default: 0.4 of its diameter)", given->width, 0, 1000);
  command.number("--teeth", "N", "Of the cutter (default: 4)", given->teeth, 1, 64);
  command.number("--diameter", "MM", "Of the cutter (default: 10)", cut.milling.diameter, 0.01, 1000);
  command.number("--spindle", "RPM", "Speed of the spindle (default: 3000)", given->spindle, 1, 300'000);
  command.number("--edge-force", "N/MM", "Of a mm of cutting edge that rubs (default: 0)", cut.milling.edge_coefficient,
                 0, 1e4);
  command.number("--force-limit", "N", "Of the mean force (default: of the first depth at the greatest feed)",
                 given->limit, 0.001, 1e6);
  command.number("--noise", "PERCENT", "Of the sensor, in % of the limit, 0 for an ideal one (default: 5)",
                 given->noise, 0, 100);
  command.number("--seed", "N", "Of the noise (default: 1)", given->seed, 0, 1e15);
  command.number("--safe-factor", "SHARE", "Of the programmed feed, once the sensor has failed (default: 0.5)",
                 cut.safe, 0.01, 1);
  command.value("--sensor-fault", "KIND@S", "nan, stuck or silent from a time on, such as stuck@1.5", cut.fault,
                fault_of);
  command.only_with("--adaptive",
                    {"--material", "--depth", "--depth-steps", "--width", "--teeth", "--diameter", "--spindle",
                     "--edge-force", "--force-limit", "--noise", "--seed", "--safe-factor", "--sensor-fault"});
  command.check([&command, &arguments, given]() -> Parsed<void> {
    auto adaptive = settled(*given, command);
    if (!adaptive) return tl::unexpected(adaptive.error());
    arguments.simulate.adaptive = std::move(*adaptive);
    return {};
  });
}

}  // namespace leadscrew::cli
