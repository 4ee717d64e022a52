#pragma once
// What a program says that runs and is surely not meant: `check --lint`. What is seen in values alone, parameters that
// were never set, the reader tells (ReaderOptions::warns_of_unset).

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/modal_state.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace leadscrew::language {

/// Sees the moves of a program in order. The stock's top is Z0 of the program, or as given.
class Lint {
 public:
  /// `stock_top`: Z of the program, mm. A machine that must outlive this.
  explicit Lint(const machine::Machine& machine, std::optional<double> stock_top = {})
      : machine_(machine), stock_top_(stock_top.value_or(0)) {}

  /// What is wrong with a move, as warnings without a place: `lint-no-tool`, `lint-spindle-off`, `lint-rapid`,
  /// `lint-feed-unit`; the first few of each. `frame` and `modal` are those of its block.
  std::vector<base::Diagnostic> see(const gcode::Move& move, const gcode::Frame& frame, const gcode::ModalState& modal);

 private:
  void see_event(const base::Event& event);
  void see_feed(const gcode::Move& move, double top, const gcode::ModalState& modal);
  void see_rapid(const gcode::Move& move, double top);
  void see_unit(const gcode::Move& move, const gcode::Frame& frame);
  void warn(std::string_view code, std::string message, std::string hint);

  const machine::Machine& machine_;
  double stock_top_;
  bool has_tool_ = false;
  bool spindle_on_ = false;
  bool told_of_spindle_ = false;
  // The deepest cut where the tool stands: a rapid back into a hole is none into the work.
  double x_ = 0, y_ = 0, depth_ = std::numeric_limits<double>::infinity();
  std::map<std::string_view, int> told_;
  std::vector<base::Diagnostic> found_;
};

}  // namespace leadscrew::language
