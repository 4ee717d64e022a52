#include <CLI/CLI.hpp>
#include <array>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/nc/pulse_method.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view check_examples =
    "Examples:\n"
    "  leadscrew check part.ngc\n"
    "  leadscrew check *.ngc --machine machines/mill6.toml --json\n";

constexpr std::string_view verify_examples =
    "Examples:\n"
    "  leadscrew verify part.csv part.ngc\n"
    "  leadscrew verify other-controller.csv part.ngc --machine machines/heavy3.toml --period 1ms --json\n"
    "\n"
    "TRACE is CSV with columns t and axis letters, or NPY. Without --period its rows must be evenly spaced in t.\n";

constexpr std::string_view study_examples =
    "Examples:\n"
    "  leadscrew study list                       what there is\n"
    "  leadscrew study butterfly\n"
    "  leadscrew study feed-fluctuation --json    rows of what, published, ours, unit, verdict and why\n"
    "  leadscrew study real-time-vs-offline --picture feeds.svg\n";

void add_output(CLI::App& command, Arguments& arguments, Texts& texts) {
  command.add_flag("--json", arguments.json, "One JSON object on standard output, nothing else there");
  command.add_flag("--quiet", arguments.quiet, "No summary and no progress bar");
  command.add_option("--color", texts.color, "auto, always or never; NO_COLOR is heeded")->type_name("WHEN");
}

void add_common(CLI::App& command, Arguments& arguments, Texts& texts) {
  command.add_option("--machine", arguments.machine, "Machine file (TOML), or the built-in mill3 (default)")
      ->type_name("FILE");
  command.add_option("--tools", arguments.tools, "Tool table, in LinuxCNC's format")->type_name("FILE");
  command
      .add_option("--start", texts.start,
                  "Where a program of a file begins, machine coordinates: X10,Y5 or 10,5,0 (default: 0)")
      ->type_name("X0,Y0,...");
  add_output(command, arguments, texts);
}

void add_threads(CLI::App& command, Arguments& arguments) {
  constexpr int most_threads = 1024;
  command.add_option("--threads", arguments.threads, "Work on so many programs at a time (default: one a processor)")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads));
}

void add_period(CLI::App& command, Texts& texts) {
  command.add_option("--period", texts.period, "Servo period, such as 1ms or 250us, in place of the machine's")
      ->type_name("TIME");
}

/// What is made to look at.
void add_pages(CLI::App& command, RunTexts& texts) {
  command.add_option("--report", texts.report, "Write one self-contained page")->type_name("FILE.html");
  command.add_option("--picture", texts.picture, "Write the path alone, coloured by speed")->type_name("FILE.svg");
  command.add_option("--out", texts.out, "Write DIR/NAME.csv, .html and .svg of each program")->type_name("DIR");
}

void add_motion(CLI::App& command, Texts& texts) {
  command.add_option("--mode", texts.mode, "exact-stop or blend, in place of G61, G61.1 and G64")->type_name("MODE");
  command.add_option("--tolerance", texts.tolerance, "In place of P of G64 and the machine's, mm")->type_name("MM");
}

void add_adaptive(CLI::App& simulate, AdaptiveTexts& texts) {
  simulate.add_flag("--adaptive", texts.asked_for,
                    "Hold the cutting force at a limit by the feed override; the cut is:");
  const auto add = [&](const char* name, std::optional<std::string>& text, const char* what, const char* unit) {
    simulate.add_option(name, text, what)->type_name(unit);
  };
  add("--material", texts.material, materials_there_are, "NAME");
  add("--depth", texts.depth, "Along the cutter's axis (default: 2)", "MM");
  add("--depth-steps", texts.depth_steps, "Depths from places along the path on, in place of --depth", "S:MM,...");
  add("--width", texts.width, "Across the cutter (default: 0.4 of its diameter)", "MM");
  add("--teeth", texts.teeth, "Of the cutter (default: 4)", "N");
  add("--diameter", texts.diameter, "Of the cutter (default: 10)", "MM");
  add("--spindle", texts.spindle, "Speed of the spindle (default: 3000)", "RPM");
  add("--edge-force", texts.edge_force, "Of a mm of cutting edge that rubs (default: 0)", "N/MM");
  add("--force-limit", texts.force_limit, "Of the mean force (default: of the first depth at the greatest feed)", "N");
  add("--noise", texts.noise, "Of the sensor, in % of the limit, 0 for an ideal one (default: 5)", "PERCENT");
  add("--seed", texts.seed, "Of the noise (default: 1)", "N");
  add("--safe-factor", texts.safe_factor, "Of the programmed feed, once the sensor has failed (default: 0.5)", "SHARE");
  add("--sensor-fault", texts.sensor_fault, "nan, stuck or silent from a time on, such as stuck@1.5", "KIND@S");
}

}  // namespace

