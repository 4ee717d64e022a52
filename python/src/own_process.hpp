#pragma once
// Work that nobody can ask to end, in a process of its own, which can be ended.

#include <functional>
#include <string>

#include "watch.hpp"

namespace leadscrew::python {

/// The text that `work` makes. Without the lock: `work` touches nothing of the interpreter, and what it changes nobody sees but it.
/// Once the watch does not go on, its process is ended, and the text is empty. std::runtime_error where it cannot be started, or
/// ends without a text.
std::string in_own_process(Watch& watch, const std::function<std::string()>& work);

}  // namespace leadscrew::python
