#pragma once
// Events on their way with the path: each is handed out with the chunk whose committed part passes its place, once,
// whatever slices, stops and refused chunks there are. They are counted, not compared by place: places are rounded.

#include <cstdint>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/overrides.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <vector>

namespace leadscrew::planner {

class TravellingEvents {
 public:
  /// The next piece of the path: numbers its events and says how far from the program's start they lie.
  void enter(toolpath::Piece& piece);
  /// Motion begins so far from the program's start, behind the events before this number.
  void begin_at(double path_length, std::int64_t number);
  /// Those on the chunk's pieces that no chunk before has handed out. `before`: to happen before it begins.
  void place(Chunk& chunk, const std::vector<base::Event>& before);
  /// An event that motion rests for, before the next chunk.
  void rest_for(const base::Event& event) { next_.pass(event); }
  /// Motion has come to rest by the tail of the chunk before the last.
  void refuse();
  /// What is allowed behind the last chunk.
  const AllowedOverrides& overrides() const { return next_.overrides; }
  /// There: S of a feed per revolution, revolutions per minute; 0 of other feeds.
  double speed_of_feed() const { return next_.speed_of_feed; }
  /// Motion has come to rest by the tail of the last chunk, and what was entered and lies behind is no more.
  void forget_rest();

 private:
  /// How far motion has come: along the path, the number of the first event that it has not passed, and what those
  /// before have allowed.
  struct Reached {
    double path_length = 0;
    std::int64_t number = 0;
    AllowedOverrides overrides{};
    double speed_of_feed = 0;

    void pass(const base::Event& event) {
      overrides.pass(event);
      if (event.kind == base::Event::Kind::feed_per_revolution) speed_of_feed = event.value;
    }
  };

  double entered_ = 0;          ///< path length of the pieces so far
  std::int64_t numbered_ = 0;   ///< events so far
  Reached next_;                ///< where the next chunk begins
  Reached rest_, rest_before_;  ///< where motion rests by the tail of the last chunk, and of the one before
};

}  // namespace leadscrew::planner
