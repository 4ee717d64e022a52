#pragma once
// The factor of the feed that is in force: what a host asks for, as far as the program lets it (LinuxCNC manual, M48 to
// M53; G33: "feed override and feed hold are disabled").
//
//     factor = (feed override, or 1 behind M49 and M50 P0) · (adaptive feed behind M52, else 1)
//              · (of feeds per revolution, G95: how fast a simulated spindle turns, over S; else 1), 2 at most
//     0 where motion is held, but behind M53 P0
//     1 in step with the spindle (G33, G33.1, G76, G84, G74), whatever is asked for meanwhile, a hold, too: a thread would
//     be spoilt, a tap broken; but what is held before motion comes in step stays held
//
// What is not obeyed is remembered and counts as soon as the program allows it again.

#include <algorithm>
#include <leadscrew/base/event.hpp>

namespace leadscrew::planner {

/// What a program lets a host change, by the events that motion has passed. Threads tell it to each other in one
/// atomic, hence its alignment.
struct alignas(8) AllowedOverrides {
  bool feed = true;             ///< M48, M49, M50
  bool hold = true;             ///< M53
  bool adaptive = false;        ///< M52
  bool spindle = true;          ///< M48, M49, M51: the host's matter
  bool in_step = false;         ///< with the spindle: neither feed, hold nor adaptive feed count
  bool per_revolution = false;  ///< G95: the spindle's speed counts

  void pass(const base::Event& event) {
    using Kind = base::Event::Kind;
    switch (event.kind) {
      case Kind::overrides_on:
      case Kind::overrides_off:
        feed = spindle = event.kind == Kind::overrides_on;
        return;
      case Kind::feed_override:
        feed = event.value != 0;
        return;
      case Kind::spindle_override:
        spindle = event.value != 0;
        return;
      case Kind::feed_hold:
        hold = event.value != 0;
        return;
      case Kind::adaptive_feed:
        adaptive = event.value != 0;
        return;
      case Kind::spindle_in_step:
      case Kind::rigid_tap:
        in_step = event.value != 0;
        return;
      case Kind::feed_per_revolution:
        per_revolution = event.value != 0;
        return;
      default:
        return;
    }
  }

  friend bool operator==(const AllowedOverrides&, const AllowedOverrides&) = default;
};

inline constexpr double greatest_factor = 2;

/// What a host asks for.
struct AskedOverrides {
  double feed = 1;         ///< > 0 … 2
  double adaptive = 1;     ///< 0 … 1
  double spindle = 1;      ///< its speed over S; > 0 … 2
  bool hold = false;       ///< motion is to rest
  bool must_rest = false;  ///< whatever the program says

  /// 0 … 2; `before` was in force until now.
  double factor(const AllowedOverrides& allowed, double before) const {
    if (must_rest) return 0;
    if (allowed.in_step) return hold && before == 0 ? 0 : 1;
    if (hold && allowed.hold) return 0;
    const double by_host = (allowed.feed ? feed : 1) * (allowed.adaptive ? adaptive : 1);
    return allowed.per_revolution ? std::min(by_host * spindle, greatest_factor) : by_host;
  }
};

}  // namespace leadscrew::planner
