#include "leadscrew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "handles.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

static_assert(LEADSCREW_AXES == base::axis_count);
static_assert(LEADSCREW_LOSS == static_cast<int>(gcode::ProbeSearch::loss));
static_assert(LEADSCREW_HELD_BY_FEED == static_cast<int>(pipeline::Hold::Kind::feed));
static_assert(LEADSCREW_HELD_AT_REST == static_cast<int>(pipeline::Hold::Kind::rest));
static_assert(LEADSCREW_HELD_BY_CHORD == static_cast<int>(pipeline::Hold::Kind::chord_error));

namespace {

constexpr std::size_t most_changes = 1'000'000;  // of the feed, in one motion

int code_of(const base::Result<void>& result, leadscrew_error* error) {
  return result ? LEADSCREW_OK : rejected(error, result.error());
}

/// What `work` returns of a motion, while nobody else is in it.
template <class Work>
int within(leadscrew_motion* motion, leadscrew_error* error, const Work& work) {
  if (motion == nullptr) return misuse(error, "the motion is NULL");
  if (motion->is_busy) return misuse(error, "the motion is used from within its own functions");
  motion->is_busy = true;
  const int code = guarded(error, [&] { return work(*motion->motion); });
  motion->is_busy = false;
  return code;
}

/// Makes a motion by `make`, which takes the machine, host::MotionOptions and the options as given.
template <class Make>
int make_motion(const leadscrew_machine* machine, const leadscrew_options* given, leadscrew_motion** motion,
                leadscrew_error* error, const Make& make) {
  if (machine == nullptr || motion == nullptr) return misuse(error, "the machine or the place for the motion is NULL");
  return guarded(error, [&] {
    leadscrew_options asked{};
    host::MotionOptions options;
    if (const int code = read_options(given, machine->machine, asked, options, error); code != LEADSCREW_OK)
      return code;
    base::Result<std::unique_ptr<host::Motion>> made = make(machine->machine, std::move(options), asked);
    if (!made) return rejected(error, made.error());
    *motion = new leadscrew_motion{machine->machine, std::move(*made)};
    return static_cast<int>(LEADSCREW_OK);
  });
}

int next_words(host::Motion& motion, leadscrew_word* words, std::size_t word_size, std::size_t capacity,
               std::size_t& count) {
  std::array<base::Word, 256> made;
  auto* to = reinterpret_cast<char*>(words);
  while (count < capacity) {
    const std::size_t some = motion.next(std::span(made).first(std::min(made.size(), capacity - count)));
    for (std::size_t i = 0; i < some; ++i, to += word_size) {
      const leadscrew_word word = word_of(made[i]);
      std::memcpy(to, &word, sizeof word);
    }
    count += some;
    if (motion.progress() != pipeline::Progress::moving) break;
  }
  if (count > 0 || capacity == 0 || !motion.failure()) return LEADSCREW_OK;
  return motion.failure()->code == "interrupted" ? LEADSCREW_INTERRUPTED : LEADSCREW_FAILED;
}

leadscrew_trajectory::PartOfSurface part_of(const gcode::MachinedMove& machined) {
  if (!machined.surface) return {};
  return {1 + static_cast<std::int32_t>(machined.part), static_cast<std::int32_t>(machined.pass)};
}

/// What events say of the tool.
void take_tools(leadscrew_trajectory& trajectory) {
  using Kind = base::Event::Kind;
  leadscrew_trajectory::Held held;
  trajectory.planned.tell_events([&](const base::PassedEvent& event) {
    if (event.kind == Kind::tool_offset) {
      held.offset[static_cast<std::size_t>(event.output)] = event.value;
    } else if (base::changes_tool(event.kind)) {
      held.number = static_cast<std::int32_t>(event.value);
    } else {
      return;
    }
    held.tick = event.tick;
    trajectory.tools.push_back(held);
  });
}

leadscrew_pose pose_of(const leadscrew_trajectory& trajectory, double time, const base::AxisVector& axes) {
  leadscrew_pose pose{};
  pose.size = sizeof pose;
  // A word belongs to the way that leads to it: what happens in its period is in force for it.
  const double period = trajectory.machine.period.seconds();
  const auto next = std::upper_bound(
      trajectory.tools.begin(), trajectory.tools.end(), time,
      [&](double t, const auto& held) { return t < (static_cast<double>(base::count(held.tick)) - 0.5) * period; });
  const leadscrew_trajectory::Held held = next == trajectory.tools.begin() ? leadscrew_trajectory::Held{} : *(next - 1);
  if (trajectory.machine.rotary_chain) {
    const kinematics::Chain chain = kinematics::chain_of(trajectory.machine);
    const auto tip = kinematics::pose_of(chain, axes, held.offset);
    std::copy_n(tip.begin(), 3, pose.tip);
    const kinematics::Vector direction = kinematics::direction_of(chain, kinematics::angles_of(chain, axes));
    std::copy(direction.begin(), direction.end(), pose.direction);
    pose.pole_angle = kinematics::angle_to_pole(chain, direction);
  } else {
    for (std::size_t i = 0; i < 3; ++i) pose.tip[i] = axes[i] - held.offset[i];
    pose.direction[2] = 1;
    pose.pole_angle = std::numeric_limits<double>::infinity();
  }
  std::copy(held.offset.begin(), held.offset.end(), pose.offset);
  pose.tool = held.number;
  return pose;
}

}  // namespace

