#pragma once
// Random programs of motion_core.sv, with the steps that pulse/ makes of them.

#include <random>

#include "core_bench.hpp"

namespace leadscrew::hardware {

struct Step {
  std::int64_t tick = 0;
  CorePulse pulse;

  friend bool operator==(const Step&, const Step&) = default;
};

inline CoreCommand with_feed(CoreCommand command, std::uint64_t feed) {
  command.feed = command.feed_diagonal = feed;
  return command;
}

/// Random lines, arcs and dwells with a feed each, and their steps by pulse/: the feed's remainder goes through.
struct RandomProgram {
  std::vector<CoreCommand> commands;
  std::vector<Step> steps;

  explicit RandomProgram(std::uint64_t seed) : random_(seed) {
    for (int block = 0; block < 40; ++block) {
      feed_word_ = draw(1, 8) == 1 ? capacity : draw(capacity / 40, capacity - 1);
      feed_.feed(feed_word_);
      switch (draw(0, 3)) {
        case 0:
          add_dwell(draw(1, 50));
          break;
        case 1:
          add_arc();
          break;
        default:
          add_line({draw(-40, 40), draw(-40, 40), draw(-40, 40)});
      }
    }
    commands.back().final = true;
  }

  std::int64_t ticks() const { return tick_; }

 private:
  static constexpr std::int64_t capacity = std::int64_t{1} << 40;

  std::int64_t draw(std::int64_t least, std::int64_t greatest) {
    return std::uniform_int_distribution<std::int64_t>(least, greatest)(random_);
  }
  void add_dwell(std::int64_t ticks) {
    CoreCommand dwell;
    dwell.count = ticks;
    dwell.dwell = true;
    commands.push_back(dwell);
    tick_ += ticks;
  }
  void add_line(const CoreVector& delta) {
    if (delta == CoreVector{}) return;
    commands.push_back(with_feed(line_command(delta), static_cast<std::uint64_t>(feed_word_)));
    make(line_of_pulse(delta), [](const CorePulse& pulse) { return pulse; });
  }
  void add_arc() {
    pulse::Arc arc{{draw(1, 50), draw(-50, 50)}, {}, pulse::Direction::clockwise};
    arc.end = {arc.start.y, -arc.start.x};
    std::vector<CoreCommand> octants;
    push_arc(octants, arc, 2, 0);
    for (const CoreCommand& octant : octants)
      commands.push_back(with_feed(octant, static_cast<std::uint64_t>(feed_word_)));
    make(CircleOfPulse(arc), [](const pulse::Pulse<2>& pulse) { return CorePulse{{pulse.step[1], 0, pulse.step[0]}}; });
  }
  template <typename State, typename Placed>
  void make(State state, const Placed& placed) {
    while (!state.done()) {
      ++tick_;
      if (feed_.step()) steps.push_back({tick_, placed(state.step())});
    }
  }

  std::mt19937_64 random_;
  pulse::FeedDda feed_{capacity, 0};
  std::int64_t feed_word_ = 0, tick_ = 0;
};

}  // namespace leadscrew::hardware
