#pragma once
// What the handles of leadscrew.h hold.

#include <array>
#include <leadscrew/host/motion.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <memory>
#include <vector>

#include "structures.hpp"

struct leadscrew_machine {
  leadscrew::machine::Machine machine;
};

struct leadscrew_motion {
  leadscrew::machine::Machine machine;  ///< as the motion has it
  std::unique_ptr<leadscrew::host::Motion> motion;
  bool is_busy = false;  ///< one of its functions is running
};

/// The machine stays where it is, for the times refer to it.
struct leadscrew_trajectory {
  explicit leadscrew_trajectory(const leadscrew::machine::Machine& of)
      : machine(of), planned(of.period, {}), times(machine, {}) {}
  leadscrew_trajectory(const leadscrew_trajectory&) = delete;
  leadscrew_trajectory& operator=(const leadscrew_trajectory&) = delete;

  leadscrew::machine::Machine machine;
  leadscrew::host::Trajectory planned;
  leadscrew::pipeline::Summary summary;
  leadscrew::pipeline::LostTime times;  ///< knows all moves, and no word yet
  struct PartOfSurface {
    std::int32_t part = LEADSCREW_NO_SURFACE, pass = 0;
  };
  std::vector<PartOfSurface> parts;  ///< of the blocks, in their order
  /// The tool from a word on.
  struct Held {
    leadscrew::base::Tick tick{};
    std::array<double, 3> offset{};  ///< mm
    std::int32_t number = 0;
  };
  std::vector<Held> tools;  ///< in the order of time
};

namespace leadscrew::capi {

/// Can memory hold so long a text?
inline bool is_text(const char* text, std::size_t length) {
  return text != nullptr && length <= std::string().max_size();
}

/// What options ask for, with tools, in `options`; or the code, and the error told.
int read_options(const leadscrew_options* given, const machine::Machine& machine, leadscrew_options& asked,
                 host::MotionOptions& options, leadscrew_error* error);

/// The first problem, or what was read.
template <class Read, class Use>
int with_read(Read read, leadscrew_error* error, const Use& use) {
  if (!read) return rejected(error, read.error().front());
  use(std::move(*read));
  return LEADSCREW_OK;
}

}  // namespace leadscrew::capi
