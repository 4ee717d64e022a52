#pragma once
// Axes beside the plane of an arc go with it as along a straight line of which the circle is one component: a linear
// DDA has the circle's commands as its first integrand and clocks the circle by that one's overflows.

#include <leadscrew/pulse/linear.hpp>
#include <leadscrew/pulse/stretch.hpp>

namespace leadscrew::nc {

/// The circle's axes come first.
template <pulse::Interpolator Circle, std::size_t axes_beside>
class Helix {
 public:
  static constexpr std::size_t axes = Circle::axes + axes_beside;
  using Straight = pulse::LinearDda<1 + axes_beside>;

  constexpr Helix(const Circle& circle, const Straight& straight) : circle_(circle), straight_(straight) {}

  constexpr bool done() const {
    std::int64_t left = 0;
    for (std::size_t lane = 1; lane < Straight::axes; ++lane) left |= straight_.left(lane);
    return left == 0 && circle_.done();
  }

  constexpr pulse::Pulse<axes> step() {
    // Where it takes more commands than were counted the circle goes on by itself.
    const bool circle_is_late = straight_.left(0) == 0;
    return step(circle_, straight_, circle_is_late);
  }

  template <typename Registers>
  struct Stretch {
    Registers circle;
    Straight straight;

    constexpr bool goes_on() const { return circle.goes_on() && straight.left(0) > 0; }
    constexpr pulse::Pulse<axes> step() { return Helix::step(circle, straight, false); }
  };
  constexpr auto stretch() const
    requires pulse::Stretched<Circle>
  {
    return Stretch<decltype(circle_.stretch())>{circle_.stretch(), straight_};
  }
  template <typename Registers>
  constexpr void give_back(const Stretch<Registers>& stretch) {
    circle_.give_back(stretch.circle);
    straight_ = stretch.straight;
  }

  constexpr const Circle& circle() const { return circle_; }
  constexpr const Straight& straight() const { return straight_; }

 private:
  template <typename Around>
  static constexpr pulse::Pulse<axes> step(Around& circle, Straight& straight, bool circle_is_late) {
    const auto along = straight.step();
    pulse::Pulse<Circle::axes> around;
    if (circle_is_late || along.step[0] != 0) around = circle.step();
    pulse::Pulse<axes> pulse;
    for (std::size_t i = 0; i < Circle::axes; ++i) pulse.step[i] = around.step[i];
    for (std::size_t i = 0; i < axes_beside; ++i) pulse.step[Circle::axes + i] = along.step[1 + i];
    return pulse;
  }

  Circle circle_;
  Straight straight_;
};

}  // namespace leadscrew::nc
