#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>
#include <leadscrew/sweep/campaign.hpp>
#include <leadscrew/sweep/judged_run.hpp>
#include <leadscrew/sweep/merge.hpp>
#include <leadscrew/sweep/result.hpp>
#include <limits>
#include <utility>

namespace leadscrew::sweep {

namespace {

constexpr double most_of_a_limit = 1.001;
constexpr double largest_plan_ratio = 1 + 1e-9;
constexpr double largest_excess = 1e-6;  // mm, of a deviation over its tolerance
constexpr double largest_end = 1e-9;     // mm
constexpr int most_runs_of_a_reduction = 100;

/// A program's text and its machine, read whole.
struct SoundReading {
  double seconds = 0;  // an estimate of its motion's
  std::optional<base::Diagnostic> error;
};

/// From rest to rest along a chord, by the slowest axis: what each limit alone would take.
double seconds_along(const machine::Machine& machine, const base::AxisVector& from, const base::AxisVector& to) {
  double longest = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const double way = std::fabs(to[base::index(axis)] - from[base::index(axis)]);
    // A triangle of velocity, and four phases of jerk.
    longest = std::max(
        {longest, way / limits.velocity, 2 * std::sqrt(way / limits.acceleration), std::cbrt(32 * way / limits.jerk)});
  }
  return longest;
}

SoundReading read_case(const campaign::Case& given, const std::string& text) {
  SoundReading read;
  pipeline::QuickSurvey survey(given.machine, {});
  gcode::Reader reader(gcode::text_source(text), given.machine, given.tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity == base::Severity::error && !read.error) read.error = problem;
  });
  base::AxisVector at{};
  const auto see = [&](const gcode::Move& move) {
    read.seconds += seconds_along(given.machine, at, move.end);
    at = move.end;
  };
  pipeline::read_whole(reader, {.survey = &survey,
                                .is_sound = [&] { return !read.error; },
                                .see = see,
                                .goes_on = [] { return !files::interrupted(); }});
  if (!read.error) survey.finish();
  read.seconds = std::max(read.seconds, survey.bound_seconds());
  return read;
}

/// So long that some thousands of words are made: a task takes milliseconds then.
base::Period affordable(base::Period wanted, double seconds) {
  constexpr double most_words = 600;
  const auto least = static_cast<std::int64_t>(seconds * 1e9 / most_words);
  return {std::clamp(std::max(wanted.nanoseconds, least), base::shortest_period.nanoseconds,
                     base::longest_period.nanoseconds)};
}

std::string broken_promise(const JudgedRun& run, bool is_changed) {
  const auto ratios = run.worst_ratios();
  const referee::Verdict& verdict = run.verdict;
  if (run.summary.plan.greatest() > largest_plan_ratio) return "plan";
  if (ratios[0] > most_of_a_limit) return "velocity";
  if (ratios[1] > most_of_a_limit) return "acceleration";
  if (ratios[2] > most_of_a_limit) return "jerk";
  if (verdict.feed_max_ratio > most_of_a_limit) return "feed";
  if (verdict.deviation_mm > verdict.tolerance_mm + largest_excess) return "deviation";
  if (verdict.start_error_mm > largest_end) return "start";
  if (verdict.end_error_mm > largest_end) return "end";
  if (verdict.objects()) return verdict.violations.front().what;
  if (!is_changed && run.summary.bound_s > run.summary.time_s * (1 + 1e-6)) return "bound";
  return {};
}

json::Json row_of(const JudgedRun& run, const std::string& broken, base::Period period) {
  json::Json row = json::Json::object({{"status", broken.empty() ? "kept" : "not-kept"},
                                       {"broken", broken},
                                       {"period_us", static_cast<double>(period.nanoseconds) / 1e3},
                                       {"time_s", run.summary.time_s}});
  for (auto& [name, value] : judged_figures(run)) row[name] = std::move(value);
  return row;
}

