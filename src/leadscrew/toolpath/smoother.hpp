#pragma once
// Within its tolerances: what was programmed as lines, arcs and curves, as a path that bends without a jump.
//
//   legs ─reduction─▶ legs ─joints─▶ runs and corners ─▶ pieces
//
//   - Legs too short to matter beside the tolerance, and lines that run straight on, become one (Reduction).
//   - A joint is a corner where the direction turns by 81° or more within eight tolerances, or feed comes to be counted
//     by other axes, or both legs are lines long enough for a blend that swings wide; elsewhere it is smooth.
//   - Short legs that are joined smoothly, and the nearest parts of long ones, are a run: a spline through the tube
//     around them (TubeSpline). The rest of the long ones stays what it is.
//   - Corners are blended (corner.hpp); where none is worth it, and where the path turns back, the motion stops.
//   - Where words are far apart, the tolerance is theirs as well (Sampling).

#include <deque>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <leadscrew/toolpath/reduction.hpp>
#include <leadscrew/toolpath/run.hpp>
#include <leadscrew/toolpath/sampling.hpp>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

class Smoother {
 public:
  /// sampling: what is kept of P for chords between words; tables: of blends and fits, by arc length.
  /// space: of all its legs.
  explicit Smoother(const Sampling& sampling = {}, const geometry::MapTolerance& tables = tables_for_motion,
                    const ToleranceSpace& space = {})
      : sampling_(sampling), tables_(tables), space_(space) {}

  /// Of the leg's allowance, P of G64 > 0, mm: no point of the path lies farther from what was programmed there, and no
  /// point of that farther from the path; where legs meet, no farther than both allow. Q of G64 ≥ 0, mm (the naive-CAM
  /// tolerance): where short moves are fitted, no farther than this either; below 0.2 µm none are.
  void push(Leg leg);
  /// Nothing goes on smoothly from what was pushed last.
  void finish();
  /// The next piece that nothing ahead can change.
  std::optional<Piece> pop();
  /// After finish(): events that lie where the last piece ends.
  const std::vector<EventMark>& events_at_end() const { return carried_; }

 private:
  enum class Joint : std::uint8_t {
    end,
    corner,
    wide,
    smooth,
    through
  };  ///< wide: a corner of two lines that swings wide

  /// Of what is allowed.
  struct Change {
    double u = 0;
    double before = 0, behind = 0;  ///< P, mm
  };

  void take(Leg leg);
  void classify(bool all);
  double tolerance_at(std::size_t joint) const;
  double turn_at(std::size_t joint, double window) const;
  geometry::Point place_at(double u) const;
  double changed_before(std::size_t leg) const;
  bool is_beside_wide(std::size_t joint) const;
  Joint joint_kind(std::size_t joint) const;
  bool swings_wide(std::size_t joint) const;
  std::optional<double> wanted_at(std::size_t joint) const;
  void follow(const Leg& leg, Joint before, Joint behind);
  void add_exact(const Leg& leg, double from, double to);
  void begin_run(const Leg& leg, double from, bool pinned);
  void take_run(bool goes_on);
  void add(Stretch stretch);
  void cut_corner(Stretch& behind);
  void emit(Piece piece);
  void release();

  Sampling sampling_;
  geometry::MapTolerance tables_;
  ToleranceSpace space_;
  Reduction reduction_;
  std::deque<Leg> legs_;          ///< that are not done
  std::deque<double> ends_{0.0};  ///< u at their ends; the first: where the first begins
  std::deque<Change> changes_;    ///< there, and the last one before
  std::deque<Joint> joints_;      ///< at their ends, as far as known
  std::deque<double> turns_;      ///< at their ends, as far as known
  std::size_t followed_ = 0;      ///< legs that are done; turns look back at them
  Joint before_ = Joint::end;     ///< before the first leg that is not
  std::optional<Run> run_;
  bool corner_ = false;             ///< is there one before what comes next?
  std::optional<Stretch> last_;     ///< that a corner may still cut
  std::vector<EventMark> carried_;  ///< events at the end of the last piece that is done
  std::deque<Piece> done_;
};

}  // namespace leadscrew::toolpath
