#include <leadscrew/drive/beginning.hpp>
#include <leadscrew/drive/resume.hpp>
#include <leadscrew/files/output_file.hpp>

namespace leadscrew::drive {

namespace {

base::Result<std::vector<StateLock>> hold_states(const Options& options) {
  std::vector<StateLock> held;
  for (const auto& path : {options.resume, options.state}) {
    if (!path || (!held.empty() && path == options.resume)) continue;
    auto lock = StateLock::hold(*path);
    if (!lock) return base::failure(lock.error());
    held.push_back(std::move(*lock));
  }
  return held;
}

base::Diagnostic cut_twice(const std::string& path) {
  return {base::Severity::warning,
          "resume-cut-twice",
          "was written in motion, and its process ended before it wrote another: what moved since then, 0.1 s as a "
          "rule, is gone through again",
          {},
          base::Place{.file = path},
          {}};
}

base::Diagnostic out_of_step(const std::string& path) {
  return {
      base::Severity::warning,
      "resume-out-of-step",
      "was written within a thread or a tap: what is left of its line, or of the tap, goes at the speed of S and not "
      "in "
      "step with the spindle",
      "take the tool out of the thread before, or out of the tap with the spindle, and cut it again from its beginning",
      base::Place{.file = path},
      {}};
}

/// Drives go back to the last word; behind a file there are none.
base::Diagnostic stands_elsewhere(const std::string& path) {
  return {base::Severity::error,
          "resume-state",
          "was written by simulated drives that stand behind the last word, and no file takes them back",
          "go on without --sink",
          base::Place{.file = path},
          {}};
}

}  // namespace

base::Result<Beginning> Beginning::of(const files::InputFile& program, const Setup& setup) {
  const Options& options = setup.options;
  Beginning begin;
  for (const auto& path : {options.trace, options.axes, options.state, options.resume}) {
    if (path) files::remove_left_behind(*path);
  }
  auto held = hold_states(options);
  if (!held) return base::failure(held.error());
  begin.held = std::move(*held);
  const auto fingerprint = fingerprint_of(program, setup);
  if (!fingerprint) return base::failure(fingerprint.error());
  State& state = begin.state;
  state.word.position = state.axes.position = setup.reading.start;
  if (options.resume) {
    auto kept = read_state(*options.resume);
    if (!kept) return base::failure(kept.error());
    if (auto same = check_resumable(*kept, *fingerprint, setup.machine, *options.resume); !same)
      return base::failure(same.error());
    auto return_path = find_return_path(*kept, program, setup, *options.resume);
    if (!return_path) return base::failure(return_path.error());
    begin.return_path = std::move(return_path->places);
    if (return_path->leads_in_step) begin.warnings.push_back(out_of_step(*options.resume));
    if (options.sink && !begin.return_path.empty()) return base::failure(stands_elsewhere(*options.resume));
    state = *kept;
    if (state.kind == State::Kind::moving) begin.warnings.push_back(cut_twice(*options.resume));
  }
  kinematics::WordPoses poses(setup.machine);
  if (state.tool) poses.hold(state.tool->offset);
  state.tool = tool_state_of(poses, state.axes.position);
  state.program = program.name();
  state.machine = setup.machine.name;
  state.fingerprint = *fingerprint;
  if (options.state) {
    if (auto written = write_state(*options.state, state); !written) return base::failure(written.error());
  }
  return begin;
}

}  // namespace leadscrew::drive
