// Canonical calls of feed per revolution and of constant surface speed, which the machine turns into a feed and a speed.

#include <cmath>
#include <leadscrew/gcode/canon.hpp>

namespace leadscrew::gcode {

void CanonWriter::write_feed_mode(bool per_revolution, std::string& text) {
  printed_.per_revolution = per_revolution;
  printed_.feed = 0;
  call(per_revolution ? "SET_FEED_MODE(0, 1)\n" : "SET_FEED_MODE(0, 0)\n", text);
}

// The speed of G96 is printed where S or D says another: the revolutions that follow from it are no calls.
void CanonWriter::write_spindle_mode(const ModalState& modal, bool may_tell_speed, std::string& text) {
  constexpr double no_limit = 1e30;  // as rs274 prints it
  const bool was_on = printed_.surface_speed;
  printed_.surface_speed = modal.constant_surface_speed;
  const double most = !modal.constant_surface_speed          ? 0
                      : std::isinf(modal.most_spindle_speed) ? no_limit
                                                             : modal.most_spindle_speed;
  if (was_on != printed_.surface_speed || most != printed_.most_spindle_speed) {
    printed_.most_spindle_speed = most;
    printed_.surface_speed_word = -1;
    call("SET_SPINDLE_MODE(0 ", text);
    number(most, text);
    text += ")\n";
  }
  const bool is_told = modal.surface_speed_word == printed_.surface_speed_word;
  if (!printed_.surface_speed || is_told || !may_tell_speed) return;
  printed_.surface_speed_word = modal.surface_speed_word;
  call("SET_SPINDLE_SPEED(0, ", text);
  number(modal.surface_speed_word, text);
  text += ")\n";
}

}  // namespace leadscrew::gcode
