#pragma once
// Which speeds moves ask for soon, so that a greatest speed that changes meanwhile can be kept by the feed's factor.

#include <algorithm>
#include <cstdint>
#include <deque>

namespace leadscrew::linuxcnc {

/// Of moves in their order; one thread's.
class SpeedsAhead {
 public:
  /// The next move: its speed, mm/s, 0 where the greatest speed is not for it; how many s it takes at least.
  void add(std::uint32_t number, double speed, double seconds) { moves_.push_back({number, speed, seconds}); }
  /// Motion has come to this move.
  void come_to(std::uint32_t number) {
    while (!moves_.empty() && moves_.front().number < number) moves_.pop_front();
  }
  /// The greatest speed of the move in motion and of those that may begin within so many s of its end, mm/s; 0 for none.
  double greatest(double seconds) const {
    double most = 0, passed = 0;
    for (auto move = moves_.begin(); move != moves_.end() && passed <= seconds; ++move) {
      most = std::max(most, move->speed);
      if (move != moves_.begin()) passed += move->seconds;
    }
    return most;
  }

 private:
  struct Move {
    std::uint32_t number;
    double speed, seconds;
  };
  std::deque<Move> moves_;
};

}  // namespace leadscrew::linuxcnc
