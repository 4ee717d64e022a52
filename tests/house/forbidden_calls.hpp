#pragma once
// The functions that a cycle may not call: whoever takes memory, waits or reads a clock, put in the place of the
// library's, so that calls are counted while a thread has armed itself.

#include <string>

namespace leadscrew::testing_support {

/// Of the calling thread.
struct Watch {
  bool armed = false;
  bool may_read_clock = false;  ///< for pacing, between two words
  int calls = 0;                ///< forbidden ones, while armed
  const char* last = "";
};
Watch& watch();

/// Does each of these functions count itself while armed, and none otherwise?
bool counts_each_function();

/// "3 forbidden calls, the last of malloc".
std::string told(const Watch& watch);

}  // namespace leadscrew::testing_support
