#pragma once
// A path of a tool's tip and direction (surfaces::Pass) as NURBS curves of the tip and the rotary axes.
//
//     nodes: tip(t), axis(t) with two derivatives ──solutions on jets──▶ angles(t) with two derivatives ──▶ quintics, C2
//
// Between two nodes the angles' quintics hold the tool along the path's own direction to within axis_tolerance; where they do not,
// as near a pole of the rotary axes, a node is put between. The path keeps to one of both solutions, but where it goes straight
// through a pole: there the other one goes on as smoothly. At a pole itself solutions have no derivatives; the angles there are
// those between a place before it and one behind.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

/// Why rotary axes cannot follow.
struct PoseFailure {
  enum class Kind : std::uint8_t {
    pole,          ///< the tool's direction comes so near to a pole that no axis can follow
    out_of_reach,  ///< no angles hold the tool so
  };
  Kind kind = Kind::pole;
  double u = 0, v = 0;  ///< of the surface
  double miss = 0;      ///< of out_of_reach: by so many degrees
};

class PosePath {
 public:
  using Angles = kinematics::Angles<double>;
  static constexpr double axis_tolerance = 2e-10;            ///< radians
  static constexpr double link_tolerance = 1e-5;             ///< the same of links, which touch nothing
  static constexpr double least_part = 1e-4;                 ///< of t: nearer to each other nodes are not put
  static constexpr double least_part_of_link = 1e-5;         ///< the same of links
  static constexpr std::size_t most_nodes_in_all = 1 << 16;  ///< of one pass

  /// Rotary axes stand where they are.
  void stand() { chain_ = nullptr; }
  /// They hold the tool, on one side of kinematics::Solutions, and go on from these angles, degrees, which hold it where the first
  /// pass begins. The chain must outlive the path.
  void follow(const kinematics::Chain& chain, std::size_t side, const Angles& angles) {
    chain_ = &chain;
    side_ = side;
    angles_ = angles;
    end_.reset();
  }

  /// The next pass or link, which begins where the one before ends; all of the one before has been taken.
  std::optional<PoseFailure> load(surfaces::Pass pass);
  /// Is there anything to take?
  bool any() const { return next_ + 1 < nodes_.size(); }
  bool is_link() const { return is_link_; }
  std::size_t number() const { return number_; }
  void clear() { nodes_.clear(); }
  /// Where the rotary axes are while the next curve begins, if they follow.
  void set_angles(base::AxisVector& place) const;

  /// The next curve, from the place where the program stands: all axes that the path does not tell stay. `with_contact`: it tells
  /// where the tool touches.
  void take(NurbsCurve& curve, const base::AxisVector& from, bool with_contact);
  /// Of the curve taken last: are the machine's axes surely inside these limits? The path is that of the tip.
  bool is_inside(const kinematics::Transformation& transformation, const base::AxisVector& low,
                 const base::AxisVector& high) const;

 private:
  using Jet = surfaces::PassNode::Jet;
  struct Node {
    surfaces::PassNode place;
    kinematics::Angles<Jet> angles{};
    bool is_given = false;  ///< the angles, which are not those of a solution
  };

  /// Of a node's direction, once they are asked for.
  using Known = std::optional<kinematics::Solutions<Jet>>;
  /// A node that is to be reached.
  struct Waiting {
    Node node;
    Known solutions{};
  };

  std::optional<PoseFailure> hold(Node& node, std::size_t side, const Angles& before, Known& solutions) const;
  static void go_on_from(const Angles& before, Node& node);
  std::optional<PoseFailure> hold_through_pole(Node& node, const surfaces::PassNode* before,
                                               const surfaces::PassNode* behind, const Angles& angles) const;
  bool is_in_pole(const surfaces::PassNode& place) const;
  bool joins(const Node& first) const;
  bool is_reached(const Node& at, Waiting& waiting, std::optional<PoseFailure>& failure);
  std::optional<PoseFailure> add_first(surfaces::PassNode place, const surfaces::PassNode& behind);
  std::optional<PoseFailure> add_between(const Node& from, const Node& to);
  bool is_held(const Node& a, const Node& b) const;
  static Angles angles_of(const Node& node) { return {node.angles[0][0], node.angles[1][0]}; }

  const kinematics::Chain* chain_ = nullptr;
  std::size_t side_ = 0;
  Angles angles_{};          ///< where the path begins
  std::optional<Node> end_;  ///< where it has come to
  std::vector<Node> nodes_;
  std::size_t next_ = 0;        ///< the curve that is taken next begins there
  std::size_t taken_from_ = 0;  ///< the one taken last began there
  base::AxisVector others_{};   ///< of it: coordinates of axes that the path does not tell
  bool is_link_ = false;
  std::size_t number_ = 0;
};

}  // namespace leadscrew::gcode