Judgement judge_text(const campaign::Case& given, const std::string& text) {
  const SoundReading read = read_case(given, text);
  if (read.error) return {std::string(read.error->code), json_of(*read.error, 1)};
  machine::Machine machine = given.machine;
  machine.period = affordable(machine.period, read.seconds);
  gcode::ReaderOptions options;
  options.surface_drafts = gcode::new_surface_drafts();
  const auto run = run_judged({.machine = machine,
                               .tools = given.tools,
                               .options = options,
                               .source = [&] { return gcode::text_source(text); },
                               .changes = given.changes});
  if (!run) return {std::string(run.error().code), json_of(run.error(), 1)};
  std::string broken = broken_promise(*run, !given.changes.empty());
  json::Json row = row_of(*run, broken, machine.period);
  return {std::move(broken), std::move(row)};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    lines.push_back(text.substr(begin, end - begin + 1));
    begin = end + 1;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace

campaign::Case chosen_case(std::uint64_t seed, std::int64_t number) {
  constexpr std::int64_t turns_for_a_large_one = 100;
  constexpr int most_attempts = 16;
  constexpr double most_seconds = 0.1, most_of_large = 5;
  const bool is_large = number / campaign::kinds_in_turn % turns_for_a_large_one == 0;
  campaign::Case least;
  double least_seconds = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    campaign::Case drawn =
        campaign::case_of(seed, number, is_large ? campaign::Size::large : campaign::Size::small, attempt);
    const SoundReading read = read_case(drawn, drawn.text);
    // A surface that bends more than the tool is refused, rightly, and so is a direction that no angles hold.
    const bool is_refused =
        read.error && (read.error->code == "surface-gouge" || read.error->code == "pose-out-of-reach");
    if (is_refused && (attempt + 1 < most_attempts || least_seconds < std::numeric_limits<double>::infinity()))
      continue;
    if (read.error || read.seconds < (is_large ? most_of_large : most_seconds)) return drawn;
    if (read.seconds >= least_seconds) continue;
    least_seconds = read.seconds;
    least = std::move(drawn);
  }
  return least;
}

Judgement judge(const campaign::Case& given) {
  return judge_text(given, given.text);
}

// Delta debugging (Zeller, Hildebrandt: Simplifying and isolating failure-inducing input, IEEE TSE 28, 2002), without tests of
// subsets alone: parts are left out, of half the lines first.
std::string reduced(const campaign::Case& given, const std::string& broken, int most_runs) {
  std::vector<std::string> lines = lines_of(given.text);
  int runs = 0;
  for (std::size_t part = (lines.size() + 1) / 2; part > 0;) {
    bool is_smaller = false;
    for (std::size_t at = 0; at < lines.size() && runs < most_runs && !files::interrupted();) {
      std::vector<std::string> fewer = lines;
      const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(at);
      fewer.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(part, lines.size() - at)));
      ++runs;
      if (judge_text(given, joined(fewer)).broken == broken) {
        lines = std::move(fewer);
        is_smaller = true;
      } else {
        at += part;
      }
    }
    if (runs >= most_runs || files::interrupted()) break;
    if (!is_smaller || part > 1) part = part == 1 ? 0 : part / 2;
  }
  return joined(lines);
}

Key Campaign::key(std::int64_t task) const {
  KeyMaker key;
  key.add(LEADSCREW_VERSION);
  key.add(fmt::format("random {} {}", setup_.seed, setup_.first + task));
  return key.key();
}

std::vector<json::Json::Member> Campaign::place(std::int64_t task) const {
  const std::int64_t number = setup_.first + task;
  return {
      {"task", task}, {"seed", setup_.seed}, {"number", number}, {"kind", campaign::name(campaign::kind_of(number))}};
}

base::Result<json::Json> Campaign::result(std::int64_t task) {
  const std::int64_t number = setup_.first + task;
  const campaign::Case given = chosen_case(setup_.seed, number);
  const Judgement judgement = judge(given);
  if (files::interrupted()) return base::failure(files::interruption());
  if (judgement.broken.empty()) return judgement.result;
  if (auto kept = keep(given, judgement.broken, number); !kept) return base::failure(kept.error());
  return judgement.result;
}

base::Result<void> Campaign::keep(const campaign::Case& given, const std::string& broken, std::int64_t number) const {
  const std::string base = fmt::format("{}/{}-{}", setup_.counterexamples, setup_.seed, number);
  std::string head =
      fmt::format("(breaks: {})\n(leadscrew sweep --random 1 --seed {} --first {})\n", broken, setup_.seed, number);
  for (const campaign::FeedChange& change : given.changes)
    head += fmt::format("(from word {} on the feed times {})\n", change.tick, change.factor);
  machine::Machine machine = given.machine;
  machine.period = affordable(machine.period, read_case(given, given.text).seconds);
  const std::string smaller = reduced(given, broken, most_runs_of_a_reduction);
  if (files::interrupted()) return base::failure(files::interruption());
  return write_text(base + ".toml", campaign::machine_text(machine))
      .and_then([&] { return write_text(base + ".tbl", given.tools_text); })
      .and_then([&] { return write_text(base + "-reduced.ngc", head + smaller); })
      .and_then([&] { return write_text(base + ".ngc", head + given.text); });
}

}  // namespace leadscrew::sweep
