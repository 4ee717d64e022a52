#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/pulse_arguments.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <limits>
#include <memory>

namespace leadscrew::cli {

namespace {

using nc::PulseMethod;

constexpr const char* pulse_help =
    "Examples:\n"
    "  leadscrew pulse --arc --start 5,0 --end 0,5 --center 0,0 --ccw --method dda\n"
    "  leadscrew pulse --arc --start 25,0 --end 25,0 --cw --svg circle.svg --vcd circle.vcd\n"
    "  leadscrew pulse --line --end 11,-7 --method dda,bresenham --bits 4 --table\n"
    "  leadscrew pulse --ellipse 12,7 --start 12,0 --end 0,-7 --cw --table\n"
    "\n"
    "Integers are BLU. A full circle ends where it starts. Each method's conventions are by default those with which "
    "it\n"
    "gives its published figures; --json names all that were in force.\n"
    "\n"
    "Columns of --table: x y from the centre or a line's start, F the deviation; n1 n2 n3 what F would be after a "
    "step\n"
    "of both axes, of y, of x; d = 4(d1 - d2) of improved-min-error; Jx Jy integrands, rx ry remainders, nx ny steps\n"
    "left, n clocks left with --free, q the capacity. Of an ellipse r and q are taken so many times that all are "
    "whole.\n"
    "--vcd has them under the papers' names too, and says which is which: rst Val_z Val_f Val_n1\n"
    "Sum_Z and, for koren, y1 r1 dz1.\n";

/// As they are given; the curve is made of them at the end.
struct GivenCurve {
  bool arc = false, line = false, clockwise = false, counterclockwise = false;
  pulse::Point semi_axes;
};

/// Of more than 64 bits: the nearest in them.
Parsed<std::int64_t> parse_coordinate(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument)
    return wrong("coordinates are whole numbers of BLU, such as 5,0");
  if (error == std::errc()) return value;
  using Limits = std::numeric_limits<std::int64_t>;
  return text.front() == '-' ? Limits::min() : Limits::max();
}

/// x,y in BLU; `of`: what the point is.
Parsed<pulse::Point> parse_point(std::string_view of, std::string_view text, std::vector<base::Diagnostic>& overflows) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return wrong("needs two numbers, such as 5,0");
  pulse::Point point;
  for (const auto& [name, digits, coordinate] :
       {std::tuple("x", text.substr(0, comma), &point.x), {"y", text.substr(comma + 1), &point.y}}) {
    const auto parsed = parse_coordinate(digits);
    if (!parsed) return tl::unexpected(parsed.error());
    *coordinate = *parsed;
    if (*parsed < -pulse::greatest_coordinate || *parsed > pulse::greatest_coordinate)
      overflows.push_back(nc::overflow_beyond(name, fmt::format("{} of the {}", name, of), digits));
  }
  return point;
}

/// Values by their names.
template <class T, std::size_t count>
std::vector<std::pair<std::string_view, T>> named(const std::array<T, count>& values) {
  std::vector<std::pair<std::string_view, T>> pairs;
  for (const T value : values) pairs.emplace_back(nc::name(value), value);
  return pairs;
}

/// Without spaces around it.
std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Parsed<std::vector<PulseMethod>> parse_methods(std::string_view text) {
  std::vector<PulseMethod> methods;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view name = trimmed(text.substr(0, comma));
    const auto method = parse_pulse_method(name);
    const bool is_only = methods.empty() && comma == std::string_view::npos;
    if (!method) return is_only ? wrong("{}", method.error()) : wrong("{} {}", name, method.error());
    if (std::find(methods.begin(), methods.end(), *method) != methods.end()) return wrong("{} is named twice", name);
    methods.push_back(*method);
    if (comma == std::string_view::npos) return methods;
    text.remove_prefix(comma + 1);
  }
}

template <class Number, Number most>
Parsed<Number> parse_count(std::string_view text) {
  const auto count = parse_coordinate(text);
  if (!count || *count < 1 || *count > most) return wrong("is not a whole number from 1 to {}", most);
  return static_cast<Number>(*count);
}

Parsed<void> check_curve(const Command& command, const GivenCurve& given) {
  const bool is_arc = given.arc || command.given("--ellipse");
  if (given.arc + given.line + command.given("--ellipse") != 1)
    return wrong("needs one of --arc, --line and --ellipse");
  if (given.clockwise && given.counterclockwise) return wrong("--cw and --ccw: an arc goes one way");
  if (!command.given("--end"))
    return wrong("--end is missing: where the {} ends, such as 0,5", is_arc ? "arc" : "line");
  if (is_arc && !command.given("--start")) return wrong("--start is missing: where the arc starts, such as 5,0");
  const std::string_view of_arcs = command.first_given({"--center", "--cw", "--ccw"});
  if (given.line && !of_arcs.empty()) return wrong("{} is for arcs", of_arcs);
  return {};
}

/// An option that none of the methods has would be ignored.
Parsed<void> check_use(const PulseArguments& arguments) {
  const nc::MethodOptions& options = arguments.options;
  if (options.bits && options.capacity)
    return wrong("--bits and --capacity: registers of N bits have the capacity 2^N, give one of the two");
  const std::string unused = nc::unused_option(options, arguments.methods, arguments.curve);
  if (!unused.empty()) return wrong("--{}", unused);
  const std::string_view conflict = nc::conflict_of(options, arguments.curve);
  if (!conflict.empty()) return wrong("{}", conflict);
  return {};
}

