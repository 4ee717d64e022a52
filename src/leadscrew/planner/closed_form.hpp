#pragma once
// Sections that have a closed form: lines that run straight on, and arcs so short that the axes' shares of speed hardly
// change.
//
//      speed    ╭───────┼─╮
//              ╱        │  ╲              ┼ a slice ends here, feed is changed to 0.8
//             ╱         ╰╮  ╲
//            ╱     0.8   ╰──────────╮
//           ╱                        ╲
//
// From rest to rest there are seven phases of constant jerk (rest_to_rest.hpp). The motion is handed out in slices: the
// same polynomials, however it is cut. A change of feed takes effect where the last slice ends: from the speed and
// acceleration there, three phases lead to the speed that is wanted and three more to rest (speed_change.hpp).

#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/rest_to_rest.hpp>
#include <leadscrew/planner/section.hpp>
#include <optional>
#include <vector>

namespace leadscrew::planner {

class ClosedForm {
 public:
  /// Along the whole section, its feed multiplied by the factor > 0; nothing where there is no closed form as good as
  /// the optimum.
  static std::optional<ClosedForm> plan(const Section& section, const constraints::Constraints& constraints,
                                        double feed_factor);

  /// The next part of the motion, about this long, s > 0, or all that is left of it.
  Chunk next(double slice);
  /// Does the last slice end at rest?
  bool is_done() const { return !(now_ < motion_.duration); }
  /// From the end of the last slice on, as soon as the limits allow; 0: to rest on the way. Where motion is about to
  /// come to rest anyhow, nothing changes.
  void override_feed(double factor);

  /// Where on the section motion comes to rest by all slices so far (by the tail of the last), and by all but the last.
  double rest() const { return rest_; }
  double rest_before() const { return rest_before_; }

 private:
  /// From where it begins to rest, each segment along its piece.
  struct Motion {
    std::vector<Segment> segments;
    numeric::DoubleDouble duration;  ///< s
    double end = 0;                  ///< on the section
  };

  ClosedForm(const Section& section, const constraints::Constraints& constraints)
      : section_(section), constraints_(constraints) {}
  std::optional<Motion> along(std::vector<Segment> segments, double end) const;
  std::optional<Motion> stop(const PathState& from) const;
  std::optional<Motion> change(const PathState& from) const;
  PathState here() const;
  std::vector<Segment> between(numeric::DoubleDouble from, numeric::DoubleDouble to) const;
  void place(Chunk& chunk) const;

  Section section_;
  constraints::Constraints constraints_;
  machine::Derivatives limits_;  ///< without feed
  double factor_ = 1;            ///< of feed, that was asked for last
  Motion motion_;
  numeric::DoubleDouble now_;  ///< s of the motion, end of the last slice
  double s_ = 0;               ///< on the section, there
  double rest_ = 0, rest_before_ = 0;
};

}  // namespace leadscrew::planner
