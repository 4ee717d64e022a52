#pragma once
/// \file
/// The planner's half of a controller of two threads: text or moves in, chunks of motion out, each ready for the
/// cycle and each with a stop.

#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/move_input.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/planner.hpp>
