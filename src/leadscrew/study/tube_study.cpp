// How much time a tolerance is worth: the least that any motion needs inside the tube around a program, path and time
// law found at once (tube_optimum.hpp), and what ours takes.

#include <leadscrew/study/studies.hpp>
#include <leadscrew/study/tube_fragments.hpp>
#include <leadscrew/study/tube_optimum.hpp>
#include <leadscrew/study/tube_words.hpp>

namespace leadscrew::study {

namespace {

constexpr base::Period word_period{1'000'000};

Rows least_rows(const TubeFragment& fragment, const TubeMotion& motion, double planned, double by_splines) {
  constexpr Scale seconds = {"s", 4};
  return {because(reproduced_row("least time in the tube", seconds, fragment.least, motion.seconds(),
                                 least_accuracy * fragment.least),
                  "recorded: the least of five starts far apart, good to 0.1 %"),
          measured_row("time planned", seconds, planned),
          measured_row("time planned over least time", {"", 3}, planned / motion.seconds()),
          measured_row("time planned by splines", seconds, by_splines),
          measured_row("time planned by splines over least time", {"", 3}, by_splines / motion.seconds())};
}

Rows kept_rows(const TubeFragment& fragment, const referee::Verdict& verdict) {
  Row objections =
      limit_row("least time: objections of the referee", {"", 0}, 0, static_cast<double>(verdict.violation_count));
  if (!verdict.violations.empty()) objections.why = "first: " + verdict.violations.front().what;
  return {because(limit_row("least time: deviation from the program", {"µm", 3}, fragment.program.tolerance * 1e3,
                            verdict.deviation_mm * 1e3, 1e-3),
                  "words at 1 ms; the tolerance"),
          objections};
}

Rows rows_of(const TubeFragment& fragment, const Host& host) {
  machine::Machine machine = machine_of(fragment.program, word_period);
  const PartProgram program = blended(fragment.program);
  const auto by_splines = plan(program, machine, host);
  machine.smoothing = machine::Smoothing::least_time;
  const auto planned = plan(program, machine, host);
  if (!planned || !by_splines) return {not_run_row("motion", (planned ? by_splines : planned).error().message)};
  const auto tube = tube_of(program, machine);
  if (!tube) return {not_run_row("least time in the tube", tube.error().message)};
  const TubeMotion motion = least_time_motion(*tube).motion;
  Rows rows = least_rows(fragment, motion, planned->seconds, by_splines->seconds);
  append(rows, kept_rows(fragment, judge(program, machine, motion.words(word_period.seconds()))));
  return rows;
}

}  // namespace

Rows tube_rows(const Host& host) {
  const std::span<const TubeFragment> fragments = tube_fragments();
  std::vector<Rows> found(fragments.size());
  share_out(host, fragments.size(), [&](std::size_t i) { found[i] = rows_of(fragments[i], {}); });
  Rows rows;
  for (std::size_t i = 0; i < fragments.size(); ++i)
    append(rows, under(circumstances(fragments[i].program), std::move(found[i])));
  return rows;
}

std::vector<StudyFile> tube_words(const Host& host) {
  const std::span<const TubeFragment> fragments = tube_fragments();
  std::vector<StudyFile> files(2 * fragments.size());
  share_out(host, fragments.size(), [&](std::size_t i) {
    const BlendedProgram& fragment = fragments[i].program;
    const PartProgram program = blended(fragment);
    files[2 * i] = {std::string(fragments[i].file) + ".ngc", program.text};
    const auto tube = tube_of(program, machine_of(fragment, word_period));
    files[2 * i + 1].name = std::string(fragments[i].file) + ".csv";
    if (!tube) return;
    files[2 * i + 1].text = trace_of(least_time_motion(*tube).motion.words(word_period.seconds()), word_period);
  });
  return files;
}

}  // namespace leadscrew::study
