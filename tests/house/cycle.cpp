// What the cycle calls, seen while it runs, for whoever may not be called is counted (forbidden_calls.hpp). Beside the
// cycle this program holds functions that do what is forbidden, for the checks of the checks: tests/house/reached.cpp
// reads the machine code of them all.
//
//   cycle            words along lines, arcs, NURBS curves and dwells, of three axes and of the tip under kinematics, through
//                    changes of chunk and a starvation
//   cycle sabotage   the same, with one allocation while a word is made: has to fail

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <mixed_paths.hpp>

#include "forbidden_calls.hpp"

namespace {

using namespace leadscrew;
using namespace testing_support;
using interpolator::Controller;

}  // namespace

extern "C" {

/// For the check of machine code: what it has to find. Volatile, so that nothing of it is optimised away.
void* volatile allocated = nullptr;
double (*volatile any_function)(double) = nullptr;

[[gnu::noinline]] base::Word cycle_that_allocates(Controller& controller) {
  allocated = ::operator new(24);
  return controller.next();
}
[[gnu::noinline]] double cycle_that_calls_through_a_pointer(Controller& controller) {
  return any_function(controller.next().feed) + 1;
}
[[gnu::noinline]] double cycle_that_leaves_through_a_pointer(double feed) {
  return any_function(feed);
}

}  // extern "C"

namespace {

enum class Sabotage : std::uint8_t { none, allocation };

/// One word, watched.
base::Word watched_word(Controller& controller, Sabotage sabotage) {
  watch().armed = true;
  const base::Word word = sabotage == Sabotage::allocation ? cycle_that_allocates(controller) : controller.next();
  watch().armed = false;
  return word;
}

struct Count {
  std::int64_t words = 0, events = 0, starvations = 0, begun = 0;
};

/// Words and their events until nothing is left to do.
void make_words(Controller& controller, Count& count) {
  do {
    watched_word(controller, Sabotage::none);
    ++count.words;
    watch().armed = true;
    while (controller.next_event() != nullptr) ++count.events;
    watch().armed = false;
  } while (!controller.idle());
}

/// Starved behind every chunk of a path, and anew from there; false where chunks and events do not agree.
bool travel(const Path& path, Count& count) {
  const auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.03);
  Controller controller(path_period, {}, 4 * cuts.size());
  // With an event before each, and one where it begins.
  const auto offer = [&](planner::Chunk chunk) {
    chunk.events.resize(2);
    chunk.events.front().s = -1;
    if (!chunk.pieces.empty()) {
      chunk.events.back().piece = chunk.segments.front().piece;
      chunk.events.back().s = chunk.first_state().s;
    }
    if (controller.offer(chunk) != Controller::Offer::accepted) std::abort();
  };
  Count here;
  for (std::size_t last = 0; last + 1 < cuts.size(); ++last) {
    for (std::size_t k = 0; k <= last; ++k) offer(cuts[k].chunk);
    make_words(controller, here);
    const auto again = cut_motion(path, cuts[last].rest, path.length(), path_speed, path_jerk, 0.02);
    if (path.length() - cuts[last].rest > 1e-9) {
      for (const CutChunk& cut : again) offer(cut.chunk);
    }
    offer(dwell(path.at(path.length()), 0.05));
    offer({});
    make_words(controller, here);
  }
  count.words += here.words;
  count.events += here.events;
  count.starvations += controller.starvations();
  count.begun += controller.begun();
  return here.events == 2 * controller.begun();
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (!counts_each_function()) {
    std::puts("the counting does not count");
    return 2;
  }
  Count count;
  bool agree = travel(mixed_path(), count);
  for (const machine::KinematicsPreset& preset : machine::kinematics_presets) {
    machine::RotaryChain chain = *machine::preset_chain(preset.name);
    chain.axes[0].point = {3, -5, -50};
    agree &= travel(posed_path(chain), count);
    if (preset.name != "head-head-bc") continue;
    chain.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};  // nutating
    agree &= travel(posed_path(chain), count);
  }
  if (argument_count > 1 && std::strcmp(arguments[1], "sabotage") == 0) {
    Controller controller(path_period, {}, 4);
    watched_word(controller, Sabotage::allocation);
  }
  std::printf("%lld words, %lld events, %lld starvations, %lld chunks: %s\n", static_cast<long long>(count.words),
              static_cast<long long>(count.events), static_cast<long long>(count.starvations),
              static_cast<long long>(count.begun), told(watch()).c_str());
  return watch().calls == 0 && agree ? 0 : 1;
}
