#include <charconv>
#include <cmath>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/canon.hpp>
#include <leadscrew/gcode/path_length.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double seconds_in_minute = 60;
constexpr std::size_t first_uvw = base::index(base::Axis::U);

double length_of(const base::AxisVector& from, const base::AxisVector& to, std::size_t first) {
  return numeric::hypot(to[first] - from[first], to[first + 1] - from[first + 1], to[first + 2] - from[first + 2]);
}

bool is_rotary_only(const Move& move) {
  return move.kind == Move::Kind::line && length_of(move.start, move.end, 0) == 0 &&
         length_of(move.start, move.end, first_uvw) == 0;
}

std::string_view name_of_plane(Plane plane) {
  switch (plane) {
    case Plane::XY:
      return "CANON_PLANE_XY";
    case Plane::ZX:
      return "CANON_PLANE_XZ";
    case Plane::YZ:
      return "CANON_PLANE_YZ";
    case Plane::UV:
    case Plane::WU:
    case Plane::VW:
      return "CANON_PLANE_UNKNOWN";  // as rs274 prints it
  }
  return {};
}

// Of events that are one call without a number of their own.
std::string_view plain_call(base::Event::Kind kind) {
  using Kind = base::Event::Kind;
  switch (kind) {
    case Kind::spindle_stop:
      return "STOP_SPINDLE_TURNING(0)";
    case Kind::spindle_clockwise:
      return "START_SPINDLE_CLOCKWISE(0)";
    case Kind::spindle_counterclockwise:
      return "START_SPINDLE_COUNTERCLOCKWISE(0)";
    case Kind::coolant_mist:
      return "MIST_ON()";
    case Kind::coolant_flood:
      return "FLOOD_ON()";
    case Kind::pause:
      return "PROGRAM_STOP()";
    case Kind::optional_pause:
      return "OPTIONAL_PROGRAM_STOP()";
    case Kind::program_end:
      return "PROGRAM_END()";
    default:
      return {};
  }
}

// Of events that name an output.
std::string_view output_call(base::Event::Kind kind) {
  using Kind = base::Event::Kind;
  switch (kind) {
    case Kind::digital_output_on_with_motion:
      return "SET_MOTION_OUTPUT_BIT";
    case Kind::digital_output_off_with_motion:
      return "CLEAR_MOTION_OUTPUT_BIT";
    case Kind::digital_output_on:
      return "SET_AUX_OUTPUT_BIT";
    case Kind::digital_output_off:
      return "CLEAR_AUX_OUTPUT_BIT";
    case Kind::analog_output_with_motion:
      return "SET_MOTION_OUTPUT_VALUE";
    case Kind::analog_output:
      return "SET_AUX_OUTPUT_VALUE";
    default:
      return {};
  }
}

// Of what a program lets the operator change.
std::string_view override_call(base::Event::Kind kind) {
  using Kind = base::Event::Kind;
  switch (kind) {
    case Kind::feed_override:
      return "FEED_OVERRIDE()\n";
    case Kind::spindle_override:
      return "SPEED_OVERRIDE(0)\n";
    case Kind::adaptive_feed:
      return "ADAPTIVE_FEED()\n";
    case Kind::feed_hold:
      return "FEED_HOLD()\n";
    default:
      return {};
  }
}

void add_fixed(double value, std::string& text, int decimals = 4) {
  char digits[400];
  char* end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
  std::string_view shown(digits, static_cast<std::size_t>(end - digits));
  if (shown == "-0.0000") shown.remove_prefix(1);
  text += shown;
}

}  // namespace

CanonWriter::CanonWriter(base::AxisSet axes)
    : has_uvw_(axes.contains(base::Axis::U) || axes.contains(base::Axis::V) || axes.contains(base::Axis::W)) {}

void CanonWriter::call(std::string_view name, std::string& text) {
  const std::string count = std::to_string(++calls_);
  constexpr std::size_t width = 5;
  if (count.size() < width) text.append(width - count.size(), ' ');
  text += count;
  text += " N..... ";
  text += name;
  first_argument_ = true;
}

void CanonWriter::number(double value, std::string& text) {
  if (!first_argument_) text += ", ";
  first_argument_ = false;
  add_fixed(value, text);
}

void CanonWriter::axes(const base::AxisVector& value, std::size_t first, std::size_t count, std::string& text) {
  for (std::size_t i = first; i < first + count; ++i) {
    number(base::is_rotary(base::all_axes[i]) ? value[i] : value[i] / printed_.unit, text);
  }
}

void CanonWriter::coordinates(const base::AxisVector& value, std::string& text) {
  axes(value, 0, has_uvw_ ? base::axis_count : first_uvw, text);
  text += ")\n";
}

void CanonWriter::begin(std::string& text) {
  call("USE_LENGTH_UNITS(CANON_UNITS_MM)\n", text);
  call("SET_G5X_OFFSET(1, ", text);
  coordinates({}, text);
  call("SET_G92_OFFSET(", text);
  coordinates({}, text);
  call("SET_XY_ROTATION(0.0000)\n", text);
  call("SET_FEED_REFERENCE(CANON_XYZ)\n", text);
}

