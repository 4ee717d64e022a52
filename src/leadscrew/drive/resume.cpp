#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/drive/resume.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/return_path.hpp>

namespace leadscrew::drive {

namespace {

constexpr double at_rest = 1e-3;  // mm or degrees; axes may stand by rounding or their counts beyond their travel

}  // namespace

base::Result<void> check_resumable(const State& state, const Fingerprint& now, const machine::Machine& machine,
                                   const std::string& path) {
  if (state.fingerprint.program != now.program) {
    return state_refusal("resume-program", fmt::format("was written by a drive of another program, {}", state.program),
                         "give the program as it was, byte for byte, or drive the new one from its start", path);
  }
  if (state.fingerprint.machine != now.machine) {
    return state_refusal(
        "resume-machine",
        fmt::format("was written by a drive of another machine, {}, with other tools, or another --period, "
                    "--start, --mode or --tolerance",
                    state.machine),
        "a place on the path is the same only where all of these are", path);
  }
  if (state.kind == State::Kind::ended)
    return state_refusal("resume-ended", "was written by a drive that has come to the program's end", "", path);
  for (const base::Axis axis : base::all_axes) {
    for (const double at : {state.axes.position[base::index(axis)], state.word.position[base::index(axis)]}) {
      const bool is_within = machine.has(axis) ? at >= machine.limits(axis).travel_min - at_rest &&
                                                     at <= machine.limits(axis).travel_max + at_rest
                                               : at == 0;
      if (is_within) continue;
      return state_refusal("resume-state",
                           fmt::format("says that {} stands at {}, where it cannot", base::letter(axis), at),
                           "give the file that --state wrote, as it was", path);
    }
  }
  return {};
}

base::Result<ReturnPath> find_return_path(const State& state, const files::InputFile& program, const Setup& setup,
                                          const std::string& path) {
  constexpr double same = 1e-6;  // mm or degrees
  const auto refused = [&](double length, std::string_view but) {
    return state_refusal("resume-state",
                         fmt::format("says that the path was left after {:.6g} mm, but {}", length, but),
                         "give the file as --state wrote it, to the same version of leadscrew", path);
  };
  const auto are_same = [](const base::AxisVector& a, const base::AxisVector& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](double p, double q) { return std::abs(p - q) <= same; });
  };
  pipeline::MotionSource source(program.source(), setup.machine, setup.tools, setup.reader_options(program), nullptr);
  source.follow_spindle();  // the path is the one that was driven
  pipeline::PathStretch stretch(state.word.path_length, state.axes.path_length);
  source.on_element = [&](const toolpath::Element& element) { stretch.push(element); };
  source.planner().start_at(state.word.path_length, state.word.line);
  bool goes_on = source.next().has_value();
  if (source.failure()) return base::failure(*source.failure());
  const std::optional<geometry::Point> at = source.planner().started_at();
  if (!at) return refused(state.word.path_length, "it is shorter");
  if (!are_same(*at, state.word.position)) return refused(state.word.path_length, "it is elsewhere there");
  if (state.axes.path_length == state.word.path_length) {
    if (are_same(*at, state.axes.position)) return ReturnPath{{}, source.planner().starts_in_step()};
    return refused(state.axes.path_length, "it is elsewhere there");
  }
  while (goes_on && !stretch.is_whole()) goes_on = source.next().has_value();
  if (source.failure()) return base::failure(*source.failure());
  if (!stretch.is_whole()) return refused(state.axes.path_length, "it is shorter");
  if (!are_same(stretch.at(stretch.to()).position, state.axes.position))
    return refused(state.axes.path_length, "it is elsewhere there");
  auto return_path = pipeline::plan_return(stretch, setup.machine);
  if (!return_path) return refused(state.axes.path_length, "no motion back to it keeps the limits");
  return_path->back().position = state.word.position;
  return ReturnPath{std::move(*return_path), source.planner().starts_in_step()};
}

}  // namespace leadscrew::drive
