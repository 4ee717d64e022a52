#pragma once
// Where moves come from that no part program holds.

#include <cstdint>
#include <functional>
#include <leadscrew/gcode/move.hpp>

namespace leadscrew::pipeline {

/// What is to be had of who gives moves.
enum class Supply : std::uint8_t {
  move,   ///< here is one
  later,  ///< none is known yet; more may come
  end,    ///< there are no more
};

/// Gives the next move. It begins where the one before ended, is finite, and stays inside the travel of the machine.
using MoveInput = std::function<Supply(gcode::Move&)>;

}  // namespace leadscrew::pipeline
