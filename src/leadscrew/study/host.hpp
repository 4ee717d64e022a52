#pragma once
// What a study needs of the computer it runs on. The core has no clock; whoever starts a study lends it two.

#include <functional>

namespace leadscrew::study {

struct Host {
  std::function<double()> thread_cpu_seconds;  ///< processor time of the calling thread; may be empty
  std::function<double()> wall_seconds;        ///< a steady clock, cheap to look at; may be empty
};

}  // namespace leadscrew::study
