#pragma once
// From path to motion: the fastest speed along the path that keeps every limit of every axis.
//
// Pieces that meet with continuous curvature are travelled as one section, from rest to rest. A section that is one
// line has the seven phases of constant jerk (rest_to_rest.hpp), which no law can beat; so have short arcs, whose axes
// hardly trade places (piece_limits.hpp). Every other section has the optimal law of speed_profile.hpp. Sections end
// where the path asks for a stop, where it bends or turns at once, at dwells and events, and after `longest_section`
// pieces, which bounds memory.

#include <cstddef>
#include <deque>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>

namespace leadscrew::planner {

/// Streaming: elements of the path are pushed, chunks come out once nothing ahead can change them. The machine must
/// outlive the planner and have every axis that the path moves.
class Planner {
 public:
  /// Stands at `start`, mm or degrees.
  Planner(const machine::Machine& machine, const geometry::Point& start) : machine_(machine), position_(start) {}

  void push(const toolpath::Element& element);
  /// No more elements will come.
  void finish();
  /// The next chunk that is settled, if there is one.
  std::optional<Chunk> pop();

 private:
  /// Pieces that may wait for what follows them.
  static constexpr std::size_t longest_section = 512;

  void push_piece(const toolpath::Piece& piece);
  void settle_section();
  Chunk& begin_chunk();

  const machine::Machine& machine_;
  std::vector<base::Event> events_;  ///< waiting for the chunk they come before
  std::deque<Chunk> settled_;
  Section section_;  ///< waiting for its end
  geometry::Point position_;
  base::Line line_{};
};

}  // namespace leadscrew::planner
