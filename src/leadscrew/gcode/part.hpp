#pragma once
// What every part of the interpreter works with.

#include <leadscrew/gcode/block.hpp>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/modal_state.hpp>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/gcode/parameters.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <utility>

namespace leadscrew::gcode {

/// All of it must outlive the parts.
struct Context {
  const machine::Machine& machine;
  machine::ToolTable& tools;  ///< the program's own: G10 changes it
  const ReaderOptions& options;
  Parameters& parameters;
  Frame& frame;
  Reporter& reporter;
  ModalState& modal;
};

/// The base of the parts: the context, and what is short to say about it.
class Part {
 protected:
  explicit Part(const Context& context)
      : machine_(context.machine),
        tools_(context.tools),
        options_(context.options),
        parameters_(context.parameters),
        frame_(context.frame),
        reporter_(context.reporter),
        modal_(context.modal),
        machine_letters_(letters_of(context.machine)) {}
  ~Part() = default;
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  [[gnu::cold]] bool error(std::string_view code, std::uint32_t column, std::string message, std::string hint) {
    return reporter_.error(code, column, std::move(message), std::move(hint));
  }
  /// As the program's dialect calls it: "G38.2"; G32 of Fanuc's lathes for G33.
  [[gnu::cold]] std::string name(Code code) const { return gcode::name(code, options_.dialect); }
  /// In the contour of a cycle, codes of other groups than these do nothing, nor do S and T. Warning: `bad-contour`.
  [[gnu::cold]] void tell_idle_in_contour(const Block& block, std::uint32_t groups) {
    const auto tell = [&](std::uint32_t column, const std::string& what) {
      reporter_.warning("bad-contour", column, what + " in a contour does nothing", "before the cycle, or behind it");
    };
    for (std::size_t i = 0; i < index(Group::count); ++i) {
      const Group group = static_cast<Group>(i);
      if (block.has(group) && !(bit(group) & groups)) tell(block.column_of(group), name(block.code(group)));
    }
    for (const char letter : {'S', 'T'}) {
      if (block.has(letter)) tell(block.column_of(letter), std::string(1, letter));
    }
  }
  /// Behind G40 the tool stands beside the contour: whether it does, where `what` needs it where the program stands, and then
  /// reported. Error: `cutter-exit`.
  [[gnu::cold]] bool fails_beside_contour(std::uint32_t column, const std::string& what) {
    if (!modal_.tool_is_aside) return false;
    error("cutter-exit", column, what + " before a move behind G40",
          "a line of G0 or G1 before it, which leads to where the program says");
    return true;
  }

  const machine::Machine& machine_;
  machine::ToolTable& tools_;
  const ReaderOptions& options_;
  Parameters& parameters_;
  Frame& frame_;
  Reporter& reporter_;
  ModalState& modal_;
  const std::uint32_t machine_letters_;  // of the axes that the machine has

 private:
  static std::uint32_t letters_of(const machine::Machine& machine) {
    std::uint32_t letters = 0;
    for (const base::Axis axis : base::all_axes) {
      if (machine.has(axis)) letters |= letter_bit(base::letter(axis));
    }
    return letters;
  }
};

/// Where a problem of the block's motion is shown: its code, or the first word.
inline std::uint32_t motion_column(const Block& block) {
  return block.has(Group::motion) ? block.column_of(Group::motion) : block.first_column;
}

}  // namespace leadscrew::gcode