void CanonWriter::write_frame(const Frame& frame, int system, std::string& text) {
  if (frame.length_unit != printed_.unit) {
    printed_.unit = frame.length_unit;
    printed_.feed = 0;  // of the other unit
    call(printed_.unit == 1 ? "USE_LENGTH_UNITS(CANON_UNITS_MM)\n" : "USE_LENGTH_UNITS(CANON_UNITS_INCHES)\n", text);
  }
  if (system != printed_.system || frame.system().origin != printed_.origin) {
    printed_.system = system;
    printed_.origin = frame.system().origin;
    call("SET_G5X_OFFSET(" + std::to_string(system) + ", ", text);
    coordinates(printed_.origin, text);
  }
  if (frame.shift() != printed_.shift) {
    printed_.shift = frame.shift();
    call("SET_G92_OFFSET(", text);
    coordinates(printed_.shift, text);
  }
  if (frame.system().rotation != printed_.rotation) {
    printed_.rotation = frame.system().rotation;
    call("SET_XY_ROTATION(", text);
    number(printed_.rotation, text);
    text += ")\n";
  }
  if (frame.tool() != printed_.tool) {
    printed_.tool = frame.tool();
    call("USE_TOOL_LENGTH_OFFSET(", text);
    axes(printed_.tool, 0, base::axis_count, text);
    text += ")\n";
  }
}

void CanonWriter::write_path(const Move& move, std::string& text) {
  if (move.plane != printed_.plane) {
    printed_.plane = move.plane;
    call("SELECT_PLANE(", text);
    text += name_of_plane(move.plane);
    text += ")\n";
  }
  const bool same_mode = printed_.path_known && move.path_mode == printed_.path_mode;
  if (same_mode && move.tolerance == printed_.tolerance && move.naive_cam_tolerance == printed_.naive_cam_tolerance) {
    return;
  }
  printed_.path_known = true;
  printed_.path_mode = move.path_mode;
  printed_.tolerance = move.tolerance;
  printed_.naive_cam_tolerance = move.naive_cam_tolerance;
  if (move.path_mode != PathMode::blend) {
    call(move.path_mode == PathMode::exact_path ? "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
                                                : "SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)\n",
         text);
    return;
  }
  call("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, ", text);
  number(move.tolerance / printed_.unit, text);
  text += ")\n";
  call("SET_NAIVECAM_TOLERANCE(", text);
  number(move.naive_cam_tolerance / printed_.unit, text);
  text += ")\n";
}

// In G93 the rate that the block's length and duration make, in G95 that of a revolution.
void CanonWriter::write_feed(const Move& move, std::string& text) {
  const bool per_revolution = move.feed.per_revolution > 0;
  if (per_revolution != printed_.per_revolution) write_feed_mode(per_revolution, text);
  const double along = move.feed.mode == Feed::Mode::per_second ? path_length(move) : 1;
  const double value = per_revolution ? move.feed.per_revolution : move.feed.value;
  const double unit = is_rotary_only(move) ? 1 : printed_.unit;
  const double feed = value * along * seconds_in_minute / unit;
  // Only what is seen in four decimals is another feed.
  if (std::fabs(feed - printed_.feed) < 1e-9 * std::fabs(feed)) return;
  printed_.feed = feed;
  call("SET_FEED_RATE(", text);
  number(feed, text);
  text += ")\n";
}

void CanonWriter::write_event(const base::Event& event, std::string& text) {
  using Kind = base::Event::Kind;
  if (const std::string_view whole = plain_call(event.kind); !whole.empty()) {
    call(whole, text);
    text += '\n';
    return;
  }
  const std::string value = std::to_string(static_cast<std::int64_t>(event.value));
  if (const std::string_view name = output_call(event.kind); !name.empty()) {
    call(name, text);
    text += "(" + std::to_string(event.output);
    first_argument_ = false;
    const bool is_analog = event.kind == Kind::analog_output || event.kind == Kind::analog_output_with_motion;
    if (is_analog) number(event.value, text);
    text += ")\n";
  } else if (event.kind == Kind::spindle_speed) {
    call("SET_SPINDLE_SPEED(0, ", text);
    number(event.value, text);
    text += ")\n";
  } else if (event.kind == Kind::tool_prepare) {
    call("SELECT_TOOL(" + value + ")\n", text);
  } else if (event.kind == Kind::turret_indexing) {
    call("CHANGE_TOOL(" + value + ")\n", text);
  } else if (event.kind == Kind::tool_change) {
    call("START_CHANGE()\n", text);
    call("STOP_SPINDLE_TURNING(0)\n", text);
    call("CHANGE_TOOL(" + value + ")\n", text);
  } else if (event.kind == Kind::pallet_pause) {
    call("PALLET_SHUTTLE()\n", text);
    call("PROGRAM_STOP()\n", text);
  } else if (event.kind == Kind::coolant_off) {
    call("MIST_OFF()\n", text);
    call("FLOOD_OFF()\n", text);
  } else {
    write_function(event, text);
  }
}

