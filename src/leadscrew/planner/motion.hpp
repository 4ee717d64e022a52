#pragma once
// Motion: s(t) in chunks, each ready for the cycle to evaluate and each ending in a stop.
//
//   s' ^        .--------+.
//      |      /          : \.
//      |    /  committed :   \  stop tail
//      +--'--------------+-----'---> t
//
// A chunk holds its pieces of path and the time law along them, as polynomials between knots. The chunk that follows
// goes on exactly where the committed part ends: same place, speed and acceleration. If none has come by then, the
// cycle runs the stop tail, and the machine comes to rest on the path within its limits; the chunk that follows then
// begins there, at rest. Chunks whose committed part ends at rest have no tail.

#include <cstdint>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/derivatives.hpp>
#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/pair.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace leadscrew::planner {

/// s(τ) = s0 + τ(v0 + τ(c2 + τ(c3 + τ(c4 + τ c5)))) along one piece, τ the time since the segment began, 0 ≤ τ ≤
/// duration.
struct Segment {
  numeric::DoubleDouble begin;                            ///< seconds since the motion began
  numeric::DoubleDouble duration;                         ///< seconds, ≥ 0
  numeric::DoubleDouble s0;                               ///< path length on the piece, units of the piece's length
  numeric::DoubleDouble v0;                               ///< speed, units/s
  double c2 = 0;                                          ///< units/s²
  double c3 = 0;                                          ///< units/s³
  double c4 = 0;                                          ///< units/s⁴
  double c5 = 0;                                          ///< units/s⁵
  std::uint32_t piece = 0;                                ///< index into Chunk::pieces
  base::MotionState state = base::MotionState::changing;  ///< of the words in it
};

/// Speed, acceleration and jerk along the path at a time within a segment; T is double, or numeric::Pair for two times.
template <typename T>
struct PathStateOf {
  T s{};             ///< path length on the piece, its units
  T speed{};         ///< units/s
  T acceleration{};  ///< units/s²
  T jerk{};          ///< units/s³
};
/// At one time.
using PathState = PathStateOf<double>;
/// At τ, seconds.
PathState evaluate(const Segment& segment, double tau);
/// At two times, each to the last bit as alone.
PathStateOf<numeric::Pair> evaluate(const Segment& segment, numeric::Pair tau);
/// The time, seconds since it began, at which the segment passes a place inside it, of its piece's length.
double time_at(const Segment& segment, double s);

/// Speed and acceleration that count as rest, units/s and units/s²: any usual jerk leads beyond them within
/// nanoseconds.
inline constexpr double rest_speed = 1e-9;
inline constexpr double rest_acceleration = 1e-6;  ///< see rest_speed

/// Does motion stand, to rounding? Where it passes through rest it does: what goes on there may as well wait.
bool is_rest(const PathState& state);

/// An event at its place of a chunk.
struct PlacedEvent : base::Event {
  std::uint32_t piece = 0;  ///< index into Chunk::pieces
  double s = 0;             ///< path length on the piece; −∞ if it is to happen before the chunk begins
  double path_length = 0;   ///< since the program's start, as base::Word::path_length
};

/// The same, passed in the period that ends with this word.
base::PassedEvent passed_at(base::Tick tick, const PlacedEvent& event);

/// A part of a motion, with the stop that ends it if nothing follows.
struct Chunk {
  /// To happen before this chunk begins, and then where its committed part passes their places; in order.
  std::vector<PlacedEvent> events;
  std::vector<PlacedEvent> tail_events;  ///< where the tail passes; those of the next chunk, if it goes on
  /// Those that the committed part and the tail go along; empty for a dwell. Where the chunk begins in the middle of a
  /// piece, that is the piece on which the chunk before ended.
  std::vector<toolpath::Piece> pieces;
  /// When it begins, seconds since the motion began; 0 unless it is a later slice of a motion. Times, like polynomials,
  /// are the same so, however a motion is sliced.
  numeric::DoubleDouble begin;
  /// The committed part, contiguous in time; for a dwell, or a slice of one, one segment at rest. A slice may be cut in
  /// the middle of a segment, which stays as it is: the first may begin before the chunk, the last end behind its
  /// duration.
  std::vector<Segment> segments;
  /// From the committed part's end to rest. The first is the last of the committed part where that is cut. Empty where
  /// the committed part ends at rest.
  std::vector<Segment> stop_tail;
  geometry::Point rest{};          ///< where the chunk comes to rest: at the end of the tail, if it has one
  base::Line rest_line{};          ///< of the program, there
  numeric::DoubleDouble duration;  ///< seconds, of the committed part
  double length = 0;               ///< travelled by the committed part
  double tail_length = 0;          ///< travelled by the tail
  /// A line in step with the spindle, which is the whole chunk.
  struct InStep {
    double lead = 0;              ///< units of the piece's length in a revolution, > 0
    double turns = 0;             ///< of the spindle since the thread's index, where the line begins; ≥ 0
    bool waits_for_index = true;  ///< else it goes on with the thread, or the tap, of the line before
    /// Of a tap, revolutions per s² (machine::tap_acceleration), by which the spindle brakes so that it stands where the line
    /// ends. A line that waits for no index begins where it stands, and the spindle takes up speed by no more. 0: of a thread.
    double tap_acceleration = 0;
    machine::Derivatives limits{};  ///< along the piece
    double tolerance = 0;           ///< units: so near to the spindle's place it is in step
  };
  /// Only where the planner was told that the cycle follows the spindle: the segments then tell what motion would be at
  /// the speed of S, at once.
  std::optional<InStep> in_step{};

  /// When the committed part ends, seconds since the motion began.
  numeric::DoubleDouble end() const;
  /// Where on its piece the committed part begins; 0 without segments.
  PathState first_state() const;
  /// Events before the chunk begins and on its committed part; if the tail is run, on that too.
  std::size_t event_count(bool with_tail) const { return events.size() + (with_tail ? tail_events.size() : 0); }
  /// Those of the committed part come first.
  const PlacedEvent& event(std::size_t index) const {
    return index < events.size() ? events[index] : tail_events[index - events.size()];
  }
  /// Nothing, a dwell, or motion that starts from rest (to rounding); otherwise it continues the motion of the chunk
  /// before.
  bool begins_at_rest() const;
};

}  // namespace leadscrew::planner
