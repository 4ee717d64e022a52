#include <algorithm>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/cli/simulate_arguments.hpp>
#include <leadscrew/config/drive_help.hpp>
#include <leadscrew/trace/word_writer.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view simulate_examples =
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
    "A trace holds the words, on until the slides stand, and behind them for each axis, at the word's t:\n"
    "  actual_X    where the slide was, mm\n"
    "  velocity_X  of the screw, by its tachometer, mm/s\n"
    "  control_X   what the controller gives the drive from then on: mm/s² of a cascade, units of a PID, with "
    "--pulses\n"
    "              counts of the up-down counter\n"
    "  current_X   of the motor, as the acceleration that it gives, mm/s²; of a rotary axis all in degrees\n"
    "Exit status 1: slides left the\n"
    "tolerance (the program's, the machine's where that is greater), do not come to rest, or the force is beyond 1.25\n"
    "limits for longer than two turns and 150 ms; 3: a loop is not stable.\n";

Parsed<servo::PidGains> parse_gains(std::string_view text) {
  const auto values = parse_numbers(text);
  if (!values) return tl::unexpected(values.error());
  if (std::ranges::any_of(*values, [](double value) { return value < 0; })) return wrong("gains are 0 or more");
  if (values->size() != 3) return wrong("give three gains: P,I,D");
  return servo::PidGains{(*values)[0], (*values)[1], (*values)[2]};
}

}  // namespace

void describe_simulate(Command& command, Arguments& arguments) {
  SimulateArguments& simulate = arguments.simulate;
  command.words("PROGRAM", programs_help, arguments.programs, program_values());
  add_common(command, arguments);
  add_period(command, arguments);
  add_motion(command, arguments);
  command.value("--gains", "P,I,D",
                "PID in every axis: u = P e + I T sum(e) + D (e - last e), in place of the machine's controllers",
                simulate.gains, parse_gains);
  command.choice<bool>("--feed-forward", "WHETHER", "on or off, of velocity and acceleration", simulate.feed_forward,
                       {{"on", true}, {"off", false}});
  command.flag("--pulses", "Steps through pulse-driven loops, in place of words", simulate.pulses);
  add_adaptive(command, arguments);
  command.output("--trace", "FILE", "Write words and slides: " + trace::endings_text(), arguments.run.trace,
                 trace_endings());
  add_pages(command, arguments);
  add_threads(command, arguments);
  command.check([&command, &simulate]() -> Parsed<void> {
    const std::string_view of_words = command.first_given({"--gains", "--feed-forward"});
    if (!simulate.pulses || of_words.empty()) return {};
    return wrong("{} is of loops that follow words; with --pulses the gain is position_gain_per_s", of_words);
  });
  command.help(std::string(simulate_examples) + "\n" + std::string(config::drive_help) + curves_text());
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

}  // namespace leadscrew::cli
