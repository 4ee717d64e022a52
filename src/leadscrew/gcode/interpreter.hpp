#pragma once
// What blocks mean: the modal state of the program, and the moves and events each block makes of it, in the order of
// execution of NIST IR 6556, 3.8:
//
//     feed mode · F · S · T · M62 … M68 · M6 · M3 M4 M5 · M7 M8 M9 · G4 · plane · units · tool length · coordinate
//     system · path control · distance mode · retract mode · G10 G28 G30 G92 · motion · M0 M1 M2 M30
//
// So an F word is read in the units that held before its block. Which part does what a code says is in dispatch.cpp.

#include <leadscrew/gcode/block_check.hpp>
#include <leadscrew/gcode/circular_pocket.hpp>
#include <leadscrew/gcode/curves.hpp>
#include <leadscrew/gcode/cutter_compensation.hpp>
#include <leadscrew/gcode/cycles.hpp>
#include <leadscrew/gcode/directed_curve.hpp>
#include <leadscrew/gcode/engraving.hpp>
#include <leadscrew/gcode/lathe_cycles.hpp>
#include <leadscrew/gcode/machine_events.hpp>
#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/offsets.hpp>
#include <leadscrew/gcode/pecking_cycles.hpp>
#include <leadscrew/gcode/pocket_cycle.hpp>
#include <leadscrew/gcode/polar.hpp>
#include <leadscrew/gcode/probing.hpp>
#include <leadscrew/gcode/saved_modes.hpp>
#include <leadscrew/gcode/surface_moves.hpp>
#include <leadscrew/gcode/threading.hpp>
#include <leadscrew/gcode/tilted_planes.hpp>
#include <leadscrew/gcode/transforms.hpp>
#include <leadscrew/gcode/turning_cycles.hpp>
#include <leadscrew/gcode/vector_moves.hpp>

namespace leadscrew::gcode {

class Interpreter : Part {
 public:
  explicit Interpreter(const Context& context);

  /// What became of a block that execute_plain() was given.
  enum class Plain : std::uint8_t { no, no_move, move };

  /// Executes, more quickly than execute() does, what nearly all blocks are: axis words and F, with G0 or G1 or
  /// neither, and most arcs. `no`: the block is something else and has not been executed. The caller passes a block
  /// without problems.
  Plain execute_plain(const Block& block, base::Line line, Move& move);

  /// Executes any block. If it or its reading had a problem it makes no move, but what is known of it takes effect, so
  /// that one problem does not make others of the blocks behind it.
  void execute(const Block& block, base::Line line);

  /// The text between the brackets of the block that is executed next, for G47.
  [[gnu::cold]] void set_remark(std::string_view remark) { remark_ = remark; }
  /// The next move of the block executed last; false after its last.
  bool next(Move& move);

  /// Are lines kept back whose rotary axes are not known yet (G43.5)? Before anything asks where those are, settle().
  bool keeps_back() const { return vectors_.is_open(); }
  /// Whether the block waits until all that is kept back, here or by cutter compensation, has been handed out.
  bool waits(const Block& block) const {
    const bool is_of_contour = lathe_cycles_.is_open();  // and executed when that ends
    return (vectors_.any() && !vectors_.goes_on(block)) ||
           (compensation_.keeps_back() && !is_of_contour &&
            (block.has(Group::cutter_radius) || saved_modes_.ends_compensation(block)));
  }
  /// Whether modes that M73 has kept come back before the next line is read: a call has ended.
  bool leaves_calls() const { return saved_modes_.leaves_calls(); }
  /// Whether that waits likewise.
  bool leaving_waits() const {
    return (vectors_.any() && saved_modes_.leaving_brings_back()) ||
           (compensation_.keeps_back() && saved_modes_.leaving_ends_compensation());
  }
  /// They come back. What follows from it is handed out. Errors: `cutter-compensation`, `tilted-plane`, `unfinished-curve`.
  [[gnu::cold]] void leave_calls();
  [[gnu::cold]] void settle();
  /// Of a line that was kept back, where its move was the last; else null.
  const KeptPlace* place_of(base::Line line) const;

