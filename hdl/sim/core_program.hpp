#pragma once
// Random programs of motion_core.sv, with the steps that pulse/ makes of them.

#include <algorithm>
#include <random>

#include "core_bench.hpp"

namespace leadscrew::hardware {

struct Step {
  std::int64_t tick = 0;
  CorePulse pulse;

  friend bool operator==(const Step&, const Step&) = default;
};

inline CoreCommand with_feed(CoreCommand command, std::uint64_t feed) {
  command.feed = command.feed_straight = feed;
  return command;
}

/// The words of a command: at ticks after a step of the driving axis without unit 0, and at all others.
struct Feeds {
  std::int64_t plain = 0, straight = 0;
};

/// Random lines, arcs and dwells with two feeds each, and their steps by pulse/: the feed's remainder goes through.
struct RandomProgram {
  std::vector<CoreCommand> commands;
  std::vector<Step> steps;

  explicit RandomProgram(std::uint64_t seed) : random_(seed) {
    for (int block = 0; block < 40; ++block) {
      feeds_.plain = feeds_.straight = draw(1, 8) == 1 ? capacity : draw(capacity / 40, capacity - 1);
      if (draw(0, 1) == 0) feeds_.straight = draw(capacity / 40, capacity);
      switch (draw(0, 3)) {
        case 0:
          add_dwell(draw(0, 2) == 0 ? 1 : draw(2, 50));  // the queue gives a word a clock for those of one
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
    is_straight_ = false;
  }
  CoreCommand with_feeds(CoreCommand command) const {
    command.feed = static_cast<std::uint64_t>(feeds_.plain);
    command.feed_straight = static_cast<std::uint64_t>(feeds_.straight);
    return command;
  }
  void add_line(const CoreVector& delta) {
    if (delta == CoreVector{}) return;
    const CoreCommand line = with_feeds(line_command(delta));
    commands.push_back(line);
    const auto at_unit = std::find(line.source.begin(), line.source.end(), 2) - line.source.begin();
    make(
        line_of_pulse(delta), {line.count}, [](const CorePulse& pulse) { return pulse; },
        [at_unit](const CorePulse& pulse) {
          return at_unit != core_axes && pulse.step[static_cast<std::size_t>(at_unit)] != 0;
        });
  }
  void add_arc() {
    pulse::Arc arc{{draw(1, 50), draw(-50, 50)}, {}, pulse::Direction::clockwise};
    arc.end = {arc.start.y, -arc.start.x};
    std::vector<CoreCommand> octants;
    push_arc(octants, arc, 2, 0);
    std::vector<std::int64_t> counts;
    for (const CoreCommand& octant : octants) {
      commands.push_back(with_feeds(octant));
      counts.push_back(octant.count);
    }
    make(
        CircleOfPulse(arc), counts,
        [](const pulse::Pulse<2>& pulse) { return CorePulse{{pulse.step[1], 0, pulse.step[0]}}; },
        [](const CorePulse& pulse) { return pulse.step[0] != 0 && pulse.step[2] != 0; });
  }
  /// Steps of a path that is cut into commands of so many.
  template <typename State, typename Placed, typename IsDiagonal>
  void make(State state, const std::vector<std::int64_t>& counts, const Placed& placed, const IsDiagonal& is_diagonal) {
    for (std::int64_t left : counts) {
      while (left > 0) {
        ++tick_;
        feed_.feed(is_straight_ ? feeds_.straight : feeds_.plain);
        is_straight_ = false;
        if (!feed_.step()) continue;
        const CorePulse pulse = placed(state.step());
        is_straight_ = !is_diagonal(pulse);
        steps.push_back({tick_, pulse});
        --left;
      }
    }
  }

  std::mt19937_64 random_;
  pulse::FeedDda feed_{capacity, 0};
  Feeds feeds_;
  std::int64_t tick_ = 0;
  bool is_straight_ = false;  // a step at the last tick, without unit 0
};

}  // namespace leadscrew::hardware
