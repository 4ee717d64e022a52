#pragma once
/// \file
/// Moves that a host gives: lines, arcs, curves, rests.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/host/moves.hpp>
