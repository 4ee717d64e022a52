#pragma once
/// \file
/// Motion for a host, which owns all that it is made of: a program, checked whole before it moves, or moves as
/// they come; words, events, feed override, hold, abort.

#include <leadscrew/host/motion.hpp>
