#include <fmt/format.h>

#include <leadscrew/config/drive_help.hpp>
#include <leadscrew/cli/simulate_arguments.hpp>
#include <vector>

namespace leadscrew::cli {

namespace {

constexpr std::string_view examples =
    "Examples:\n"
    "  leadscrew simulate part.ngc\n"
    "  leadscrew simulate curve:plane-cubic --gains 2,2,15 --period 10ms   a published curve under published gains\n"
    "  leadscrew simulate part.ngc --feed-forward off --trace followed.csv\n"
    "  leadscrew simulate part.ngc --adaptive --depth-steps 0:2,40:4 --force-limit 400\n"
    "  leadscrew simulate part.ngc --adaptive --sensor-fault stuck@1.5\n"
    "\n"
    "With --pulses steps that follow the words count an up-down counter in every axis, and encoder pulses count it\n"
    "back; it drives the motor. Of the keys of drives position_gain_per_s and time_constant_ms hold [a fourth of "
    "1/Kv],\n"
    "and an encoder pulse is a BLU.\n"
    "With --adaptive a milling force is reckoned of the feed that the tachometers tell, and the feed override, 5 to\n"
    "200 %, holds its mean at the limit; when the sensor fails, the programmed feed times the safe factor is gone,\n"
    "and a warning, force-sensor, says so. A sensor is stuck when 20 samples are alike to the last bit. An ideal one,\n"
    "--noise 0, may well say the same for longer, in air or between teeth, and is never taken for stuck.\n"
    "Depths are from places along the path on, S:DEPTH in mm. Rapid motion does not cut.\n"
    "A trace holds the words, and in columns actual_X, … where the slides were. Exit status 1: slides left the\n"
    "tolerance (the program's, the machine's where that is greater), do not come to rest, or the force is beyond 1.25\n"
    "limits for longer than two turns and 150 ms; 3: a loop is not stable.\n";

Parsed<servo::PidGains> parse_gains(std::string_view text) {
  std::vector<double> values;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const auto value = parse_number(rest.substr(0, comma));
    if (!value) return tl::unexpected(value.error());
    if (*value < 0) return tl::unexpected<std::string>("gains are 0 or more");
    values.push_back(*value);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (values.size() != 3) return tl::unexpected<std::string>("give three gains: P,I,D");
  return servo::PidGains{values[0], values[1], values[2]};
}

}  // namespace

Parsed<SimulateArguments> parse_simulate(const SimulateTexts& texts) {
  SimulateArguments simulate;
  if (texts.gains) {
    const auto gains = parse_gains(*texts.gains);
    if (!gains) return tl::unexpected(fmt::format("--gains {}: {}", *texts.gains, gains.error()));
    simulate.gains = *gains;
  }
  if (texts.feed_forward) {
    if (*texts.feed_forward != "on" && *texts.feed_forward != "off")
      return tl::unexpected(fmt::format("--feed-forward {}: is neither on nor off", *texts.feed_forward));
    simulate.feed_forward = *texts.feed_forward == "on";
  }
  simulate.pulses = texts.pulses;
  if (texts.pulses && (texts.gains || texts.feed_forward)) {
    return tl::unexpected(fmt::format("{} is of loops that follow words; with --pulses the gain is position_gain_per_s",
                                      texts.gains ? "--gains" : "--feed-forward"));
  }
  auto adaptive = parse_adaptive(texts.adaptive);
  if (!adaptive) return tl::unexpected(adaptive.error());
  simulate.adaptive = std::move(*adaptive);
  return simulate;
}

void SimulateArguments::put_into(machine::Machine& machine) const {
  for (machine::AxisDrive& drive : machine.drives) {
    if (gains) {
      drive.controller = machine::AxisDrive::Controller::pid;
      drive.proportional = gains->proportional;
      drive.integral = gains->integral;
      drive.derivative = gains->derivative;
    }
    if (feed_forward || gains)
      drive.velocity_forward = drive.acceleration_forward = feed_forward.value_or(false) ? 1 : 0;
  }
}

std::string simulate_help() {
  return std::string(examples) + "\n" + std::string(config::drive_help);
}

}  // namespace leadscrew::cli
