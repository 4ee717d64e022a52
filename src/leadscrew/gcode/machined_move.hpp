#pragma once
// Which surface a move machines (machined.hpp).

#include <cstddef>
#include <cstdint>
#include <memory>

namespace leadscrew::gcode {

struct Machined;

/// What a move has to do with a surface.
struct MachinedMove {
  enum class Part : std::uint8_t {
    approach,  ///< to over the first place, and down to it
    pass,
    link,  ///< from one pass to the next
    retract,
  };

  std::shared_ptr<const Machined> surface;  ///< null: nothing
  Part part = Part::approach;
  std::size_t pass = 0;  ///< number of the pass, from 0; of a link, that of the pass before it
};

}  // namespace leadscrew::gcode