CLI::App* add_run(CLI::App& app, Arguments& arguments, Texts& all) {
  RunTexts& texts = all.run;
  CLI::App* run = app.add_subcommand("run", "Plan and interpolate; summary, report, picture, traces, steps");
  run->add_option("PROGRAM", arguments.programs,
                  "Part programs; - is standard input, curve:NAME a curve of the studies")
      ->required()
      ->type_name("");
  add_common(*run, arguments, all);
  add_period(*run, all);
  add_motion(*run, all);
  run->add_option("--interpolator", texts.interpolator,
                  "Parameter steps along curves: arc-length (default), taylor1, taylor2, newton or uniform")
      ->type_name("RULE");
  run->add_option("--trace", texts.trace, "Write the words: .csv or .npy")->type_name("FILE");
  run->add_option("--pulses", texts.pulses,
                  "Write steps and directions: .vcd or .csv; beside --out vcd or csv, for DIR/NAME.steps.vcd")
      ->type_name("FILE");
  run->add_option("--pulse-method", texts.pulse_method,
                  "Of --pulses: by an interpolator of the papers, not steps that follow the words: " +
                      names_of_pulse_methods() + "; here dda too has capacity R or L and begins half full")
      ->type_name("NAME");
  run->add_flag(
      "--accelerate", texts.accelerate,
      "Of --pulse-method: feed rises and falls as the axes can; else one that an axis cannot make is refused");
  run->add_option("--step-clock", texts.step_clock, "Of --pulses: 10kHz to 10MHz (default 1MHz)")->type_name("HZ");
  constexpr std::array<const char*, 4> step_times = {
      "Of --pulses: least length of a step, such as 2.5us, in place of the machine's",
      "Of --pulses: least time between two steps of an axis, likewise",
      "Of --pulses: least time from a change of direction to the next step, likewise",
      "Of --pulses: least time from the end of a step to a change of direction, likewise"};
  for (std::size_t k = 0; k < step_times.size(); ++k)
    run->add_option(step_time_options[k], texts.step_times[k], step_times[k])->type_name("TIME");
  add_pages(*run, texts);
  add_threads(*run, arguments);
  run->footer(std::string(run_examples) + curves_text());
  return run;
}

CLI::App* add_simulate(CLI::App& app, Arguments& arguments, Texts& all) {
  CLI::App* simulate =
      app.add_subcommand("simulate", "Words through simulated loops of all axes: errors of the slides");
  simulate
      ->add_option("PROGRAM", arguments.programs,
                   "Part programs; - is standard input, curve:NAME a curve of the studies")
      ->required()
      ->type_name("");
  add_common(*simulate, arguments, all);
  add_period(*simulate, all);
  add_motion(*simulate, all);
  simulate
      ->add_option("--gains", all.simulate.gains,
                   "PID in every axis: u = P e + I T sum(e) + D (e - last e), in place of the machine's controllers")
      ->type_name("P,I,D");
  simulate->add_option("--feed-forward", all.simulate.feed_forward, "on or off, of velocity and acceleration")
      ->type_name("WHETHER");
  simulate->add_flag("--pulses", all.simulate.pulses, "Steps through pulse-driven loops, in place of words");
  add_adaptive(*simulate, all.simulate.adaptive);
  simulate->add_option("--trace", all.run.trace, "Write words and slides: .csv or .npy")->type_name("FILE");
  add_pages(*simulate, all.run);
  add_threads(*simulate, arguments);
  simulate->footer(simulate_help() + curves_text());
  return simulate;
}

CLI::App* add_check(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::App* check = app.add_subcommand("check", "Read only: diagnostics");
  check
      ->add_option("PROGRAM", arguments.programs,
                   "Part programs; - is standard input, curve:NAME a curve of the studies")
      ->required()
      ->type_name("");
  add_common(*check, arguments, texts);
  add_threads(*check, arguments);
  check->footer(std::string(check_examples) + curves_text());
  return check;
}

CLI::App* add_verify(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::App* verify = app.add_subcommand("verify", "The referee: any trace against its program and machine");
  verify->add_option("TRACE", arguments.judged_trace, "Trace, .csv or .npy; - is standard input")
      ->required()
      ->type_name("");
  verify
      ->add_option("PROGRAM", texts.one_program,
                   "Its part program; - is standard input, curve:NAME a curve of the studies")
      ->required()
      ->type_name("");
  add_common(*verify, arguments, texts);
  verify->add_option("--period", texts.period, "Time between rows, such as 1ms, in place of what t says")
      ->type_name("TIME");
  add_motion(*verify, texts);
  verify->footer(std::string(verify_examples) + curves_text());
  return verify;
}

CLI::App* add_drive(CLI::App& app, Arguments& arguments, Texts& all) {
  DriveTexts& texts = all.drive;
  CLI::App* drive =
      app.add_subcommand("drive", "Run on time: the real-time controller, with simulated drives or a file");
  drive->add_option("PROGRAM", all.one_program, "Part program; - is standard input, curve:NAME a curve of the studies")
      ->required()
      ->type_name("");
  add_common(*drive, arguments, all);
  add_period(*drive, all);
  add_motion(*drive, all);
  drive->add_option("--trace", texts.trace, "Write the words that the drives took: .csv or .npy")->type_name("FILE");
  drive->add_option("--axes", texts.axes, "Write where the axes went, period by period: .csv or .npy")
      ->type_name("FILE");
  drive->add_option("--sink", texts.sink, "Words go on time to this file or pipe, as CSV, and to no drives")
      ->type_name("FILE");
  drive->add_option("--state", texts.state, "Keep on disk how far it has come, for --resume")->type_name("FILE");
  drive->add_option("--resume", texts.resume, "Go on from where a drive was stopped or killed; FILE is kept up")
      ->type_name("FILE");
  drive->add_option("--look-ahead", texts.look_ahead, "Planned ahead of the words (default 300ms)")->type_name("TIME");
  drive
      ->add_option("--lead", texts.lead,
                   "Words made ahead of their time, so that late ones harm nothing (default 100ms)")
      ->type_name("TIME");
  drive->footer(std::string(drive_examples) + curves_text());
  return drive;
}

