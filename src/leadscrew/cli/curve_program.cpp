#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/study/named_curves.hpp>
#include <vector>

namespace leadscrew::cli {

namespace {

auto wrong_curve(std::string message) {
  return tl::unexpected<std::string>(std::move(message));
}

std::string no_curve(std::string_view name) {
  std::vector<std::string_view> known;
  for (const study::NamedCurve& curve : study::named_curves()) known.push_back(curve.name);
  return fmt::format("no curve \"{}\" among {}{}; a file is given as ./{}{}", name, fmt::join(known, ", "),
                     base::did_you_mean(name, known), curve_prefix, name);
}

}  // namespace

Parsed<study::PartProgram> curve_program(std::string_view program) {
  const std::string_view asked = program.substr(curve_prefix.size());
  const std::size_t at = asked.find('@');
  const std::string_view name = asked.substr(0, at);
  const auto curves = study::named_curves();
  const auto curve = std::find_if(curves.begin(), curves.end(), [&](const auto& each) { return each.name == name; });
  if (curve == curves.end()) return wrong_curve(no_curve(name));
  if (at == std::string_view::npos) return curve->program(curve->feed);
  const auto feed = parse_number(asked.substr(at + 1));
  if (!feed || !(*feed > 0))
    return wrong_curve(fmt::format("{}: behind @ stands a feed in mm/s, above 0, such as {}{}@{}", program,
                                   curve_prefix, curve->name, curve->feed));
  return curve->program(*feed);
}

std::string curves_text() {
  std::vector<std::string> curves;
  for (const study::NamedCurve& curve : study::named_curves())
    curves.push_back(fmt::format("{} ({} mm/s)", curve.name, curve.feed));
  return fmt::format(
      "\nPROGRAM may be a curve of the studies: {0}NAME, or {0}NAME@FEED in mm/s. It brings its start along, so "
      "--start "
      "is\nof files alone. There are {1}.\n"
      "A file of such a name is given as ./{0}NAME.\n",
      curve_prefix, fmt::join(curves, ", "));
}

}  // namespace leadscrew::cli
