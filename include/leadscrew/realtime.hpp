#pragma once
/// \file
/// Both halves on time: a planning thread and a cyclic one that hands each word to your function. With
/// leadscrew::realtime.

#include <leadscrew/realtime/feeder.hpp>
#include <leadscrew/realtime/histogram.hpp>
#include <leadscrew/realtime/move_runner.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/realtime/waiting_sink.hpp>
