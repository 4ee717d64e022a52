#pragma once
// A laser whose power the words carry: what a program asks for, and how fast motion really is.
//
//   power = asked · v/F     with follow_feed: as much for each millimetre, whether motion is as fast as programmed or not
//   power = asked           without
//
// asked: what S gives while the spindle is on (M3, M4), or what M67 and M68 give to one analog output. v: the feed of the
// word. F: the feed that the block in motion programs; of rapids there is none, and no power. Nothing above `asked` comes of
// it but where feed is overridden to more than was programmed.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <vector>

namespace leadscrew::machine {

/// What says how strong the beam is.
struct Laser {
  /// What a program asks for power by.
  enum class Power : std::uint8_t {
    analog_output,  ///< of M67 and M68
    spindle_speed,  ///< S, while the spindle is on
  };
  Power power = Power::analog_output;  ///< by which it is asked for
  std::int64_t output = 0;             ///< of Power::analog_output: its number, 0 … base::most_outputs − 1
  bool follow_feed = true;             ///< is power in proportion to speed over programmed feed?

  friend bool operator==(const Laser&, const Laser&) = default;
};

/// Appends `machine-laser`, if the output is none.
void check_laser(const Laser& laser, std::vector<base::Diagnostic>& problems);

/// The power of word after word, in the unit of S or of the output. Neither allocates nor waits: the cycle may ask.
class LaserPower {
 public:
  /// Off until events switch it on.
  explicit LaserPower(const Laser& laser) : laser_(laser) {}

  /// Before the word in whose period it happens. Of a laser that follows feed, programmed_feed must be among the events.
  void observe(const base::Event& event);
  /// At this word, in the unit of S or of the output.
  double at(const base::Word& word) const {
    if (!is_on_) return 0;
    if (!laser_.follow_feed) return asked_;
    return programmed_feed_ > 0 ? asked_ * (word.feed / programmed_feed_) : 0;
  }

 private:
  Laser laser_;
  double asked_ = 0;
  double programmed_feed_ = 0;  ///< as Event::Kind::programmed_feed
  bool is_on_ = laser_.power == Laser::Power::analog_output;
};

}  // namespace leadscrew::machine
