#pragma once
// Koren's NC program, which an interrupt clock runs ("Interpolator for a computer numerical control system", fig. 2):
//
//   interrupt ─▶ feed ──command──▶ interpolator or point-to-point ──overflow──▶ output ─▶ position ─▶ counters zero?
//                 │ none                     │ none                                                │ yes
//                 └──────────▶ return ◀──────┴───────────────────────────────────────◀─┐           ▼
//                                                                                      └──── initiator: next block
//
// With f = 100 V0 for V0 in inches a minute and q0 = 3000, a clock of 5000 interrupts a second gives 30 in/min at one
// command an interrupt: V = w0 f/q0 (eqs. 20, 21). The adaptive-control program beside it corrects the feed word.
//
// Every routine counts its operations where it does them. Those of the initiator, which computes q and does not run
// in most interrupts, are counted apart from the rest.

#include <functional>
#include <leadscrew/nc/block_interpolator.hpp>
#include <leadscrew/nc/feed_register.hpp>
#include <leadscrew/nc/operations.hpp>
#include <optional>

namespace leadscrew::nc {

struct NcOptions {
  std::int64_t clock_pps = 5000;         ///< w0, interrupts/s; > 0
  std::int64_t feed_capacity = 3000;     ///< q0, 1 … 2⁴⁰: wider where feed words are to be finer
  InterpolationOptions interpolation{};  ///< of the DDAs
};

/// An override of 1, and the greatest that there is, as the adaptive-control input takes them.
inline constexpr int full_override = 1000, greatest_override = 2000;

class NcProgram {
 public:
  /// The next block, with its words of feed; nothing at the end of the program.
  using BlockSource = std::function<std::optional<Block>()>;

  NcProgram(const NcOptions& options, BlockSource blocks);

  /// The feed routine's word for a feed of V0 in/min: f = 100 V0, rounded.
  static std::int64_t feed_word(double inches_per_minute);

  /// One interrupt of the clock: the steps that it makes.
  AxisPulse interrupt();

  /// Has the program come to its end? Then interrupts make nothing.
  bool done() const { return ended_; }

  /// The adaptive-control input: thousandths of the programmed feed, 0 … greatest_override, from the next interrupt on.
  /// What exceeds the block's greatest word or the register is clamped there.
  void override_feed(int thousandths);

  const FeedRegister& feed() const { return feed_; }
  const Block& block() const { return block_; }                       ///< being travelled
  const LatticeVector& position() const { return position_; }         ///< BLU, from where the program began
  std::int64_t interrupts() const { return interrupts_; }             ///< so far; block by block, none lost
  const OperationCount& operations() const { return operations_; }    ///< of all routines but the initiator
  const OperationCount& initiations() const { return initiations_; }  ///< of the initiator, by its runs

 private:
  void initiate();
  void load_feed();
  bool feed_routine(Operations& count);
  AxisPulse interpolator_routine(Operations& count);
  void output_routine(const AxisPulse& pulse, Operations& count);
  bool position_routine(const AxisPulse& pulse, Operations& count);

  NcOptions options_;
  BlockSource blocks_;
  FeedRegister feed_;
  Block block_;
  BlockInterpolator interpolator_;
  std::int64_t dwell_left_ = 0;
  std::int64_t override_ = full_override;
  LatticeVector position_{};
  std::int64_t interrupts_ = 0;
  bool ended_ = false;
  OperationCount operations_, initiations_;
};

}  // namespace leadscrew::nc