// M66 is not told there; of M100 … M199 rs274 knows none.
void CanonWriter::write_function(const base::Event& event, std::string& text) {
  using Kind = base::Event::Kind;
  const auto allow = [&](Kind kind, bool on) {
    call(on ? "ENABLE_" : "DISABLE_", text);
    text += override_call(kind);
  };
  switch (event.kind) {
    case Kind::spindle_orientation:
      call("ORIENT_SPINDLE(0", text);
      first_argument_ = false;
      number(event.value, text);
      text += ", " + std::to_string(event.output) + ")\n";
      if (event.q == 0) return;
      call("SPINDLE.0.WAIT_ORIENT_COMPLETE(", text);
      number(event.q, text);
      text += ")\n";
      return;
    case Kind::overrides_on:
    case Kind::overrides_off:
      allow(Kind::feed_override, event.kind == Kind::overrides_on);
      return allow(Kind::spindle_override, event.kind == Kind::overrides_on);
    case Kind::user_function:
      call(base::code_of(event), text);
      text += '(';
      number(event.value, text);
      number(event.q, text);
      text += ")\n";
      return;
    default:
      if (!override_call(event.kind).empty()) allow(event.kind, event.value != 0);
  }
}

bool CanonWriter::write_in_step(const Move& move, const Frame& frame, int system, std::string& text) {
  const base::Event::Kind kind = move.event.kind;
  const bool is_event = move.kind == Move::Kind::event;
  if (is_event && base::is_in_step(kind)) {
    if (move.event.output == base::in_tapping_cycle) return true;  // no call there
    printed_.in_step = move.event.value > 0;
    printed_.tap = kind == base::Event::Kind::rigid_tap ? Tap::in : Tap::no;
    if (!printed_.in_step) {
      call("STOP_SPEED_FEED_SYNCH()\n", text);
      return true;
    }
    write_frame(frame, system, text);
    write_path(move, text);
    call("START_SPEED_FEED_SYNC(", text);
    constexpr int decimals = 6;
    add_fixed(move.event.value / printed_.unit, text, decimals);
    text += ",0)\n";
    return true;
  }
  if (printed_.tap == Tap::in && !is_event) {
    printed_.tap = Tap::back;
    call("RIGID_TAP(", text);
    axes(frame.to_program(move.end), 0, 3, text);
    text += ")\n";
    return true;
  }
  if (printed_.tap != Tap::no) return true;
  if (is_event) return false;
  write_straight(move, frame, text);
  return true;
}

void CanonWriter::write_straight(const Move& move, const Frame& frame, std::string& text) {
  if (move.is_probing()) call("TURN_PROBE_ON()\n", text);
  call(move.feed.mode == Feed::Mode::rapid ? "STRAIGHT_TRAVERSE("
       : move.is_probing()                 ? "STRAIGHT_PROBE("
                                           : "STRAIGHT_FEED(",
       text);
  coordinates(frame.to_program(move.end), text);
  if (move.is_probing()) call("TURN_PROBE_OFF()\n", text);
}

void CanonWriter::write(const Move& move, const Frame& frame, int system, const ModalState& modal, std::string& text) {
  if ((printed_.in_step || move.kind == Move::Kind::event) && write_in_step(move, frame, system, text)) return;
  if (modal.constant_surface_speed || printed_.surface_speed) {
    const bool is_speed = move.kind == Move::Kind::event && move.event.kind == base::Event::Kind::spindle_speed;
    // Moves that cutter compensation keeps back are told when the program has been read beyond: S as its event comes, not
    // where the spindle is told before to follow X.
    const bool is_told_here = is_speed && move.line >= modal.surface_speed_line;
    write_spindle_mode(modal, is_told_here || modal.cutter_side == Code::G40, text);
    if (is_speed && modal.constant_surface_speed) return;
  }
  if (move.kind == Move::Kind::event) return write_event(move.event, text);
  if (move.kind == Move::Kind::dwell) {
    call("DWELL(", text);
    number(move.dwell_seconds, text);
    text += ")\n";
    return;
  }
  write_frame(frame, system, text);
  if (move.kind == Move::Kind::arc && is_untold(move, frame)) return;
  write_path(move, text);
  if (move.feed.mode != Feed::Mode::rapid) write_feed(move, text);
  switch (move.kind) {
    case Move::Kind::arc:
      return write_arc(move, frame, text);
    case Move::Kind::nurbs:
      // Its points are not printed there either.
      return call("NURBS_FEED(" + std::to_string(move.curve.points.size()) + ", ...)\n", text);
    default:
      return write_straight(move, frame, text);
  }
}

}  // namespace leadscrew::gcode
