#pragma once
// What of a drive is told to its viewers: server-sent events whose data are JSON objects (docs/schemas/live-*.json).

#include <leadscrew/drive/link.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::serve {

/// What does not change while it is driven.
struct LiveMachine {
  std::string program;       ///< its name
  bool has_text = false;     ///< may the program be read, as /live/program?
  bool may_control = false;  ///< by whoever knows the token
};
/// The event `machine`, the first of each viewer.
std::string machine_event(const machine::Machine& machine, const LiveMachine& live);

/// What is told beside what the drives feed back.
struct LiveState {
  enum class Kind { starting, moving, resting, held, hold_waits, hold_refused, paused, waiting, stopping };
  Kind kind = Kind::starting;
  double override_factor = 1;
  std::optional<std::int64_t> pause_line;  ///< of the M0, M1 or M60 where it stands
};
/// The event `sample`.
std::string sample_event(const machine::Machine& machine, const drive::Feedback& feedback, const LiveState& state);

/// The event `end`: no sample comes any more.
std::string end_event();

/// What a viewer with the token asks for; what is not named stays as it is.
struct Wish {
  std::optional<bool> hold;
  std::optional<double> override_factor;  ///< 0.1 … 2
  bool stop = false;                      ///< comes to rest on the path, and ends
  bool go_on = false;                     ///< past the pause where it stands
};
/// Of {"hold": true, "override": 0.8, "stop": true, "go_on": true}, one of them or more. Empty of anything else.
std::optional<Wish> wish_of(std::string_view body);

}  // namespace leadscrew::serve
