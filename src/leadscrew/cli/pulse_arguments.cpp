#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <leadscrew/cli/nearest.hpp>
#include <leadscrew/cli/output_name.hpp>
#include <leadscrew/cli/pulse_arguments.hpp>
#include <leadscrew/files/output_file.hpp>
#include <limits>

namespace leadscrew::cli {

namespace {

using nc::PulseMethod;

template <class... Values>
auto wrong(fmt::format_string<Values...> text, Values&&... values) {
  return tl::unexpected<std::string>(fmt::format(text, std::forward<Values>(values)...));
}

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
Parsed<pulse::Point> parse_point(std::string_view option, std::string_view of, std::string_view text,
                                 std::vector<base::Diagnostic>& overflows) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return wrong("{} {}: needs two numbers, such as 5,0", option, text);
  pulse::Point point;
  for (const auto& [name, digits, coordinate] :
       {std::tuple("x", text.substr(0, comma), &point.x), {"y", text.substr(comma + 1), &point.y}}) {
    const auto parsed = parse_coordinate(digits);
    if (!parsed) return wrong("{} {}: {}", option, text, parsed.error());
    *coordinate = *parsed;
    if (*parsed < -pulse::greatest_coordinate || *parsed > pulse::greatest_coordinate)
      overflows.push_back(nc::overflow_beyond(name, fmt::format("{} of the {}", name, of), digits));
  }
  return point;
}

/// One of the named values.
template <class T, std::size_t count>
Parsed<T> parse_name(std::string_view option, std::string_view text, const std::array<T, count>& known) {
  std::array<std::string_view, count> names;
  std::transform(known.begin(), known.end(), names.begin(), [](T value) { return nc::name(value); });
  const auto found = std::find(names.begin(), names.end(), text);
  if (found != names.end()) return known[static_cast<std::size_t>(found - names.begin())];
  return wrong("{} {}: is none of {}{}", option, text, fmt::join(names, ", "), did_you_mean(text, names));
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
    const auto method = parse_name("--method", trimmed(text.substr(0, comma)), nc::all_pulse_methods);
    if (!method) return tl::unexpected(method.error());
    if (std::find(methods.begin(), methods.end(), *method) != methods.end())
      return wrong("--method: {} is named twice", nc::name(*method));
    methods.push_back(*method);
    if (comma == std::string_view::npos) return methods;
    text.remove_prefix(comma + 1);
  }
}

Parsed<nc::PulseCurve> parse_curve(const PulseTexts& texts, std::vector<base::Diagnostic>& overflows) {
  using Shape = nc::PulseCurve::Shape;
  if (texts.arc == texts.line) return wrong("needs either --arc or --line");
  if (texts.clockwise && texts.counterclockwise) return wrong("--cw and --ccw: an arc goes one way");
  if (!texts.end) return wrong("--end is missing: where the {} ends, such as 0,5", texts.arc ? "arc" : "line");
  if (texts.arc && !texts.start) return wrong("--start is missing: where the arc starts, such as 5,0");
  if (texts.line && (texts.center || texts.clockwise || texts.counterclockwise))
    return wrong("{} is for arcs", texts.center ? "--center" : texts.clockwise ? "--cw" : "--ccw");
  nc::PulseCurve curve;
  curve.shape = texts.arc ? Shape::arc : Shape::line;
  curve.direction = texts.clockwise ? pulse::Direction::clockwise : pulse::Direction::counterclockwise;
  for (const auto& [option, of, text, point] : {std::tuple("--start", "start", &texts.start, &curve.start),
                                                {"--end", "end", &texts.end, &curve.end},
                                                {"--center", "centre", &texts.center, &curve.center}}) {
    if (!*text) continue;
    const auto parsed = parse_point(option, of, **text, overflows);
    if (!parsed) return tl::unexpected(parsed.error());
    *point = *parsed;
  }
  return curve;
}

template <class T, std::size_t count>
Parsed<void> take_name(std::string_view option, const std::optional<std::string>& text,
                       const std::array<T, count>& known, std::optional<T>& value) {
  if (!text) return {};
  const auto parsed = parse_name(option, *text, known);
  if (!parsed) return tl::unexpected(parsed.error());
  value = *parsed;
  return {};
}

