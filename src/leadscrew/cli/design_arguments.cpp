#include <fmt/format.h>
#include <fmt/ranges.h>

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/design_arguments.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <memory>

namespace leadscrew::cli {

namespace {

using results::DdaQuestion;
using results::InverseTimeQuestion;
using results::SizingQuestion;
using results::TimerQuestion;
using Names = std::initializer_list<std::string_view>;

constexpr const char* design_examples =
    "Examples:\n"
    "  leadscrew design --travel 600 --blu 0.01 --max-feed 12000 --min-distance 50 \\\n"
    "      --from 20,10 --to 120,60 --feed 3000\n"
    "  leadscrew design --timer --clock 1024 --delays 2,4,8\n"
    "  leadscrew design --inverse-time --travel 12 --blu 0.0001 --max-feed 30 --distance 2 --feed 10\n"
    "\n"
    "Millimetres and mm/min; of --inverse-time any unit of length, and that unit a minute: the example's is the "
    "inch.\n";

/// As they are given: each question has its own.
struct GivenDesign {
  bool timer = false, inverse_time = false;
  double travel = 0, blu = 0, max_feed = 0, min_distance = 0, feed = 0, clock = 0;
  double distance = 0, radius = 0, resolution = 0.01;  // Koren's, in/min
  int digits = InverseTimeQuestion{}.range.digits;
  std::vector<double> from, to, delays;
};

Parsed<double> parse_quantity(std::string_view text) {
  auto number = parse_number(text);
  if (!number) return wrong("{}; units are those of --help", number.error());
  return number;
}

Parsed<std::vector<double>> parse_list(std::string_view text) {
  auto numbers = parse_numbers(text);
  if (!numbers) return wrong("needs numbers, such as 20,10");
  return numbers;
}

Parsed<int> parse_digits(std::string_view text) {
  const bool is_digit = text.size() == 1 && text[0] >= '1' && text[0] <= '9';
  if (!is_digit) return wrong("is not a whole number from 1 to 9");
  return text[0] - '0';
}

Parsed<void> need(const Command& command, Names names) {
  std::vector<std::string_view> missing;
  for (const std::string_view name : names) {
    if (!command.given(name)) missing.push_back(name);
  }
  if (!missing.empty()) return wrong("{} {} missing", fmt::join(missing, ", "), missing.size() > 1 ? "are" : "is");
  return {};
}

/// An option of another question would be ignored.
Parsed<void> refuse(const Command& command, std::string_view question, Names others) {
  const std::string_view option = command.first_given(others);
  if (!option.empty()) return wrong("{} is not for {}", option, question);
  return {};
}

Parsed<DdaQuestion::Line> line_of(const Command& command, const GivenDesign& given) {
  if (!command.given("--to")) return wrong("--to is missing: where the line ends, such as 120,60");
  if (const auto needed = need(command, {"--feed"}); !needed) return tl::unexpected(needed.error());
  DdaQuestion::Line line{.delta_mm = given.to, .feed_mm_min = given.feed};
  if (!command.given("--from")) return line;
  if (given.from.size() != given.to.size())
    return wrong("--from {} and --to {}: one has more axes", command.text_of("--from"), command.text_of("--to"));
  for (std::size_t axis = 0; axis < given.from.size(); ++axis) line.delta_mm[axis] -= given.from[axis];
  return line;
}

Parsed<SizingQuestion> dda_of(const Command& command, const GivenDesign& given) {
  const auto sound =
      refuse(command, "a linear interpolator",
             {"--clock", "--delays", "--distance", "--radius", "--resolution", "--digits"})
          .and_then([&] { return need(command, {"--travel", "--blu", "--max-feed", "--min-distance"}); });
  if (!sound) return tl::unexpected(sound.error());
  DdaQuestion question;
  question.range.travel_mm = given.travel;
  question.range.blu_mm = given.blu;
  question.range.max_feed_mm_min = given.max_feed;
  question.range.min_distance_mm = given.min_distance;
  if (command.first_given({"--from", "--to", "--feed"}).empty()) return question;
  auto line = line_of(command, given);
  if (!line) return tl::unexpected(line.error());
  question.line = std::move(*line);
  return question;
}

Parsed<SizingQuestion> timer_of(const Command& command, const GivenDesign& given) {
  const auto sound = refuse(command, "--timer",
                            {"--travel", "--blu", "--max-feed", "--min-distance", "--from", "--to", "--feed",
                             "--distance", "--radius", "--resolution", "--digits"})
                         .and_then([&] { return need(command, {"--clock"}); });
  if (!sound) return tl::unexpected(sound.error());
  if (!command.given("--delays")) return wrong("--delays is missing: seconds, such as 2,4,8");
  return TimerQuestion{.clock_pps = given.clock, .delays = given.delays};
}

Parsed<SizingQuestion> inverse_time_of(const Command& command, const GivenDesign& given) {
  const auto sound =
      refuse(command, "--inverse-time", {"--min-distance", "--from", "--to", "--clock", "--delays"}).and_then([&] {
        return need(command, {"--travel", "--blu", "--max-feed"});
      });
  if (!sound) return tl::unexpected(sound.error());
  InverseTimeQuestion question;
  question.range.max_distance = given.travel;
  question.range.blu = given.blu;
  question.range.max_feed = given.max_feed;
  question.range.resolution = given.resolution;
  question.range.digits = given.digits;
  if (command.first_given({"--distance", "--radius", "--feed"}).empty()) return question;
  const bool is_radius = command.given("--radius");
  if (command.given("--distance") && is_radius) return wrong("--distance is for lines, --radius for arcs: one of them");
  const auto needed = need(command, {is_radius ? "--radius" : "--distance", "--feed"});
  if (!needed) return tl::unexpected(needed.error());
  question.block = {.distance = is_radius ? given.radius : given.distance, .is_radius = is_radius, .feed = given.feed};
  return question;
}

}  // namespace

void describe_design(Command& command, Arguments& arguments) {
  // Lives as long as the check.
  const auto given = std::make_shared<GivenDesign>();
  const auto add = [&](const char* name, const char* unit, const char* what, double& target) {
    command.value(name, unit, what, target, parse_quantity);
  };
  add("--travel", "MM", "Greatest travel of an axis", given->travel);
  add("--blu", "MM", "Basic length unit: a step", given->blu);
  add("--max-feed", "MM/MIN", "Greatest feed", given->max_feed);
  add("--min-distance", "MM", "Shortest line at the greatest feed", given->min_distance);
  command.value("--from", "X,Y,...", "Where a line starts (default: 0)", given->from, parse_list);
  command.value("--to", "X,Y,...", "Where it ends", given->to, parse_list);
  add("--feed", "MM/MIN", "Along it", given->feed);
  command.flag("--timer", "A timer: first overflow after each delay", given->timer);
  add("--clock", "PULSES/S", "Of the timer", given->clock);
  command.value("--delays", "S,...", "Of the timer", given->delays, parse_list);
  command.flag("--inverse-time", "Feed words of the inverse-time code, and of software", given->inverse_time);
  add("--distance", "UNITS", "Length of a line, for --inverse-time", given->distance);
  add("--radius", "UNITS", "Radius of an arc, for --inverse-time", given->radius);
  add("--resolution", "UNITS/MIN", "Of the feed in software (default: 0.01)", given->resolution);
  command.value("--digits", "N", "Of the inverse-time code (default: 4)", given->digits, parse_digits);
  add_output(command, arguments);
  command.check([&command, &arguments, given]() -> Parsed<void> {
    if (given->timer && given->inverse_time) return wrong("--timer and --inverse-time: one at a time");
    auto question = given->timer          ? timer_of(command, *given)
                    : given->inverse_time ? inverse_time_of(command, *given)
                                          : dda_of(command, *given);
    if (!question) return tl::unexpected(std::move(question.error()));
    arguments.design = std::move(*question);
    return {};
  });
  command.help(design_examples);
}

}  // namespace leadscrew::cli
