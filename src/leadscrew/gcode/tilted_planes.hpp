#pragma once
// Tilted working planes: G68.2, G68.4, which tells one in that in force, G268 of Haas, and G69, G269, which end them; G53.1, G253 of Haas, which turns the rotary
// axes until the tool is along the plane's normal. What moves are in such a plane is told by Frame.
//
// While a plane is in force every place that the program gives is one of the tool's tip in the plane, however the rotary
// axes stand; where they turn, in a block of their own, X, Y and Z of the machine stand still, and the coordinates of the
// tip become others. So G53.1 (Fanuc) and a turn that the program gives itself lead to the same.

#include <leadscrew/gcode/outbox.hpp>
#include <leadscrew/gcode/tilted_plane.hpp>
#include <leadscrew/gcode/travel.hpp>
#include <leadscrew/kinematics/pose.hpp>

namespace leadscrew::gcode {

class TiltedPlanes : Part {
 public:
  TiltedPlanes(const Context& context, Travel& travel, Outbox& outbox)
      : Part(context), travel_(travel), outbox_(outbox) {}

  /// G68.2, G68.4, G268, G69 and G269; of any other block that a plane of several blocks is finished.
  void set(const Block& block);
  /// G53.1, G253.
  void orient(const Block& block);
  /// Has a plane of several blocks been begun?
  bool is_unfinished() const { return draft_.is_open; }
  /// What a block asks for that cannot be while a plane is tilted.
  void check(const Block& block);

 private:
  /// Of P2 and P3: what the blocks so far have given.
  struct Draft {
    bool is_open = false;
    int kind = 0;
    Code code = Code::none;
    std::array<std::optional<TiltedPlane::Vector>, 3> points, vectors;
  };

  bool can_begin(const Block& block);
  void begin(const Block& block);
  void begin_by_angles(const Block& block, int kind);
  void add(const Block& block, int kind);
  void put(const Block& block, const TiltedPlane& plane);
  std::optional<std::array<int, 3>> order_of(const Block& block);
  bool is_in_force(const Block& block) const;
  bool problem(std::uint32_t column, std::string message, std::string hint);
  std::optional<kinematics::Angles<double>> nearest(const Block& block, std::size_t side);
  std::optional<double> inside(std::size_t turn, double degrees) const;

  Travel& travel_;
  Outbox& outbox_;
  Draft draft_;
  bool is_refused_ = false;  // what came of it has been said
};

}  // namespace leadscrew::gcode
