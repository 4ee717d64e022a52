#pragma once
// What the servo thread and the thread of planning share, without a lock.
//
// Motion is set down by a request in the ring of moves, so that it comes in its order. Whoever sets down has let go of the
// controller before: the thread of planning may then free it, and says by `made` that there is another.

#include <array>
#include <atomic>
#include <cstdint>
#include <leadscrew/controller.hpp>
#include <leadscrew/realtime.hpp>

#include "planning.h"

namespace leadscrew::linuxcnc {

using Position = std::array<double, leadscrew_tp_axes>;

/// A move, or a place where motion is set down.
struct Request {
  std::uint32_t set_down = 0;  ///< number of the setting down; 0: a move
  leadscrew_tp_move move{};
  Position position{};
  leadscrew_tp_limits limits{};
  std::int64_t period_ns = 0;
};

struct Link {
  /// Room for as many settings down beside the moves.
  realtime::Ring<Request, std::size_t{2} * leadscrew_tp_moves> requests;

  // Told by the servo thread.
  std::atomic<std::uint32_t> set_down{0};  ///< number of the last setting down
  std::atomic<std::uint32_t> aborts{0};    ///< number of the setting down whose motion is to be aborted
  std::atomic<std::uint32_t> passed{0};    ///< leadscrew_tp_wishes::passed
  std::atomic<double> factor{1}, top_speed{0};
  std::atomic<std::uint32_t> in_motion{0};  ///< number of the move that motion has come to

  // Told by the thread of planning.
  std::atomic<std::uint32_t> made{0};      ///< number of the setting down that the controller and all below belong to
  std::atomic<std::uint32_t> rejoined{0};  ///< the controller stands behind this followed move
  std::atomic<interpolator::Controller*> controller{nullptr};
  std::atomic<std::uint32_t> finished{0}, gate{0};
  std::atomic<bool> has_failed{false};
  std::atomic<double> seconds_ahead{0};
  std::atomic<std::int64_t> late_chunks{0}, starvations{0};
};

}  // namespace leadscrew::linuxcnc
