#pragma once
/// \file
/// Part programs: from text to moves, or to everything that is wrong with it.

#include <leadscrew/gcode/probed.hpp>
#include <leadscrew/gcode/reader.hpp>
