#pragma once
// From tool vectors to angles of the rotary axes: a connected run of lines of the tool's tip, along each of which the tool's
// direction turns along a great circle.
//
// Motion leads the rotary axes straight from vertex to vertex, so that each line is subdivided until that is nearly the great
// circle: the tool leaves it by no more than a 64th of E, and no axis moves by more than a degree. Which of the two solutions
// holds the tool, and in which turn, is chosen over all vertices together (RotaryRun). On the exact path, where a spline goes
// through the vertices of a line, parts grow no faster than twofold in every four.
//
//     programmed   P₀,O₀ ───────────── P₁,O₁ ── P₂,O₂           tip straight, direction on a great circle
//     vertices     •──•──•──•──•──•──•──•──•────•               tip and angles straight
//
// Poles, where the first axis may stand anywhere: blended paths are led straight through those that they miss by no more than
// the cone and seven eighths of E (pole_passes.hpp). Paths that pass farther away go round, as slowly as limits make them.
// Where a path turns at the pole itself, the first axis turns while the tip stands, but where little of E is lost by turning it
// on the way. Three quarters of what a pass leaves of E are for the smoother, told with each vertex (RunVertex::tolerance);
// programmed direction and motion differ by no more than E in all.
//
// A run is told line by line. At most most_vertices are held, and where more come the front half is decided by the best way so
// far. Lines wait until it is known whether a pole lies within 50 mm ahead (PolePasses), 65 536 of them at most: behind so many
// that stay within the cone the path goes round.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pole_passes.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/kinematics/rotary_run.hpp>
#include <optional>
#include <vector>

namespace leadscrew::kinematics {

/// How a run is to be travelled.
struct VectorRunSettings {
  double orientation_tolerance = 0.05;  ///< E, degrees; > 0, also of an exact path: how finely it is subdivided
  double pole_cone = 0.1;               ///< so near a pole motion may lead straight through it, degrees; ≥ 0
  bool blends = true;                   ///< G64; else the exact path
};

/// The end of a line in the space of the tip and the rotary axes.
struct RunVertex {
  Vector tip{};               ///< in the workpiece, mm
  Angles<double> angles{};    ///< degrees, in the order of Chain::turns()
  std::size_t segment = 0;    ///< the programmed line that it belongs to, counted by add() from 0
  double tolerance = 0;       ///< what is left of E for the smoothing of this line, degrees; > 0
  bool is_pole_turn = false;  ///< the first axis alone turns, at a pole, while the tip stands
};

/// Why a run cannot be done.
struct VectorRunFailure {
  enum class Kind : std::uint8_t {
    out_of_reach,    ///< no angles hold the tool so
    travel,          ///< no way that keeps inside travel leads there
    pole_too_sharp,  ///< more parts of one line than most_parts
    opposite,        ///< the direction turns by half a turn: no plane is told
  };
  Kind kind = Kind::out_of_reach;
  std::size_t segment = 0;          ///< counted by add() from 0
  double miss = 0;                  ///< of out_of_reach: by so many degrees
  base::Axis axis = base::Axis::A;  ///< of travel: the axis that has too little, on the cheapest way
};

/// A run that is being told.
class VectorRun {
 public:
  static constexpr std::size_t most_parts = std::size_t{1} << 12;     ///< of one line
  static constexpr std::size_t most_vertices = std::size_t{1} << 16;  ///< held at once

  VectorRun(const Chain& chain, const RotaryLimits& limits, const VectorRunSettings& settings);

  /// The run goes on from where the axes are: the angles stay what they are.
  void begin_at(const Vector& tip, const Angles<double>& angles);
  /// A rapid has led there: the angles of the beginning are chosen with all others, near to `before`. False where no angles
  /// hold the tool so.
  bool begin_free(const Vector& tip, const Vector& direction, const Angles<double>& before);

  /// After one of these: the next line, to the tip (mm, in the workpiece) and the direction from there to the spindle, seen from the workpiece:
  /// finite, not 0, of any length. False where the run cannot be done; nothing is taken from then on.
  bool add(const Vector& tip, const Vector& direction);

  /// Where it cannot be done.
  const std::optional<VectorRunFailure>& failure() const { return failure_; }

  /// Vertices decided so far and not yet taken: mostly none, before finish().
  std::vector<RunVertex> take();
  /// No line follows: decides all, so that take() gives the rest. False where the run cannot be done; what lies before the
  /// line at fault is given then.
  bool finish();
  /// Of the beginning, where it was free; known once take() has given a vertex, or after finish().
  const Angles<double>& start_angles() const { return start_angles_; }

 private:
  struct Programmed {
    Vector tip{}, direction{};
    std::size_t segment = 0;  ///< that ends there
    double s = 0;
  };
  struct Vertex {
    Vector tip{}, direction{};
    std::size_t segment = 0;
    double tolerance = 0;  ///< of the line that ends there
    double s = 0;
    bool is_pole = false;
  };

  bool follow(bool all);
  bool subdivide(const Programmed& from, const Programmed& to);
  bool append(const Vertex& vertex);
  void decide(std::size_t count);
  std::size_t end_of_poles(std::size_t first, std::size_t count) const;
  void put_poles(std::size_t first, std::size_t end, const std::vector<Angles<double>>& angles);
  void put(const Vertex& vertex, const Angles<double>& angles, bool is_pole_turn);
  double turning_error(const Vector& direction, double turn) const;
  bool fail(VectorRunFailure::Kind kind, std::size_t segment);
  bool fail(const RunFailure& failure, std::size_t segment);

  Chain chain_;
  RotaryLimits limits_;
  VectorRunSettings settings_;
  std::optional<RotaryRun> choice_;
  PolePasses passes_;
  std::deque<Programmed> ahead_;  ///< the first: as far as vertices have been made
  std::deque<Vertex> vertices_;   ///< given to choice_, not yet decided
  std::vector<RunVertex> decided_;
  std::size_t segments_ = 0;
  Solutions<double> last_found_;  ///< at the last of vertices_
  bool is_free_ = false;          ///< the beginning
  bool is_start_known_ = false;   ///< has it been decided?
  Vector last_direction_{};       ///< of the last vertex that is decided
  double last_s_ = 0;
  Angles<double> start_angles_{};
  std::optional<VectorRunFailure> failure_;
};

}  // namespace leadscrew::kinematics
