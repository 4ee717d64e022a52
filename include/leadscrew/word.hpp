#pragma once
/// \file
/// What leaves for the axes every servo period, and what it is told in: axes, time as a count of periods, lines of
/// the program, events.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
