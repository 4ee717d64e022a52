#pragma once
/// \file
/// The judge of words: travel, velocity, acceleration and jerk by differences, and how far they are from the
/// program. It shares no code with what makes them.

#include <leadscrew/referee/referee.hpp>
