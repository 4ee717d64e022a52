#include <fmt/format.h>

#include <leadscrew/cli/drive_arguments.hpp>

namespace leadscrew::cli {

namespace {

/// 100ms, 0.3s or 0.3.
Parsed<double> parse_seconds(std::string_view text, double least, double greatest) {
  std::string_view number = text;
  double unit = 1;
  if (number.ends_with("ms")) {
    number.remove_suffix(2);
    unit = 1e-3;
  } else if (number.ends_with("s")) {
    number.remove_suffix(1);
  }
  const auto value = parse_number(number);
  if (value && *value * unit >= least && *value * unit <= greatest) return *value * unit;
  return tl::unexpected<std::string>(fmt::format("is no time from {:g} s to {:g} s, such as 250ms", least, greatest));
}

}  // namespace

Parsed<drive::Options> parse_drive(const DriveTexts& texts) {
  constexpr double least_look_ahead = 0.01, longest_look_ahead = 60, longest_lead = 2;
  drive::Options drive;
  drive.trace = texts.trace;
  drive.axes = texts.axes;
  drive.state = texts.state ? texts.state : texts.resume;
  drive.resume = texts.resume;
  drive.sink = texts.sink;
  if (texts.sink && (texts.trace || texts.axes)) {
    return tl::unexpected(fmt::format("{} is of simulated drives; with --sink the words are in its file",
                                      texts.trace ? "--trace" : "--axes"));
  }
  if (texts.look_ahead) {
    const auto value = parse_seconds(*texts.look_ahead, least_look_ahead, longest_look_ahead);
    if (!value) return tl::unexpected(fmt::format("--look-ahead {}: {}", *texts.look_ahead, value.error()));
    drive.look_ahead = *value;
  }
  if (texts.lead) {
    const auto value = parse_seconds(*texts.lead, 0, longest_lead);
    if (!value) return tl::unexpected(fmt::format("--lead {}: {}", *texts.lead, value.error()));
    drive.lead = *value;
  }
  return drive;
}

}  // namespace leadscrew::cli
