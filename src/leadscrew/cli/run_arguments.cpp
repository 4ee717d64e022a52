#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <leadscrew/cli/output_name.hpp>
#include <leadscrew/cli/pulse_arguments.hpp>
#include <leadscrew/cli/run_arguments.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <utility>

namespace leadscrew::cli {

namespace {

template <class... Values>
auto wrong(fmt::format_string<Values...> text, Values&&... values) {
  return tl::unexpected<std::string>(fmt::format(text, std::forward<Values>(values)...));
}

Parsed<interpolator::StepRule> parse_step_rule(std::string_view text) {
  std::string known;
  for (const interpolator::StepRule rule : interpolator::all_step_rules) {
    if (text == interpolator::name(rule)) return rule;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", interpolator::name(rule));
  }
  return wrong("is none of {}", known);
}

/// An option's value, where it is given.
template <class Target, class Value>
Parsed<void> take(std::string_view option, const std::optional<std::string>& text,
                  Parsed<Value> (*parse)(std::string_view), Target& target) {
  if (!text) return {};
  auto value = parse(*text);
  if (!value) return wrong("{} {}: {}", option, *text, value.error());
  target = std::move(*value);
  return {};
}

Parsed<void> check_names(const RunTexts& texts) {
  for (const auto& [option, path] : {std::pair("--trace", &texts.trace),
                                     {"--pulses", &texts.pulses},
                                     {"--report", &texts.report},
                                     {"--picture", &texts.picture},
                                     {"--out", &texts.out}}) {
    if (auto sound = check_output_name(option, *path); !sound) return sound;
  }
  return {};
}

Parsed<void> check_files(const RunTexts& texts, std::size_t programs) {
  if (programs < 2) return {};
  for (const auto& [option, path] :
       {std::pair("--trace", &texts.trace), {"--report", &texts.report}, {"--picture", &texts.picture}}) {
    if (*path) return wrong("{} is for one program; with several, --out DIR writes the files of each", option);
  }
  if (texts.pulses && !(texts.out && step_format(*texts.pulses)))
    return wrong(
        "--pulses {}: is for one program; with several, --out DIR --pulses vcd, or csv, writes the steps of each",
        *texts.pulses);
  return {};
}

/// They would be ignored.
Parsed<void> check_steps(const RunTexts& texts) {
  if (texts.pulses) return {};
  if (texts.step_clock) return wrong("--step-clock is of --pulses FILE, which is missing");
  for (std::size_t k = 0; k < step_time_options.size(); ++k) {
    if (texts.step_times[k]) return wrong("{} is of --pulses FILE, which is missing", step_time_options[k]);
  }
  return {};
}

Parsed<void> take_step_times(const RunTexts& texts, RunArguments& run) {
  for (std::size_t k = 0; k < step_time_options.size(); ++k) {
    auto taken = take(step_time_options[k], texts.step_times[k], parse_step_time, run.step_times[k]);
    if (!taken) return taken;
    if (run.step_times[k] && *run.step_times[k] < machine::all_step_times[k].least)
      return wrong("{} {}: must be above 0", step_time_options[k], *texts.step_times[k]);
  }
  return {};
}

Parsed<void> check_pulses(const RunTexts& texts) {
  if (texts.accelerate && !texts.pulse_method)
    return wrong("--accelerate is of --pulse-method; steps that follow the words have the words' acceleration");
  if (texts.pulse_method && !texts.pulses) return wrong("--pulse-method is of --pulses FILE, which is missing");
  return {};
}

}  // namespace

std::optional<std::string> step_format(std::string_view text) {
  std::string format(text);
  std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return std::tolower(c); });
  if (format == "vcd" || format == "csv") return format;
  return std::nullopt;
}

Parsed<RunArguments> parse_run(const RunTexts& texts, std::size_t programs) {
  RunArguments run;
  run.trace = texts.trace;
  run.report = texts.report;
  run.picture = texts.picture;
  run.pulses = texts.pulses;
  run.out = texts.out;
  run.accelerate = texts.accelerate;
  for (const Parsed<void>& taken :
       {take("--interpolator", texts.interpolator, parse_step_rule, run.interpolator),
        take("--pulse-method", texts.pulse_method, parse_pulse_method, run.pulse_method),
        take("--step-clock", texts.step_clock, parse_frequency, run.step_clock), take_step_times(texts, run),
        check_names(texts), check_files(texts, programs), check_pulses(texts), check_steps(texts)}) {
    if (!taken) return tl::unexpected(taken.error());
  }
  return run;
}

}  // namespace leadscrew::cli
