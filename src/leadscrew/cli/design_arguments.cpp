#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <leadscrew/cli/design_arguments.hpp>
#include <utility>

namespace leadscrew::cli {

namespace {

using Text = std::optional<std::string>;

template <class... Values>
auto wrong(fmt::format_string<Values...> text, Values&&... values) {
  return tl::unexpected<std::string>(fmt::format(text, std::forward<Values>(values)...));
}

Parsed<std::vector<double>> parse_numbers(std::string_view option, std::string_view text) {
  std::vector<double> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const auto number = parse_number(rest.substr(0, comma));
    if (!number) return wrong("{} {}: needs numbers, such as 20,10", option, text);
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    rest.remove_prefix(comma + 1);
  }
}

/// A number that is asked for, and where it goes to.
struct Wanted {
  std::string_view option;
  const Text* text;
  double* value;
};

Parsed<void> take(std::initializer_list<Wanted> all) {
  std::vector<std::string_view> missing;
  for (const Wanted& wanted : all) {
    if (!*wanted.text) {
      missing.push_back(wanted.option);
      continue;
    }
    const auto number = parse_number(**wanted.text);
    if (!number) return wrong("{} {}: {}; units are those of --help", wanted.option, **wanted.text, number.error());
    *wanted.value = *number;
  }
  if (!missing.empty()) return wrong("{} {} missing", fmt::join(missing, ", "), missing.size() > 1 ? "are" : "is");
  return {};
}

/// An option of another question would be ignored.
Parsed<void> refuse(std::string_view question, std::initializer_list<std::pair<std::string_view, const Text*>> others) {
  for (const auto& [option, text] : others) {
    if (*text) return wrong("{} is not for {}", option, question);
  }
  return {};
}

Parsed<DdaQuestion::Line> parse_line(const DesignTexts& texts) {
  if (!texts.to) return wrong("--to is missing: where the line ends, such as 120,60");
  DdaQuestion::Line line;
  if (const auto taken = take({{"--feed", &texts.feed, &line.feed_mm_min}}); !taken)
    return tl::unexpected(taken.error());
  const auto to = parse_numbers("--to", *texts.to);
  if (!to) return tl::unexpected(to.error());
  line.way_mm = *to;
  if (!texts.from) return line;
  const auto from = parse_numbers("--from", *texts.from);
  if (!from) return tl::unexpected(from.error());
  if (from->size() != to->size()) return wrong("--from {} and --to {}: one has more axes", *texts.from, *texts.to);
  for (std::size_t axis = 0; axis < from->size(); ++axis) line.way_mm[axis] -= (*from)[axis];
  return line;
}

Parsed<DesignArguments> parse_dda(const DesignTexts& texts) {
  DdaQuestion question;
  const auto taken = refuse("a linear interpolator", {{"--clock", &texts.clock},
                                                      {"--delays", &texts.delays},
                                                      {"--distance", &texts.distance},
                                                      {"--radius", &texts.radius},
                                                      {"--resolution", &texts.resolution},
                                                      {"--digits", &texts.digits}})
                         .and_then([&] {
                           return take({{"--travel", &texts.travel, &question.range.travel_mm},
                                        {"--blu", &texts.blu, &question.range.blu_mm},
                                        {"--max-feed", &texts.max_feed, &question.range.max_feed_mm_min},
                                        {"--min-distance", &texts.min_distance, &question.range.min_distance_mm}});
                         });
  if (!taken) return tl::unexpected(taken.error());
  if (!texts.from && !texts.to && !texts.feed) return question;
  auto line = parse_line(texts);
  if (!line) return tl::unexpected(line.error());
  question.line = std::move(*line);
  return question;
}

Parsed<DesignArguments> parse_timer(const DesignTexts& texts) {
  TimerQuestion question;
  const auto taken = refuse("--timer", {{"--travel", &texts.travel},
                                        {"--blu", &texts.blu},
                                        {"--max-feed", &texts.max_feed},
                                        {"--min-distance", &texts.min_distance},
                                        {"--from", &texts.from},
                                        {"--to", &texts.to},
                                        {"--feed", &texts.feed},
                                        {"--distance", &texts.distance},
                                        {"--radius", &texts.radius},
                                        {"--resolution", &texts.resolution},
                                        {"--digits", &texts.digits}})
                         .and_then([&] { return take({{"--clock", &texts.clock, &question.clock_pps}}); });
  if (!taken) return tl::unexpected(taken.error());
  if (!texts.delays) return wrong("--delays is missing: seconds, such as 2,4,8");
  auto delays = parse_numbers("--delays", *texts.delays);
  if (!delays) return tl::unexpected(delays.error());
  question.delays = std::move(*delays);
  return question;
}

Parsed<DesignArguments> parse_inverse_time(const DesignTexts& texts) {
  InverseTimeQuestion question;
  question.range.resolution = 0.01;  // Koren's, in/min
  const auto taken = refuse("--inverse-time", {{"--min-distance", &texts.min_distance},
                                               {"--from", &texts.from},
                                               {"--to", &texts.to},
                                               {"--clock", &texts.clock},
                                               {"--delays", &texts.delays}})
                         .and_then([&] {
                           return take({{"--travel", &texts.travel, &question.range.max_distance},
                                        {"--blu", &texts.blu, &question.range.blu},
                                        {"--max-feed", &texts.max_feed, &question.range.max_feed}});
                         })
                         .and_then([&]() -> Parsed<void> {
                           if (!texts.resolution) return {};
                           return take({{"--resolution", &texts.resolution, &question.range.resolution}});
                         });
  if (!taken) return tl::unexpected(taken.error());
  if (texts.digits) {
    const bool is_digit = texts.digits->size() == 1 && (*texts.digits)[0] >= '1' && (*texts.digits)[0] <= '9';
    if (!is_digit) return wrong("--digits {}: is not a whole number from 1 to 9", *texts.digits);
    question.range.digits = (*texts.digits)[0] - '0';
  }
  if (!texts.distance && !texts.radius && !texts.feed) return question;
  if (texts.distance && texts.radius) return wrong("--distance is for lines, --radius for arcs: one of them");
  InverseTimeQuestion::Block block{.distance = 0, .is_radius = texts.radius.has_value(), .feed = 0};
  const Wanted distance = block.is_radius ? Wanted{"--radius", &texts.radius, &block.distance}
                                          : Wanted{"--distance", &texts.distance, &block.distance};
  if (const auto found = take({distance, {"--feed", &texts.feed, &block.feed}}); !found)
    return tl::unexpected(found.error());
  question.block = block;
  return question;
}

}  // namespace

Parsed<DesignArguments> parse_design(const DesignTexts& texts) {
  if (texts.timer && texts.inverse_time) return wrong("--timer and --inverse-time: one at a time");
  if (texts.timer) return parse_timer(texts);
  return texts.inverse_time ? parse_inverse_time(texts) : parse_dda(texts);
}

}  // namespace leadscrew::cli
