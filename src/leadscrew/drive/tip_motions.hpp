#pragma once
// How far words lead the tool's tip in a period, and how fast slides that follow them carry it.

#include <cmath>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/servo/servo.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <optional>

namespace leadscrew::drive {

class TipMotions {
 public:
  /// In the order of time, one a period, with the tool of now; none where feed is not counted by the tip.
  std::optional<servo::TipMotion> next(const kinematics::WordPoses& poses, const servo::Followed& followed) {
    const auto speed = poses.tip_speed(followed.position, followed.velocity);
    if (!speed) {
      before_.reset();
      return std::nullopt;
    }
    const base::AxisVector tip = poses.of(followed.word.position)->tip;
    servo::TipMotion motion{0, *speed};
    if (before_) motion.travel = std::hypot(tip[0] - (*before_)[0], tip[1] - (*before_)[1], tip[2] - (*before_)[2]);
    before_ = tip;
    return motion;
  }

 private:
  std::optional<base::AxisVector> before_;
};

}  // namespace leadscrew::drive
