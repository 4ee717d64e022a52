#pragma once
// A tool that moves among surfaces: where on its way it reaches deepest into them.
//
// No place of a part moves farther than the tip and its height above the tip times the turn of the axis. So a part that is
// c > 0 away from all surfaces may move by c before it is looked at again, and has not touched anything between. A part that
// touches, as a cutter does along its passes, is looked at so often that between two looks no place is deeper inside it than
// at both by more than an eighth of the tolerance: where it is round with the radius ρ and moves by δ that is δ²/(8 ρ), and where a
// flat tool moves along its axis by δ_z, no more than δ_z/2, for which half a tolerance is allowed.

#include <functional>
#include <leadscrew/gouging/workpiece.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gouging {

/// A piece of the tool's way.
struct Way {
  std::function<Pose(double)> at;  ///< by t, 0 … 1
  /// So much of t is no more than a bend of half a radian, 0 … 1.
  double most_step = 1;
};

/// Where a tool reaches deepest into the surfaces, or comes nearest to them.
struct Deepest {
  Hit hit;
  Part part;
  Pose pose;
  double t = 0;  ///< of the way
};

class Sweep {
 public:
  /// The workpiece must outlive it. tolerance: mm; > 0.
  Sweep(const Workpiece& workpiece, double tolerance) : workpiece_(workpiece), tolerance_(tolerance) {}

  /// Another tool, from now on.
  void hold(const Tool& tool);

  /// All of a way of the tool that is held; where another begins elsewhere than this one has ended, all parts are looked at
  /// there. None where nothing had to be looked at. Work is bounded by the way's length over the tolerance, and by most_looks.
  std::optional<Deepest> follow(const Way& way);
  /// Where the last way has ended, of the part that is nearest to the surfaces or deepest in them; a lower bound where none touches
  /// them, infinite before any way. mm.
  double distance_at_end() const;

  /// Of one way: a part is looked at so many times at most; ways that would take more are looked at in longer steps.
  static constexpr int most_looks = 1 << 20;
  std::int64_t looks() const { return looks_; }  ///< so far

 private:
  struct PartState {
    Part part;
    double distance = 0;  ///< when it was looked at last, mm
    double moved = 0;     ///< since then, no place of it more than that, mm
    double used = 0;      ///< since then, of the way that a part that touches may go: 1: all
    std::uint32_t near = Hit::no_cell;

    double clearance() const { return distance > 0 ? distance : 0; }
  };
  void look(PartState& state, const Pose& pose, double t);
  double share_after(const PartState& state, const Pose& from, const Pose& to) const;
  double step_to(const Way& way, double t, double step, double& share) const;
  void advance(const Pose& to);

  const Workpiece& workpiece_;
  double tolerance_;
  std::vector<PartState> parts_;
  std::optional<Pose> pose_;
  std::optional<Deepest> deepest_;
  std::int64_t looks_ = 0;
};

}  // namespace leadscrew::gouging
