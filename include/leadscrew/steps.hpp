#pragma once
/// \file
/// Steps and directions that follow words, on the ticks of a clock that gives drives their times.

#include <leadscrew/steps/step_event.hpp>
#include <leadscrew/steps/step_generator.hpp>
