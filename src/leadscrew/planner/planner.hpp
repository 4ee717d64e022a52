#pragma once
// From path to motion: the fastest speed along the path that keeps every limit of every axis.
//
// Pieces that meet with continuous curvature are travelled as one section, from rest to rest. A section that is one
// line, or lines that run straight on, has the seven phases of constant jerk (rest_to_rest.hpp), which no time law can
// beat; so have short arcs, along which the axes' shares of speed hardly change (piece_limits.hpp). Every other section
// has the optimal time law of speed_profile.hpp. Sections end where the path asks for a stop, where it bends or turns
// at once, and at dwells and events that motion rests for. All other events travel with their pieces.

#include <cstddef>
#include <deque>
#include <functional>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/closed_form.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/look_ahead.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/overrides.hpp>
#include <leadscrew/planner/travelling_events.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace leadscrew::planner {

/// Streaming: elements of the path are pushed, chunks come out once nothing ahead can change them. Nothing is planned
/// but what pop() needs: one window a call. The machine must outlive the planner and have every axis that the path
/// moves.
class Planner {
 public:
  /// Stands at `start`, mm or degrees.
  Planner(base::Borrowed<machine::Machine> machine, const geometry::Point& start)
      : machine_(machine), constraints_(*machine), look_ahead_(*machine), position_(start) {}

  /// The path's next element.
  void push(const toolpath::Element& element) {
    waiting_.push_back(element);
    if (auto* piece = std::get_if<toolpath::Piece>(&waiting_.back())) travelling_.enter(*piece);
  }
  /// No more elements will come.
  void finish() { finished_ = true; }
  /// The next chunk; none if it takes more elements to know it, or if all has been planned.
  std::optional<Chunk> pop();

  /// Before anything is pushed: motion begins at rest behind so much of the path, units of its length, as if all before
  /// had been travelled. Dwells and events that stand at this very place come before it if their lines lie before
  /// `line`. Spindle, coolant, tool and outputs are as the events before have left them: those that say so come out
  /// again, with the first chunk.
  void start_at(double path_length, base::Line line);
  /// Where that is on the path, once a chunk has been popped or there is none; none where the path is not so long.
  std::optional<geometry::Point> started_at() const;
  /// Is that within a line in step with the spindle, or behind the first of a tap's two? What is left of the line, or of the
  /// tap, then goes at the speed of S: a tap cannot be gone on with in step.
  bool starts_in_step() const { return starts_in_step_; }

  // For a controller that must answer at any time. Chunks must then be offered one by one, each before the next is
  // popped.

  /// Before the first chunk: the cycle follows the machine's spindle (Machine::threads_follow). A line of a thread (G33,
  /// G76) or a tap (G33.1, G84, G74) that begins at its own beginning is one chunk then, however long, with Chunk::in_step,
  /// and is not held on the way: who wants rest there asks the interpolator (Interpolator::leave_step).
  void follow_spindle() { follows_ = machine_.threads_follow(); }
  /// From now on no chunk commits to more than about this, s > 0. The motion is the same, bit for bit, however it is
  /// sliced.
  void slice(double seconds);
  /// Feed override, 0 … 2: programmed feed (not rapid motion) is multiplied by it from the next chunk on, as soon as
  /// the limits allow. 0 holds: motion comes to rest and no chunk comes until the factor is greater. As far as the path's
  /// events allow (overrides.hpp): M49 and M50 P0 make it 1 from the chunk behind their place on, M53 P0 ends a hold;
  /// what was asked last counts again when they do.
  void override_feed(double factor);
  /// Adaptive feed, 0 … 1: a second factor, where the program has asked for it by M52. 0 holds.
  void adapt_feed(double factor);
  /// So fast the spindle turns that the cycle follows, revolutions per minute, either way: where feed is per revolution (G95)
  /// its share of S is one more factor, of which less than least_spindle_change is passed over unless it is 1; not below
  /// least_spindle_factor, so that motion waits for no spindle that never turns. Chunks commit to no more than feed_slice
  /// there.
  void spindle_turns(double speed);
  static constexpr double least_spindle_change = 0.005;  ///< of the factor
  static constexpr double least_spindle_factor = 0.02;   ///< of the feed
  static constexpr double feed_slice = 0.04;             ///< s
  /// Motion comes to rest as soon as the limits allow, whatever the program says, and no chunk comes any more.
  void come_to_rest();
  /// What the program allows behind the last chunk.
  const AllowedOverrides& allowed_overrides() const { return travelling_.overrides(); }
  /// Did the last pop() give no chunk because motion is held?
  bool is_held() const { return feed_factor_ == 0 && (last_ || !waiting_.empty()); }
  /// Does motion stand still because it is held, so that no more of the path need be known?
  bool stands_held() const { return is_held() && (!last_ || (look_ahead_.stands() && !closed_form_)); }
  /// The chunk that was popped last was not taken in time: motion has come to rest by the stop tail of the chunk
  /// before. The next chunk goes on from there.
  void refuse();
  /// Motion has come to rest by the stop tail of the chunk that was popped last: forgets what is left of the path. The next
  /// element goes on from there.
  void forget_rest();
  /// Where motion rests by the stop tail of the chunk that was popped last, mm or degrees.
  const geometry::Point& rest() const { return position_; }

