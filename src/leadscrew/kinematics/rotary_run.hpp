#pragma once
// Rotary angles for all directions of a connected run, chosen together.
//
// A direction has two solutions, and each angle may be whole turns away. Whoever takes the nearest one each time may meet an
// end of travel behind which there is no way on, though another beginning would have led through. So the choice is made over
// the whole run, once it is known: of all ways through its vertices inside travel, the one of least
//
//     cost = Σ over vertices and axes of (Δθ/v)²        v: the axis' greatest velocity; the first Δθ is that from `before`
//
// From vertex to vertex an angle goes the shorter way round; a run is subdivided so finely that this is meant. A way stays on
// its side, first or second solution, but where the other side is as straight: where linear motion of both axes leads the tool
// within the tolerance of the great circle in the middle, as it does at a pole. At the pole itself the first angle stays what it
// was.
//
// Ways are kept as they are relative to their beginning, with how far each axis has gone, least and greatest; which whole turns
// the beginning may be at follows from those, so that travel of hundreds of turns costs nothing. Of ways that meet, those
// that cost more and leave no other turns open are dropped. That is exact dynamic programming (Bellman), but where more than
// most_ways stay open at one vertex, which takes many crossings of poles in travel of many turns: then the costliest are given
// up. Time and memory grow in proportion to vertices and open ways, two as long as no pole is near: 24 bytes each.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>
#include <vector>

namespace leadscrew::kinematics {

/// Of both rotary axes, in the order of Chain::turns().
struct RotaryLimits {
  Angles<double> travel_min{}, travel_max{};  ///< degrees
  Angles<double> velocity{};                  ///< degrees/s; > 0

  friend bool operator==(const RotaryLimits&, const RotaryLimits&) = default;
};

/// Those of a machine that has the chain's axes.
RotaryLimits limits_of(const machine::Machine& machine, const Chain& chain);

/// Why a run cannot be done.
struct RunFailure {
  enum class Kind : std::uint8_t {
    out_of_reach,  ///< no angles hold the tool so
    travel,        ///< no way that keeps inside travel leads to this vertex
    too_long,      ///< more vertices than most_nodes have room
  };
  Kind kind = Kind::out_of_reach;
  std::size_t vertex = 0;           ///< from 0: the farthest that some way has led to, and one more
  double miss = 0;                  ///< of out_of_reach: by so many degrees
  base::Axis axis = base::Axis::A;  ///< of travel: the axis that has too little, on the cheapest way
};

/// A run that is being told, direction by direction.
class RotaryRun {
 public:
  static constexpr std::size_t most_ways = 64;                     ///< open at one vertex
  static constexpr std::size_t most_nodes = std::size_t{1} << 22;  ///< in all

  /// `before`: where the axes are. `tolerance`: degrees, how far from the great circle a change of sides may lead.
  RotaryRun(const Chain& chain, const RotaryLimits& limits, const Angles<double>& before, double tolerance)
      : chain_(chain), limits_(limits), before_(before), tolerance_(tolerance) {}

  /// Instead of the first direction: the run goes on from where the axes are, degrees, and no turn is open. Inside travel.
  void begin_at(const Angles<double>& angles);

  /// The next direction from the tip to the spindle, seen from the workpiece; finite, not 0. False where the run cannot be done;
  /// nothing is taken from then on.
  bool add(const Vector& direction);
  /// The same of a unit vector with its solutions.
  bool add(const Vector& unit, const Solutions<double>& found);

  /// Where it cannot be done.
  const std::optional<RunFailure>& failure() const { return failure_; }
  /// Were all ways kept that might be the best?
  bool is_exact() const { return is_exact_; }
  /// Of the best way, s².
  double cost() const;
  /// Of the best way, degrees, at each vertex; of those that are not decided.
  std::vector<Angles<double>> angles() const;
  /// Vertices that are not decided.
  std::size_t size() const { return count_; }
  /// Decides the first `count` vertices, less than size(), by the best way so far, and gives their angles. What follows goes on
  /// from there: no longer the best of all ways, but in bounded memory.
  std::vector<Angles<double>> decide(std::size_t count);

 private:
  enum class Side : std::uint8_t { first, second, pole };
  struct Node {
    Angles<double> angles{};
    std::uint32_t parent = 0;
  };
  struct Way {
    Angles<double> now{}, low{}, high{};  ///< relative to the beginning as the solution told it
    double cost = 0;
    std::uint32_t node = 0;
    Side side = Side::first;
    std::size_t start = 0;  ///< of starts_
  };
  /// A way with the whole turns that its beginning is at.
  struct Choice {
    const Way* way = nullptr;
    Angles<double> turns{};  ///< degrees to add
    double cost = 0;
  };

  void begin(const Solutions<double>& found, std::vector<Way>& ways);
  void extend(const Way& way, const Solutions<double>& found, const Vector& middle, std::vector<Way>& ways);
  void step(const Way& way, const Angles<double>& to, Side side, const Vector& middle, std::vector<Way>& ways);
  void keep(const Way& way, std::vector<Way>& ways);
  void prune(std::vector<Way>& ways);
  void record(std::vector<Way>& ways);
  bool is_straight(const Angles<double>& from, const Angles<double>& to, const Vector& middle) const;
  Choice best() const;
  void fail(RunFailure::Kind kind, double miss = 0);
  std::array<double, 2> turns_of(const Way& way, std::size_t axis) const;
  std::uint32_t node_of(const Way& way, std::size_t vertex) const;
  void forget(std::size_t count);

  Chain chain_;
  RotaryLimits limits_;
  Angles<double> before_;
  double tolerance_;
  std::vector<Way> ways_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> first_nodes_;  ///< of each vertex
  std::vector<Angles<double>> starts_;
  Vector last_{};  ///< direction, of length 1
  std::size_t count_ = 0;
  double cheapest_lost_ = 0;  ///< of the ways that travel ended at this vertex
  base::Axis lost_axis_ = base::Axis::A;
  std::optional<RunFailure> failure_;
  bool is_exact_ = true;
  bool is_begun_ = false;  ///< the beginning stands, and its turns
};

}  // namespace leadscrew::kinematics
