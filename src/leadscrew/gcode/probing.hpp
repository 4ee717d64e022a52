#pragma once
// Probing moves: G38.2 … G38.5 (LinuxCNC manual, G Codes, "G38.n Straight Probe") and G31, the skip of Fanuc's, Haas' and
// Mach3's controllers.
//
//     G38.2  to contact, an error without      G38.4  to loss of contact, an error without
//     G38.3  to contact, or to the end         G38.5  to loss of contact, or to the end
//     G31    as G38.3
//
//     #5061 … #5069   where that was, or else the point programmed: coordinates of the program, in its units
//     #5070           1 where it was found, else 0
//     #2000 … #2008   in Mach3 as #5061 … #5069
//
// The simulated probe (machine::Probe) is ideal: motion ends exactly where its state changes. There, on a face, it is in
// the state that the move before was to reach, so that from contact the next move away ends where it begins, and behind that
// only a move that leads back ends there, not one farther away or along the face. Where the machine simulates none, contact is
// taken for granted at the point programmed.

#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/probed.hpp>
#include <optional>

namespace leadscrew::gcode {

class Probing : Part {
 public:
  Probing(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), travel_(travel), outbox_(outbox) {}

  /// G38.2 … G38.5. Errors: `bad-probe`, `probe-state`, `probe-failed`, `tip-control`, those of a line at feed. Note:
  /// `probe-not-simulated`.
  void probe(const Block& block);
  /// G31. Errors: `bad-probe`, `tip-control`, those of a line at feed. Note: `probe-not-simulated`.
  void skip(const Block& block);

  /// How the probing move that was made last has ended. Errors: `probe-failed`; `probe-state`, where
  /// it was found at once. Nothing happens where it
  /// has been told already, or there was none.
  void probed(const Probed& result);

 private:
  /// What a code looks for.
  struct Search {
    bool contact = true;  ///< else the loss of it
    bool must_find = false;
    bool may_stand = false;     ///< the point programmed may be where the tool stands
    bool may_be_there = false;  ///< the state that is looked for may be the one at the start
    std::uint32_t column = 0;
  };

  void search(const Block& block, const Search& search);
  bool allows(const base::AxisVector& target, const Search& search);
  void check_state(bool is_there);
  Probed simulated(const base::AxisVector& target);
  bool is_in_contact() const;
  bool is_released() const { return released_ && released_->place == frame_.position; }
  void move_to(const base::AxisVector& target, const Probed& result, Feed feed);
  void settle(const Probed& result);
  void log(const Probed& result) const;
  base::AxisVector in_program(const Probed& result) const;
  void note_missing_probe();

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  /// Where contact was lost, and the way on which it was, of any length: the probe stands free on that side.
  struct Release {
    base::AxisVector place{}, way{};
  };

  Search search_;                    // of the move that was made last
  base::AxisVector way_{};           // of that, to the point programmed
  bool made_ = false;                // has one been made?
  std::optional<Release> released_;  // by the probing move before
  bool told_of_probe_ = false;
};

}  // namespace leadscrew::gcode
