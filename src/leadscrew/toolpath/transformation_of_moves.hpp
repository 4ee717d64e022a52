#pragma once
// What lies between the places that moves name and the machine's axes.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/machine/machine.hpp>
#include <memory>

namespace leadscrew::toolpath {

/// Of one move after the other: made anew only where it changes.
class TransformationOfMoves {
 public:
  /// The same as of the move before where nothing has changed; none for a move that is told in the axes. `machine` may be
  /// nullptr where no move is of the tip; else it has a chain of rotary axes.
  const std::shared_ptr<const kinematics::Transformation>& of(const gcode::Move& move,
                                                              const machine::Machine* machine) {
    if (!move.is_of_tip) {
      last_.reset();
    } else if (!last_ || last_->tool != move.tool) {
      last_ = std::make_shared<const kinematics::Transformation>(kinematics::chain_of(*machine), move.tool);
    }
    return last_;
  }

 private:
  std::shared_ptr<const kinematics::Transformation> last_;
};

}  // namespace leadscrew::toolpath
