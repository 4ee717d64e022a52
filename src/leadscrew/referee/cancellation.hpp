#pragma once
// How a user's ^C ends long work inside one call: loops ask, now and then, whether anyone still wants the result.

#include <cstdint>
#include <functional>
#include <utility>

namespace leadscrew::referee {

class Cancellation {
 public:
  /// `wanted`: returns true once the work is to end; may be empty.
  explicit Cancellation(std::function<bool()> wanted) : wanted_(std::move(wanted)) {}

  /// To be asked by every turn of a loop that may be long; every 256th time it asks `wanted`. Once true, always true.
  bool asked() {
    if (!requested_ && (++turns_ & 0xFF) == 0 && wanted_) requested_ = wanted_();
    return requested_;
  }
  bool requested() const { return requested_; }

 private:
  std::function<bool()> wanted_;
  std::uint32_t turns_ = 0;
  bool requested_ = false;
};

}  // namespace leadscrew::referee