CLI::App* add_pulse(CLI::App& app, Arguments& arguments, Texts& all) {
  PulseTexts& texts = all.pulse;
  CLI::App* pulse = app.add_subcommand("pulse", "One line or arc in reference pulses, clock by clock");
  pulse->add_flag("--arc", texts.arc, "An arc");
  pulse->add_flag("--line", texts.line, "A straight line");
  pulse->add_option("--start", texts.start, "Where it starts (of a line, default: 0,0)")->type_name("X,Y");
  pulse->add_option("--end", texts.end, "Where it ends")->type_name("X,Y");
  pulse->add_option("--center", texts.center, "Of an arc (default: 0,0)")->type_name("X,Y");
  pulse->add_flag("--cw", texts.clockwise, "Clockwise");
  pulse->add_flag("--ccw", texts.counterclockwise, "Counterclockwise (default)");
  pulse->add_option("--method", texts.methods, "Some of " + names_of_pulse_methods() + " (default: all)")
      ->type_name("LIST");
  pulse->add_option("--bits", texts.bits, "Width of the registers; the capacity of dda is then 2^N")->type_name("N");
  pulse->add_option("--preload", texts.preload, "Of the remainders: zero, half, half-lagging or full")
      ->type_name("LOAD");
  pulse->add_option("--tie", texts.tie, "Where point comparison goes on the circle: outward or inward")
      ->type_name("WAY");
  pulse
      ->add_option("--order", texts.order,
                   "Of the integrators of arcs: parallel, x-first, shrinking-first or growing-first")
      ->type_name("ORDER");
  pulse->add_flag("--table", texts.table, "Every register at every clock, as text");
  pulse->add_flag("--path", texts.path, "Every place, in JSON");
  pulse->add_option("--vcd", texts.vcd, "Write every register at every clock")->type_name("FILE.vcd");
  pulse->add_option("--svg", texts.svg, "Write the steps over the true curve")->type_name("FILE.svg");
  add_output(*pulse, arguments, all);
  pulse->footer(std::string(pulse_examples));
  return pulse;
}

CLI::App* add_study(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::App* study = app.add_subcommand("study", "Published tables and figures made again, ours beside them");
  study->add_option("NAME", arguments.study, "Which; list says what there is")->required()->type_name("");
  study->add_option("--picture", arguments.study_picture, "Its quantities over time, where it has any, as an SVG")
      ->type_name("FILE");
  add_output(*study, arguments, texts);
  study->footer(std::string(study_examples));
  return study;
}

CLI::App* add_design(CLI::App& app, Arguments& arguments, Texts& all) {
  DesignTexts& texts = all.design;
  CLI::App* design = app.add_subcommand("design", "Size digital integrators: bits, clock, feed word, rates");
  design->add_option("--travel", texts.travel, "Greatest way of an axis")->type_name("MM");
  design->add_option("--blu", texts.blu, "Basic length unit: a step")->type_name("MM");
  design->add_option("--max-feed", texts.max_feed, "Greatest feed")->type_name("MM/MIN");
  design->add_option("--min-distance", texts.min_distance, "Shortest line at the greatest feed")->type_name("MM");
  design->add_option("--from", texts.from, "Where a line starts (default: 0)")->type_name("X,Y,...");
  design->add_option("--to", texts.to, "Where it ends")->type_name("X,Y,...");
  design->add_option("--feed", texts.feed, "Along it")->type_name("MM/MIN");
  design->add_flag("--timer", texts.timer, "A timer: first overflow after each delay");
  design->add_option("--clock", texts.clock, "Of the timer")->type_name("PULSES/S");
  design->add_option("--delays", texts.delays, "Of the timer")->type_name("S,...");
  design->add_flag("--inverse-time", texts.inverse_time, "Feed words of the inverse-time code, and of software");
  design->add_option("--distance", texts.distance, "Length of a line, for --inverse-time")->type_name("UNITS");
  design->add_option("--radius", texts.radius, "Radius of an arc, for --inverse-time")->type_name("UNITS");
  design->add_option("--resolution", texts.resolution, "Of the feed in software (default: 0.01)")
      ->type_name("UNITS/MIN");
  design->add_option("--digits", texts.digits, "Of the inverse-time code (default: 4)")->type_name("N");
  add_output(*design, arguments, all);
  design->footer(std::string(design_examples));
  return design;
}

}  // namespace leadscrew::cli
