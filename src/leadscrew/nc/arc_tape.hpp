#pragma once
// The pulses of a short arc, kept from when they are counted until they are made, so that it is interpolated once.

#include <cstdint>
#include <leadscrew/pulse/arc.hpp>
#include <leadscrew/pulse/stretch.hpp>
#include <vector>

namespace leadscrew::nc {

/// Of one arc at a time, by one method.
class ArcTape {
 public:
  /// Of what is estimated to take more commands an arc is too long for a tape.
  static constexpr std::int64_t most_commands = 16'384;

  /// Counts the commands of an arc by those of its interpolator, which is at its start.
  template <typename Circle>
  std::int64_t record(const pulse::Arc& arc, Circle circle) {
    constexpr std::size_t buffer_size = most_commands + 64;
    codes_.resize(buffer_size);
    std::uint8_t* at = codes_.data();
    const std::uint8_t* const end = at + buffer_size;
    pulse::step_through(circle, [&](auto& state) {
      *at++ = code(state.step());
      return at != end;
    });
    arc_ = arc;
    holds_ = circle.done();
    codes_.resize(static_cast<std::size_t>(at - codes_.data()));
    std::int64_t more = 0;
    for (; !circle.done(); circle.step()) ++more;
    return commands() + more;
  }

  /// Is this the arc that it has been recorded of?
  bool holds(const pulse::Arc& arc) const { return holds_ && arc == arc_; }
  std::int64_t commands() const { return static_cast<std::int64_t>(codes_.size()); }

  /// The interpolator of the arc on the tape, which must not be changed meanwhile.
  class Player {
   public:
    static constexpr std::size_t axes = 2;

    explicit Player(const ArcTape& tape) : at_(tape.codes_.data()), end_(at_ + tape.codes_.size()) {}

    bool done() const { return at_ == end_; }
    pulse::Pulse<2> step() {
      if (done()) return {};
      const std::uint8_t code = *at_++;
      return {{static_cast<std::int8_t>((code & 3) - 1), static_cast<std::int8_t>((code >> 2) - 1)}};
    }

   private:
    const std::uint8_t *at_, *end_;
  };

 private:
  static std::uint8_t code(const pulse::Pulse<2>& pulse) {
    return static_cast<std::uint8_t>((pulse.step[0] + 1) | (pulse.step[1] + 1) << 2);
  }

  pulse::Arc arc_;
  bool holds_ = false;
  std::vector<std::uint8_t> codes_;
};

}  // namespace leadscrew::nc
