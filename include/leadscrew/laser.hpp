#pragma once
/// \file
/// The power of a laser, or of whatever else goes by speed, from word to word.

#include <leadscrew/machine/laser.hpp>