  /// What the M66 handed out last has found.
  void input_is(double value) { events_.set_input(value); }
  /// The block of the cycle whose contour comes next, from the subprogram of its number Q to the end of that;
  /// null where there is none. Blocks between are executed as the contour's.
  const Block* contour() const {
    if (lathe_cycles_.is_open()) return &lathe_cycles_.block();
    return pocket_cycle_.is_open() ? &pocket_cycle_.block() : nullptr;
  }
  /// The contour's subprogram has ended.
  [[gnu::cold]] void end_contour();
  /// Of the move handed out last.
  const MachinedMove& machined() const { return surface_moves_.machined(); }
  std::vector<std::shared_ptr<const surfaces::SurfaceForm>> surfaces() const { return surface_blocks_.all(); }
  /// How the probing move of the block executed last has ended.
  void probed(const Probed& result) { probing_.probed(result); }

  /// The program ends here, without saying so.
  void end(base::Line line);
  bool ended() const { return ended_; }

 private:
  /// What G7 and M73 do before a block.
  [[gnu::noinline]] void execute_special(Block block);
  [[gnu::cold]] void begin_turning();
  void execute_in_axes(const Block& block);
  /// All that is checked and executed before the axes move.
  void begin_block(const Block& block);
  /// The rest of it.
  void finish_block(const Block& block);
  [[gnu::noinline]] void execute_polar(Block block);
  [[gnu::cold]] void execute_surface(const Block& words);
  [[gnu::cold]] bool add_to_surface(const Block& block);
  [[gnu::cold]] bool next_of_surface(Move& move);
  void set_modes(const Block& block);
  void abandon();
  void follow_modes(bool had_tip_control);
  void set_path_control(const Block& block);
  void set_smoothness(const Block& block);
  void execute_motion(const Block& block);
  /// What a motion or a code of group 0 does.
  void dispatch(Code code, const Block& block);
  // dispatch.cpp
  void dispatch_curve(Code code, const Block& block);
  void dispatch_cycle(Code code, const Block& block);
  void stop(const Block& block);
  bool is_plain() const;
  bool is_plain_block(const Block& block, Code motion, std::uint32_t words) const;
  [[gnu::noinline]] Plain execute_plain_arc(const Block& block, Code motion, base::Line line, Move& move);
  bool next_of_block(Move& move);
  [[gnu::noinline]] bool next_with_vectors(Move& move);
  bool next_uncompensated(Move& move);
  [[gnu::noinline]] bool next_compensated(Move& move);
  void end_lathe_contour();

  Outbox outbox_;
  MachineEvents events_;
  Travel travel_;
  Motion motion_;
  VectorMoves vectors_;
  CurveReader curves_;
  CannedCycles cycles_;
  Threading threading_;
  LatheCycles lathe_cycles_;
  CutterRadius cutter_;
  CutterCompensation compensation_;
  PlannedCycle planned_;
  CircularPockets circular_pockets_;
  PocketCycle pocket_cycle_;
  Engraving engraving_;
  TurningCycles turning_cycles_;
  PeckingCycles pecking_cycles_;
  SurfaceBlocks surface_blocks_;
  SurfaceMoves surface_moves_;
  DirectedCurve directed_curve_;
  const Block* surface_words_ = nullptr;  ///< of the block in execution, where it is of a surface: all of them
  Probing probing_;
  Offsets offsets_;
  TiltedPlanes tilted_planes_;
  Transforms transforms_;
  Polar polar_;
  SavedModes saved_modes_;
  BlockCheck check_;
  std::optional<base::Event::Kind> stop_;
  std::string remark_;
  bool ended_ = false;
};

}  // namespace leadscrew::gcode
