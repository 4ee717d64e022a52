#pragma once
/// \file
/// A motion that has been planned to its end: how long it takes, and position, velocity, acceleration and jerk of
/// every axis at any time.

#include <leadscrew/pipeline/trajectory.hpp>
