#pragma once
/// \file
/// The cycle's half of it: chunks in, one word a call, without memory, locks, clocks or exceptions.

#include <leadscrew/interpolator/controller.hpp>
