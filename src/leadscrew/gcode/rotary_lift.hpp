#pragma once
// Which of both solutions, and how many whole turns away, rotary axes are while a tool goes over a whole surface.
//
// Both solutions are followed through all directions, each angle the shorter way round from the one before, and how far they go
// is kept. A tool on a surface keeps to one solution, but where it goes straight through a pole: at its end the way is known that costs least and stays inside travel, its
// beginning near to where the axes are. That is kinematics::RotaryRun without changes of side, in constant memory.

#include <leadscrew/kinematics/rotary_run.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <optional>

namespace leadscrew::gcode {

class RotaryLift {
 public:
  using Angles = kinematics::Angles<double>;

  /// `before`: where the axes are, degrees.
  RotaryLift(const kinematics::Chain& chain, const kinematics::RotaryLimits& limits, const Angles& before)
      : chain_(chain), limits_(limits), before_(before) {}

  /// The tool goes along all of it. False where no angles hold it so: miss().
  bool add(const surfaces::Pass& pass);
  /// By so much a direction was out of reach, degrees.
  double miss() const { return miss_; }
  /// u and v of that place.
  std::array<double, 2> place() const { return place_; }

  struct Choice {
    std::size_t side = 0;  ///< of kinematics::Solutions
    Angles start{};        ///< degrees
  };
  /// None where every way leaves travel: lost_axis().
  std::optional<Choice> best();
  base::Axis lost_axis() const { return lost_axis_; }

 private:
  struct Way {
    Angles start{}, now{}, low{}, high{};
    double cost = 0;
    std::size_t side = 0;  ///< where it has come to
  };
  struct Step {
    Angles change{};
    std::size_t side = 0;
  };
  /// Of each way; at a pole the side is open.
  struct Steps {
    std::array<Step, 2> of_way{};
    bool is_pole = false;
    double greatest() const;
  };

  std::optional<Steps> steps_to(const kinematics::Vector& direction, bool any_side);
  bool add_place(const surfaces::PassNode& node, const kinematics::Vector& direction);
  bool add_between(const surfaces::PassNode& from, const surfaces::PassNode& to);
  void go(const Steps& steps);

  kinematics::Chain chain_;
  kinematics::RotaryLimits limits_;
  Angles before_{};
  std::array<Way, 2> ways_;
  bool is_begun_ = false;
  bool is_in_pole_ = false;
  double miss_ = 0;
  std::array<double, 2> place_{};
  base::Axis lost_axis_ = base::Axis::A;
};

}  // namespace leadscrew::gcode