/// Of what is told on standard output.
Parsed<void> check_outputs(const PulseArguments& pulse, bool json) {
  if (pulse.path && !json) return wrong("--path is for --json; --table is the same as text");
  if (pulse.table && json) return wrong("--table is text; with --json, --path gives every place");
  return {};
}

void add_curve(Command& command, PulseArguments& pulse, GivenCurve& given) {
  command.flag("--arc", "An arc", given.arc);
  command.flag("--line", "A straight line", given.line);
  command.value("--ellipse", "A,B", "An arc of the ellipse with these semi-axes along X and Y", given.semi_axes,
                [&pulse](std::string_view text) { return parse_point("semi-axes", text, pulse.overflows); });
  const auto add_point = [&](const char* option, const char* what, const char* of, pulse::Point& point) {
    command.value(option, "X,Y", what, point,
                  [of, &pulse](std::string_view text) { return parse_point(of, text, pulse.overflows); });
  };
  add_point("--start", "Where it starts (of a line, default: 0,0)", "start", pulse.curve.start);
  add_point("--end", "Where it ends", "end", pulse.curve.end);
  add_point("--center", "Of an arc (default: 0,0)", "centre", pulse.curve.center);
  command.flag("--cw", "Clockwise", given.clockwise);
  command.flag("--ccw", "Counterclockwise (default)", given.counterclockwise);
}

void add_methods(Command& command, PulseArguments& pulse) {
  nc::MethodOptions& options = pulse.options;
  command.value("--method", "LIST", "Some of " + names_of_pulse_methods() + " (default: all)", pulse.methods,
                parse_methods, {.words = pulse_method_names(), .is_list = true});
  command.value("--bits", "N", "Width of the registers; the capacity of dda is then 2^N", options.bits,
                parse_count<int, nc::most_pulse_bits>);
  command.value("--capacity", "N", "At which dda and koren overflow, fixed (default: by the curve, as --json says)",
                options.capacity, parse_count<std::int64_t, pulse::greatest_coordinate>);
  command.choice("--preload", "LOAD", "Of the remainders: zero, half, half-lagging, full or minus-one", options.preload,
                 named(nc::all_preloads));
  command.choice("--tie", "WAY", "Where point comparison goes on the circle: outward or inward", options.tie,
                 named(nc::all_ties));
  command.choice("--order", "ORDER", "Of the integrators of arcs: parallel, x-first, shrinking-first or growing-first",
                 options.order, named(nc::all_orders));
  command.flag("--free", "Arcs by dda and koren without counters: as many clocks as the angle takes", options.free);
  command.choice("--accumulation", "WAY", "Of negative integrands with --free: sign-magnitude, floor or symmetric",
                 options.accumulation, named(nc::all_accumulations));
  command.value("--places", "N", "Binary places of the radius in the capacity of arcs by dda and koren, 1 to 16",
                options.places, parse_count<int, nc::most_places>);
}

}  // namespace

Parsed<PulseMethod> parse_pulse_method(std::string_view text) {
  for (const PulseMethod method : nc::all_pulse_methods) {
    if (text == nc::name(method)) return method;
  }
  const auto names = pulse_method_names();
  const std::vector<std::string_view> known(names.begin(), names.end());
  return wrong("is none of {}{}", names_of_pulse_methods(), base::did_you_mean(text, known));
}

std::vector<std::string> pulse_method_names() {
  std::vector<std::string> names;
  for (const PulseMethod method : nc::all_pulse_methods) names.emplace_back(nc::name(method));
  return names;
}

std::string names_of_pulse_methods() {
  return fmt::format("{}", fmt::join(pulse_method_names(), ", "));
}

void describe_pulse(Command& command, Arguments& arguments) {
  PulseArguments& pulse = arguments.pulse;
  pulse.methods = {nc::all_pulse_methods.begin(), nc::all_pulse_methods.end()};
  // Lives as long as the check.
  const auto given = std::make_shared<GivenCurve>();
  add_curve(command, pulse, *given);
  add_methods(command, pulse);
  command.flag("--table", "Every register at every clock, as text", pulse.table);
  command.flag("--path", "Every place, in JSON", pulse.path);
  command.output("--vcd", "FILE.vcd", "Write every register at every clock", pulse.vcd, {".vcd"});
  command.output("--svg", "FILE.svg", "Write the steps over the true curve", pulse.svg, {".svg"});
  add_output(command, arguments);
  command.check([&command, &arguments, given]() -> Parsed<void> {
    using Shape = nc::PulseCurve::Shape;
    nc::PulseCurve& curve = arguments.pulse.curve;
    curve.shape = given->line ? Shape::line : Shape::arc;
    if (command.given("--ellipse")) curve.semi_axes = {given->semi_axes.x, given->semi_axes.y};
    if (curve.is_ellipse() && !command.given("--method"))
      std::erase_if(arguments.pulse.methods, [](PulseMethod method) { return !nc::uses_of(method).ellipse; });
    curve.direction = given->clockwise ? pulse::Direction::clockwise : pulse::Direction::counterclockwise;
    return check_curve(command, *given)
        .and_then([&] { return check_outputs(arguments.pulse, arguments.json); })
        .and_then([&] { return check_use(arguments.pulse); });
  });
  command.help(pulse_help);
}

}  // namespace leadscrew::cli