Parsed<nc::MethodOptions> parse_options(const PulseTexts& texts) {
  nc::MethodOptions options;
  if (texts.bits) {
    int bits = 0;
    const char* const last = texts.bits->data() + texts.bits->size();
    const auto [end, error] = std::from_chars(texts.bits->data(), last, bits);
    if (error != std::errc() || end != last || bits < 1 || bits > nc::most_pulse_bits)
      return wrong("--bits {}: is not a whole number from 1 to {}", *texts.bits, nc::most_pulse_bits);
    options.bits = bits;
  }
  const auto taken = take_name("--preload", texts.preload, nc::all_preloads, options.preload)
                         .and_then([&] { return take_name("--tie", texts.tie, nc::all_ties, options.tie); })
                         .and_then([&] { return take_name("--order", texts.order, nc::all_orders, options.order); });
  if (!taken) return tl::unexpected(taken.error());
  return options;
}

/// An option that none of the methods has would be ignored.
Parsed<void> check_use(const PulseArguments& arguments) {
  const bool is_arc = arguments.curve.is_arc();
  const auto is_any = [&](std::initializer_list<PulseMethod> methods) {
    return std::find_first_of(arguments.methods.begin(), arguments.methods.end(), methods.begin(), methods.end()) !=
           arguments.methods.end();
  };
  const bool integrates = is_any({PulseMethod::dda, PulseMethod::koren});
  if (arguments.options.preload && !integrates) return wrong("--preload is for dda and koren");
  if (arguments.options.order && !(integrates && is_arc)) return wrong("--order is for arcs by dda and koren");
  if (arguments.options.tie && !(is_arc && is_any({PulseMethod::point_comparison})))
    return wrong("--tie is for arcs by point-comparison");
  return {};
}

/// Each ending belongs to one option.
Parsed<void> check_files(const PulseTexts& texts) {
  for (const auto& [option, text] : {std::pair("--vcd", &texts.vcd), {"--svg", &texts.svg}}) {
    if (auto sound = check_output_name(option, *text); !sound) return sound;
  }
  if (texts.vcd && files::extension(*texts.vcd) == ".svg")
    return wrong("--vcd {}: would write registers; --svg writes the picture", *texts.vcd);
  if (texts.svg && files::extension(*texts.svg) == ".vcd")
    return wrong("--svg {}: would write the picture; --vcd writes registers", *texts.svg);
  return {};
}

}  // namespace

Parsed<PulseMethod> parse_pulse_method(std::string_view text) {
  for (const PulseMethod method : nc::all_pulse_methods) {
    if (text == nc::name(method)) return method;
  }
  std::vector<std::string_view> names;
  for (const PulseMethod method : nc::all_pulse_methods) names.push_back(nc::name(method));
  return wrong("is none of {}{}", names_of_pulse_methods(), did_you_mean(text, names));
}

std::string names_of_pulse_methods() {
  std::string names;
  for (const PulseMethod method : nc::all_pulse_methods)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", nc::name(method));
  return names;
}

Parsed<PulseArguments> parse_pulse(const PulseTexts& texts, bool json) {
  PulseArguments arguments{.path = texts.path, .table = texts.table, .vcd = texts.vcd, .svg = texts.svg};
  const auto curve = parse_curve(texts, arguments.overflows);
  if (!curve) return tl::unexpected(curve.error());
  const auto options = parse_options(texts);
  if (!options) return tl::unexpected(options.error());
  arguments.curve = *curve;
  arguments.options = *options;
  arguments.methods = {nc::all_pulse_methods.begin(), nc::all_pulse_methods.end()};
  if (texts.methods) {
    auto methods = parse_methods(*texts.methods);
    if (!methods) return tl::unexpected(methods.error());
    arguments.methods = std::move(*methods);
  }
  if (texts.path && !json) return wrong("--path is for --json; --table is the same as text");
  if (texts.table && json) return wrong("--table is text; with --json, --path gives every place");
  if (const auto sound = check_files(texts); !sound) return tl::unexpected(sound.error());
  if (const auto used = check_use(arguments); !used) return tl::unexpected(used.error());
  return arguments;
}

}  // namespace leadscrew::cli