  /// Asked every few milliseconds while planning takes long: once it says true no chunk comes any more, and
  /// is_stopped().
  void stop_when(std::function<bool()> asked) { look_ahead_.effort().should_stop = std::move(asked); }
  /// Has it been told to stop?
  bool is_stopped() const { return look_ahead_.effort().is_stopped(); }
  /// Was no motion found along what follows, however short? No chunk comes any more: a defect of the planner.
  bool has_failed() const { return look_ahead_.has_failed(); }

  /// Sections, or rests of sections, that are planned with lower limits than the machine's, because the optimum would
  /// have taken far more work than a motion of their length usually does (effort.hpp).
  std::int64_t simplified_sections() const { return look_ahead_.simplified(); }
  /// Work of planning so far, counted in units (effort.hpp).
  double effort() const { return look_ahead_.effort().total(); }
  /// Windows for which no motion was found: there it stopped where it need not.
  std::int64_t refused_windows() const { return look_ahead_.refused(); }
  /// Windows that were not planned, because one was that is the same to the last bit (plan_memory.hpp).
  std::int64_t remembered_windows() const { return look_ahead_.remembered(); }
  /// Has a change of the feed not been planned yet? None waits shortly before motion comes to rest.
  bool change_waits() const { return look_ahead_.change_waits(); }

 private:
  bool take(const toolpath::Piece& piece);
  bool pass_over(const toolpath::Element& element);
  Chunk stand(const toolpath::Dwell& dwell);
  void keep_in_force(const base::Event& event);
  void pass_events(const toolpath::Piece& piece, double s);
  std::optional<Chunk> plan();
  void go_on_from(double s);
  Chunk follow_events(Chunk chunk);
  void rest_for(const base::Event& event);
  void take_factor();
  void take_spindle();
  double slice_in_force() const;
  void take_lead(const base::Event& event);
  void pass_turns(const toolpath::Piece& piece);
  void start_in_step(double s);
  std::optional<Chunk::InStep> in_step();

  struct Start {
    double path_length = 0;
    base::Line line{};
    double passed = 0;        ///< length of the pieces before
    std::int64_t events = 0;  ///< on these, that travel
  };

  const machine::Machine& machine_;
  constraints::Constraints constraints_;
  std::deque<toolpath::Element> waiting_;
  bool finished_ = false;
  std::optional<Start> start_;  ///< not reached yet
  std::optional<geometry::Point> started_at_;
  double slice_ = std::numeric_limits<double>::infinity();
  double spindle_speed_ = 0;  ///< revolutions per minute
  AskedOverrides asked_;
  double feed_factor_ = 1;     ///< in force
  bool follows_ = false;       ///< the cycle, a spindle
  double lead_ = 0;            ///< of the thread or tap that motion is in; else 0
  bool taps_ = false;          ///< is it a tap?
  double turns_ = 0;           ///< of the spindle since the thread began, at the end of what was taken
  bool is_in_thread_ = false;  ///< a line of it was in step
  bool starts_in_step_ = false;
  bool is_tap_begun_ = false;              ///< motion has started within it
  double dwelt_ = 0;                       ///< s handed out of the dwell that is the next element
  std::vector<base::Event> events_;        ///< waiting for the chunk they come before
  TravellingEvents travelling_;            ///< all others
  LookAhead look_ahead_;                   ///< along the section that is being planned
  std::optional<toolpath::Piece> last_;    ///< its last piece
  std::optional<ClosedForm> closed_form_;  ///< of that section, where it has one
  geometry::Point position_;               ///< where motion rests, as far as it is planned
  base::Line line_{};
  geometry::Point rest_before_{};  ///< the same before the last chunk
  base::Line line_before_{};
};

}  // namespace leadscrew::planner
