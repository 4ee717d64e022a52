#include "leadscrew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/config/tool_file.hpp>
#include <leadscrew/host/motion.hpp>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "structures.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

struct leadscrew_machine {
  machine::Machine machine;
};

struct leadscrew_motion {
  std::unique_ptr<host::Motion> motion;
  bool is_busy = false;  ///< one of its functions is running
};

struct leadscrew_trajectory {
  host::Trajectory trajectory;
};

static_assert(LEADSCREW_AXES == base::axis_count);
static_assert(LEADSCREW_LOSS == static_cast<int>(gcode::ProbeSearch::loss));

namespace {

/// Can memory hold so long a text?
bool is_text(const char* text, std::size_t length) {
  return text != nullptr && length <= std::string().max_size();
}

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

/// The first problem, or what was read.
template <class Read, class Use>
int with_read(Read read, leadscrew_error* error, const Use& use) {
  if (!read) return rejected(error, read.error().front());
  use(std::move(*read));
  return LEADSCREW_OK;
}

int give_machine(config::MachineOrProblems read, leadscrew_machine** machine, leadscrew_error* error) {
  return with_read(std::move(read), error,
                   [&](machine::Machine made) { *machine = new leadscrew_machine{std::move(made)}; });
}

int read_tools(const leadscrew_options& given, machine::ToolTable& tools, leadscrew_error* error) {
  const auto take = [&](machine::ToolTable read) { tools = std::move(read); };
  if (given.tools != nullptr) return with_read(config::read_tools({given.tools, given.tools_length}, {}), error, take);
  if (given.tools_file != nullptr) return with_read(config::load_tools(given.tools_file), error, take);
  return LEADSCREW_OK;
}

/// Makes a motion by `make`, which takes the machine, host::MotionOptions and the options as given.
template <class Make>
int make_motion(const leadscrew_machine* machine, const leadscrew_options* given, leadscrew_motion** motion,
                leadscrew_error* error, const Make& make) {
  if (machine == nullptr || motion == nullptr) return misuse(error, "the machine or the place for the motion is NULL");
  leadscrew_options none{};
  none.size = sizeof none;
  const auto asked = known(given == nullptr ? &none : given);
  if (!asked)
    return misuse(error, "the size of the options is none that a version had, or they ask for what is not known");
  if (asked->tools != nullptr && (asked->tools_file != nullptr || !is_text(asked->tools, asked->tools_length)))
    return misuse(error, "tools are given twice, or the length of their text is none that memory holds");
  return guarded(error, [&] {
    auto options = options_of(*asked, machine->machine);
    if (!options) return rejected(error, options.error());
    if (const int code = read_tools(*asked, options->tools, error); code != LEADSCREW_OK) return code;
    base::Result<std::unique_ptr<host::Motion>> made = make(machine->machine, std::move(*options), *asked);
    if (!made) return rejected(error, made.error());
    *motion = new leadscrew_motion{std::move(*made)};
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

int leadscrew_machine_of_text(const char* text, size_t length, leadscrew_machine** machine, leadscrew_error* error) {
  if (!is_text(text, length) || machine == nullptr)
    return misuse(error, "the text or the place for the machine is NULL, or the length is none that memory holds");
  return guarded(error, [&] { return give_machine(config::read_machine({text, length}, {}), machine, error); });
}

int leadscrew_machine_of_file(const char* path, leadscrew_machine** machine, leadscrew_error* error) {
  if (path == nullptr || machine == nullptr) return misuse(error, "the path or the place for the machine is NULL");
  return guarded(error, [&] { return give_machine(config::load_machine(path), machine, error); });
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
  if (trajectory == nullptr) return misuse(error, "the place for the trajectory is NULL");
  return within(motion, error, [&](host::Motion& m) {
    base::Result<host::Trajectory> planned = m.plan();
    if (!planned) return rejected(error, planned.error());
    *trajectory = new leadscrew_trajectory{std::move(*planned)};
    return static_cast<int>(LEADSCREW_OK);
  });
}

double leadscrew_trajectory_duration(const leadscrew_trajectory* trajectory) {
  return trajectory == nullptr ? 0 : trajectory->trajectory.duration();
}

int leadscrew_trajectory_at(const leadscrew_trajectory* trajectory, double time, leadscrew_state* state,
                            leadscrew_error* error) {
  if (trajectory == nullptr) return misuse(error, "the trajectory is NULL");
  if (std::isnan(time)) return misuse(error, "the time is no number");
  if (!fill(state, state_of(trajectory->trajectory.at(time))))
    return misuse(error, "the state is NULL, or its size is none that a version had");
  return LEADSCREW_OK;
}

void leadscrew_trajectory_free(leadscrew_trajectory* trajectory) {
  delete trajectory;
}
