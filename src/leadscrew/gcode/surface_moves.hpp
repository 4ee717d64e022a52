#pragma once
// G6.5: a surface machined, pass by pass, each made as it is asked for.
//
//      up to the clearance · over the first place, rotary axes turn too        rapid
//      down along the tool, to the first place                                 feed
//      passes and links between them                                           feed
//      up along the tool, to the clearance                                     rapid
//
// Where the tool lies so flat that the way along it would be long, it goes along it by its own size, and straight up from there. All
// passes are made once by whoever checks a program before it moves, so that nothing moves where one cannot be.

#include <leadscrew/gcode/machined_move.hpp>
#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/pose_moves.hpp>
#include <leadscrew/gcode/surface_drafts.hpp>
#include <leadscrew/gcode/surface_words.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

class SurfaceMoves : Part {
 public:
  SurfaceMoves(const Context& context, Motion& motion, Travel& travel, Outbox& outbox, const SurfaceBlocks& surfaces)
      : Part(context),
        motion_(motion),
        travel_(travel),
        outbox_(outbox),
        words_(context, surfaces),
        curves_(context, travel, outbox) {}

  /// Errors: those of SurfaceWords, `bad-feed-mode`, `surface-clearance`, `pose-out-of-reach`, `rotary-travel`, those of passes.
  [[gnu::cold]] void begin(const Block& block);
  /// Is a surface being machined? Between the moves, too.
  bool is_active() const { return passes_.has_value() || moved_.surface; }
  /// The next move; false where there is none, or no more. Errors: `travel`, those of passes: `surface-gouge`, `surface-normal`,
  /// `surface-edge`, `surface-cusp`, `surface-overhang`, `surface-flat-contact`, `surface-passes`, `surface-step`, `surface-section`, `surface-link`, `surface-pole`.
  [[gnu::cold]] bool next(Move& move);
  /// The surface is not machined.
  [[gnu::cold]] void abandon();
  /// Of the move handed out last.
  const MachinedMove& machined() const { return moved_; }

 private:
  struct Leg {
    base::AxisVector end{};
    bool is_rapid = true;
  };

  void set_clearance();
  bool choose_angles();
  void take_passes(surfaces::Passes passes);
  std::optional<SurfaceDraft> draft_of(const SurfaceDraftKey& key);
  bool load(surfaces::Pass pass);
  bool go_on();
  bool plan_approach(const surfaces::PassNode& first);
  bool plan_retract();
  bool plan_rise(const base::AxisVector& place, const surfaces::Vector& axis, std::vector<base::AxisVector>& rise);
  base::AxisVector at_level(const base::AxisVector& place, double level) const;
  double level_of(const base::AxisVector& place) const;
  bool take_leg(Move& move);
  bool take_curve(Move& move);
  bool stop();
  bool report(const surfaces::PassFailure& failure);
  bool report(const PoseFailure& failure);
  std::string where(double u, double v) const;
  std::uint32_t column() const { return block_.column_of(Group::nonmodal); }

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  SurfaceWords words_;
  PoseMoves curves_;
  Block block_;
  Feed feed_;
  double clearance_ = 0;  // Z of the program, mm
  bool at_contact_ = false;
  std::shared_ptr<const Machined> machined_;
  std::optional<surfaces::Passes> passes_;
  std::unique_ptr<surfaces::PassSource> source_;  // of passes_; none: they are asked themselves
  surfaces::Vector axis_{};                       // of the tool, where the passes have come to
  std::vector<Leg> legs_;                         // to go before the next curve, the first of them at the end
  bool is_retracting_ = false;
  MachinedMove moved_;
};

}  // namespace leadscrew::gcode
