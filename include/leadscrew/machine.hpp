#pragma once
/// \file
/// The machine as data: travel and limits of each axis, servo period, tolerance; the built-in mill; what is not
/// sound about one.

#include <leadscrew/machine/drive.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/probe.hpp>
#include <leadscrew/machine/screw_errors.hpp>
#include <leadscrew/machine/step_times.hpp>