const char* leadscrew_version() {
  return LEADSCREW_VERSION_TEXT;
}

int leadscrew_machine_builtin(const char* name, leadscrew_machine** machine, leadscrew_error* error) {
  if (name == nullptr || machine == nullptr) return misuse(error, "the name or the place for the machine is NULL");
  return guarded(error, [&] {
    if (std::string_view(name) != "mill3")
      return rejected(error, base::problem("machine-name", "no machine of this name is built in", "mill3"));
    *machine = new leadscrew_machine{machine::mill3()};
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_machine_limits(const leadscrew_machine* machine, leadscrew_limits* limits, leadscrew_error* error) {
  if (machine == nullptr) return misuse(error, "the machine is NULL");
  if (!fill(limits, limits_of(machine->machine)))
    return misuse(error, "the limits are NULL, or their size is none that a version had");
  return LEADSCREW_OK;
}

int leadscrew_machine_limited(const leadscrew_machine* machine, const leadscrew_limits* limits,
                              leadscrew_machine** limited, leadscrew_error* error) {
  if (machine == nullptr || limited == nullptr) return misuse(error, "the machine or the place for the other is NULL");
  const auto asked = known(limits);
  if (!asked || asked->axes != limits_of(machine->machine).axes)
    return misuse(error, "the limits are NULL, their size is none that a version had, or their axes are others");
  return guarded(error, [&] {
    machine::Machine made = with_limits(machine->machine, *asked);
    if (const auto problems = machine::validate(made); !problems.empty()) return rejected(error, problems.front());
    *limited = new leadscrew_machine{std::move(made)};
    return static_cast<int>(LEADSCREW_OK);
  });
}

double leadscrew_machine_period(const leadscrew_machine* machine) {
  return machine == nullptr ? 0 : machine->machine.period.seconds();
}

void leadscrew_machine_free(leadscrew_machine* machine) {
  delete machine;
}

int leadscrew_motion_of_program(const leadscrew_machine* machine, const char* text, size_t length,
                                const leadscrew_options* options, leadscrew_motion** motion, leadscrew_error* error) {
  if (!is_text(text, length)) return misuse(error, "the text is NULL, or its length is none that memory holds");
  return make_motion(machine, options, motion, error, [&](const auto& limits, auto asked, const auto& given) {
    return host::Motion::of_program(limits, std::string(text, length), std::move(asked), sink_of(given));
  });
}

int leadscrew_motion_of_moves(const leadscrew_machine* machine, const leadscrew_options* options,
                              leadscrew_motion** motion, leadscrew_error* error) {
  return make_motion(machine, options, motion, error,
                     [](const auto& limits, auto asked, const auto&) -> base::Result<std::unique_ptr<host::Motion>> {
                       return std::make_unique<host::Motion>(limits, std::move(asked));
                     });
}

void leadscrew_motion_free(leadscrew_motion* motion) {
  if (motion == nullptr || motion->is_busy) return;
  delete motion;
}

int leadscrew_motion_smooth(leadscrew_motion* motion, double tolerance, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) { return code_of(m.smooth(tolerance), error); });
}

int leadscrew_motion_push(leadscrew_motion* motion, const leadscrew_move* move, leadscrew_error* error) {
  const auto given = known(move);
  if (!given)
    return misuse(error, "the move is NULL, its size is none that a version had, or it asks for what is not known");
  return within(motion, error, [&](host::Motion& m) {
    auto made = move_of(*given);
    if (!made) return misuse(error, "the kind of the move, its line, plane, degree or points are out of their range");
    return code_of(m.push(std::move(*made)), error);
  });
}

int leadscrew_motion_end_for_now(leadscrew_motion* motion) {
  return within(motion, nullptr, [](host::Motion& m) {
    m.end_for_now();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_motion_finish(leadscrew_motion* motion) {
  return within(motion, nullptr, [](host::Motion& m) {
    m.finish();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_motion_next(leadscrew_motion* motion, leadscrew_word* words, size_t word_size, size_t capacity,
                          size_t* count, leadscrew_error* error) {
  if (count == nullptr) return misuse(error, "the place for the count is NULL");
  *count = 0;
  if (words == nullptr || word_size < sizeof(leadscrew_word))
    return misuse(error, "the words are NULL, or their size is none that a version had");
  return within(motion, error, [&](host::Motion& m) {
    const int code = next_words(m, words, word_size, capacity, *count);
    if (code != LEADSCREW_OK) tell(error, *m.failure());
    return code;
  });
}

int leadscrew_motion_progress(const leadscrew_motion* motion) {
  return motion == nullptr ? static_cast<int>(LEADSCREW_ENDED) : static_cast<int>(motion->motion->progress());
}

int leadscrew_motion_override(leadscrew_motion* motion, double factor, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) { return code_of(m.override_feed(factor), error); });
}

int leadscrew_motion_adapt(leadscrew_motion* motion, double factor, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) { return code_of(m.adapt_feed(factor), error); });
}

int leadscrew_motion_input_is(leadscrew_motion* motion, double value, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) { return code_of(m.input_is(value), error); });
}

int leadscrew_motion_probing(const leadscrew_motion* motion) {
  return motion == nullptr ? static_cast<int>(LEADSCREW_NO_PROBING) : static_cast<int>(motion->motion->probing());
}

int leadscrew_motion_probe_found(leadscrew_motion* motion, const double* position, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) {
    if (position == nullptr) return code_of(m.probe_found(), error);
    return code_of(m.probe_found(axes_of(position)), error);
  });
}

