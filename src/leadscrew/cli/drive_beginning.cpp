#include <leadscrew/cli/drive_beginning.hpp>

namespace leadscrew::cli {

namespace {

base::Result<std::vector<Descriptor>> hold_states(const DriveArguments& arguments) {
  std::vector<Descriptor> held;
  for (const auto& path : {arguments.resume, arguments.state}) {
    if (!path || (!held.empty() && path == arguments.resume)) continue;
    auto descriptor = hold_state(*path);
    if (!descriptor) return base::failure(descriptor.error());
    held.push_back(std::move(*descriptor));
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

base::Result<DriveBeginning> DriveBeginning::of(const InputFile& program, const Job& job) {
  const DriveArguments& arguments = job.arguments.drive;
  DriveBeginning begin;
  auto held = hold_states(arguments);
  if (!held) return base::failure(held.error());
  begin.held = std::move(*held);
  const auto fingerprint = fingerprint_of(program, job);
  if (!fingerprint) return base::failure(fingerprint.error());
  DriveState& state = begin.state;
  state.word.position = state.axes.position = job.start;
  if (arguments.resume) {
    auto kept = read_state(*arguments.resume);
    if (!kept) return base::failure(kept.error());
    if (auto same = check_resumable(*kept, *fingerprint, job.machine, *arguments.resume); !same)
      return base::failure(same.error());
    auto way_back = find_way_back(*kept, program, job, *arguments.resume);
    if (!way_back) return base::failure(way_back.error());
    begin.way_back = std::move(*way_back);
    if (arguments.sink && !begin.way_back.empty()) return base::failure(stands_elsewhere(*arguments.resume));
    state = *kept;
    if (state.kind == DriveState::Kind::moving) begin.warning = cut_twice(*arguments.resume);
  }
  state.program = program.name();
  state.machine = job.machine.name;
  state.fingerprint = *fingerprint;
  if (arguments.state) {
    if (auto written = write_state(*arguments.state, state); !written) return base::failure(written.error());
  }
  return begin;
}

}  // namespace leadscrew::cli