int leadscrew_motion_abort(leadscrew_motion* motion) {
  return within(motion, nullptr, [](host::Motion& m) {
    m.abort();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_motion_reset(leadscrew_motion* motion, const double* position, leadscrew_error* error) {
  if (position == nullptr) return misuse(error, "the position is NULL");
  return within(motion, error, [&](host::Motion& m) {
    base::AxisVector there;
    std::copy_n(position, LEADSCREW_AXES, there.begin());
    return code_of(m.reset(there), error);
  });
}

int leadscrew_motion_plan(leadscrew_motion* motion, leadscrew_trajectory** trajectory, leadscrew_error* error) {
  return leadscrew_motion_plan_changed(motion, nullptr, nullptr, 0, trajectory, error);
}

int leadscrew_motion_plan_changed(leadscrew_motion* motion, const double* times, const double* factors, size_t count,
                                  leadscrew_trajectory** trajectory, leadscrew_error* error) {
  if (trajectory == nullptr) return misuse(error, "the place for the trajectory is NULL");
  if (count > most_changes || (count > 0 && (times == nullptr || factors == nullptr)))
    return misuse(error, "the times or the factors of feed changes are NULL, or their count is none that memory holds");
  return within(motion, error, [&](host::Motion& m) {
    auto made = std::make_unique<leadscrew_trajectory>(motion->machine);
    host::PlanNotes notes{.on_move = [&](const gcode::Move& move, const gcode::MachinedMove& machined) {
      if (made->times.observe(move)) made->parts.push_back(part_of(machined));
    }};
    std::vector<host::FeedChange> changes;
    for (std::size_t i = 0; i < count; ++i) changes.push_back({times[i], factors[i]});
    base::Result<host::Trajectory> planned = m.plan(&notes, changes);
    if (!planned) return rejected(error, planned.error());
    made->planned = std::move(*planned);
    made->summary = notes.summary;
    take_tools(*made);
    *trajectory = made.release();
    return static_cast<int>(LEADSCREW_OK);
  });
}

double leadscrew_trajectory_duration(const leadscrew_trajectory* trajectory) {
  return trajectory == nullptr ? 0 : trajectory->planned.duration();
}

int leadscrew_trajectory_figures(const leadscrew_trajectory* trajectory, leadscrew_figures* figures,
                                 leadscrew_error* error) {
  if (trajectory == nullptr) return misuse(error, "the trajectory is NULL");
  if (!fill(figures, figures_of(trajectory->summary)))
    return misuse(error, "the figures are NULL, or their size is none that a version had");
  return LEADSCREW_OK;
}

int leadscrew_trajectory_blocks(const leadscrew_trajectory* trajectory, leadscrew_block_function on_block, void* user,
                                leadscrew_error* error) {
  if (trajectory == nullptr || on_block == nullptr) return misuse(error, "the trajectory or the function is NULL");
  return guarded(error, [&] {
    pipeline::LostTime times = trajectory->times;
    auto part = trajectory->parts.begin();
    times.on_block([&](const pipeline::BlockTime& time) {
      leadscrew_block block = block_of(time);
      block.part = part->part;
      block.pass = (part++)->pass;
      on_block(&block, user);
    });
    const base::Tick last = trajectory->planned.last_tick();
    for (base::Tick tick{}; tick <= last; tick = base::next(tick)) times.observe(trajectory->planned.word(tick));
    times.finish();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_trajectory_at(const leadscrew_trajectory* trajectory, double time, leadscrew_state* state,
                            leadscrew_error* error) {
  if (trajectory == nullptr) return misuse(error, "the trajectory is NULL");
  if (std::isnan(time)) return misuse(error, "the time is no number");
  if (!fill(state, state_of(trajectory->planned.at(time))))
    return misuse(error, "the state is NULL, or its size is none that a version had");
  return LEADSCREW_OK;
}

int leadscrew_trajectory_pose(const leadscrew_trajectory* trajectory, double time, leadscrew_pose* pose,
                              leadscrew_error* error) {
  if (trajectory == nullptr) return misuse(error, "the trajectory is NULL");
  if (std::isnan(time)) return misuse(error, "the time is no number");
  if (!fill(pose, pose_of(*trajectory, time, trajectory->planned.at(time).position)))
    return misuse(error, "the pose is NULL, or its size is none that a version had");
  return LEADSCREW_OK;
}

int leadscrew_trajectory_sample(const leadscrew_trajectory* trajectory, const double* times, size_t count,
                                leadscrew_state* states, size_t state_size, leadscrew_pose* poses, size_t pose_size,
                                leadscrew_error* error) {
  if (trajectory == nullptr || (count > 0 && (times == nullptr || states == nullptr)))
    return misuse(error, "the trajectory, the times or the states are NULL");
  if (std::any_of(times, times + count, [](double time) { return std::isnan(time); }))
    return misuse(error, "one of the times is no number");
  if (!is_size<leadscrew_state>(state_size) || (poses != nullptr && !is_size<leadscrew_pose>(pose_size)))
    return misuse(error, "a size is none that a version had");
  pipeline::TrajectoryWalk walk(trajectory->planned);
  for (size_t i = 0; i < count; ++i) {
    const pipeline::TrajectoryState state = walk.at(times[i]);
    put(states, state_size, i, state_of(state));
    if (poses != nullptr) put(poses, pose_size, i, pose_of(*trajectory, times[i], state.position));
  }
  return LEADSCREW_OK;
}

int leadscrew_trajectory_hold(const leadscrew_trajectory* trajectory, const leadscrew_state* state, double feed_asked,
                              leadscrew_hold* hold, leadscrew_error* error) {
  if (trajectory == nullptr) return misuse(error, "the trajectory is NULL");
  const auto given = known(state);
  if (!given || std::isnan(feed_asked))
    return misuse(error, "the state is NULL, its size is none that a version had, or the feed is no number");
  if (!fill(hold, hold_of(*given, trajectory->machine, feed_asked)))
    return misuse(error, "the hold is NULL, or its size is none that a version had");
  return LEADSCREW_OK;
}

void leadscrew_trajectory_free(leadscrew_trajectory* trajectory) {
  delete trajectory;
}
