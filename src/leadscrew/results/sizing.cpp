#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <leadscrew/design/design_check.hpp>
#include <leadscrew/results/sizing.hpp>

namespace leadscrew::results {

namespace {

/// A line of the table: what, as a register holds it, as it ought to be.
std::string row(std::string_view what, std::string_view ours, std::string_view ideal, std::string_view unit) {
  std::string line = fmt::format("  {:<26} {:>22} {:>22}  {}", what, ours, ideal, unit);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string heading(const Style& style, const std::string& title) {
  return style(Tone::strong, title) + "\n" + style(Tone::faint, row("", "in the register", "ideal", ""));
}

std::string number(double value) {
  return fmt::format("{:.10g}", value);
}

std::string numbers(const std::vector<double>& values, int decimals = 2) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(fmt::format("{:.{}f}", value, decimals));
  return fmt::format("{}", fmt::join(texts, ", "));
}

Diagnostics problems_of(const DdaQuestion& question) {
  Diagnostics problems = design::problems_of(question.range);
  if (problems.empty() && question.line)
    problems = design::problems_of(question.range, question.line->delta_mm, question.line->feed_mm_min);
  return problems;
}

double feed_error(double feed, double asked) {
  return feed / asked - 1;
}

void add_line(Json& object, const design::DdaLine& line, double asked) {
  object["feed_word"] = line.feed_word;
  object["feed_pps"] = line.feed_pps;
  object["axis_pps"] = line.axis_pps;
  object["feed_mm_min"] = line.feed_mm_min;
  object["feed_error"] = feed_error(line.feed_mm_min, asked);
  object["time_s"] = line.seconds;
}

std::string line_text(const design::DdaLine& real, const design::DdaLine& ideal, double asked) {
  return row("pulses", fmt::format("{}", fmt::join(real.pulses, ", ")), "", "BLU") +
         row("feed word S", number(real.feed_word), fmt::format("{:.3f}", ideal.feed_word), "") +
         row("out of the feed DDA", numbers({real.feed_pps}), numbers({ideal.feed_pps}), "pulses/s") +
         row("steps of the axes", numbers(real.axis_pps), numbers(ideal.axis_pps), "pulses/s") +
         row("feed", numbers({real.feed_mm_min}), numbers({ideal.feed_mm_min}), "mm/min") +
         row("error of the feed", fmt::format("{:+.3f}", 100 * feed_error(real.feed_mm_min, asked)), "0", "%") +
         row("time", numbers({real.seconds}, 4), numbers({ideal.seconds}, 4), "s");
}

Sizing answer(const DdaQuestion& question, const Style& style) {
  const design::DdaRange& range = question.range;
  const design::DdaDesign design = design::design_dda(range);
  const double word_max = 10 * range.max_feed_mm_min / range.min_distance_mm;
  Sizing result{Json::object({{"schema", sizing_schema},
                              {"blu_mm", range.blu_mm},
                              {"axis_bits", design.axis_bits},
                              {"feed_bits", design.feed_bits},
                              {"clock_pps", design.clock_pps},
                              {"feed_word_max", design.feed_word_max}}),
                heading(style, "linear interpolator of digital integrators")};
  Json ideal = Json::object({{"axis_bits", std::log2(range.travel_mm / range.blu_mm + 1)},
                             {"feed_bits", std::log2(word_max + 1)},
                             {"clock_pps", design.clock_pps},
                             {"feed_word_max", word_max}});
  result.text += row("bits of the axis DDAs, n", number(design.axis_bits), "", "") +
                 row("bits of the feed DDA, m", number(design.feed_bits), "", "") +
                 row("clock f", numbers({design.clock_pps}), "", "pulses/s") +
                 row("greatest feed word", std::to_string(design.feed_word_max), number(word_max), "");
  if (question.line) {
    const double asked = question.line->feed_mm_min;
    const auto real = design::along_line(design, range, question.line->delta_mm, asked, true);
    const auto meant = design::along_line(design, range, question.line->delta_mm, asked, false);
    add_line(result.json, real, asked);
    result.json["feed_word"] = std::llround(real.feed_word);
    result.json["pulses"] = real.pulses;
    add_line(ideal, meant, asked);
    Json pulses = Json::list();
    for (const double delta : question.line->delta_mm) pulses.push_back(delta / range.blu_mm);
    ideal["pulses"] = std::move(pulses);
    result.text += line_text(real, meant, asked);
  }
  result.json["ideal"] = std::move(ideal);
  return result;
}

Diagnostics problems_of(const TimerQuestion& question) {
  return design::problems_of(question.clock_pps, question.delays);
}

Sizing answer(const TimerQuestion& question, const Style& style) {
  const design::DdaTimer timer = design::design_timer(question.clock_pps, question.delays);
  const double capacity = std::ldexp(1.0, timer.bits);
  std::vector<double> loads;
  for (const double delay : question.delays) loads.push_back(capacity / (delay * question.clock_pps));
  Sizing result{Json::object({{"schema", sizing_schema},
                              {"clock_pps", question.clock_pps},
                              {"bits", timer.bits},
                              {"register_max", static_cast<std::int64_t>(capacity) - 1},
                              {"delays_s", question.delays},
                              {"loads", timer.loads},
                              {"seconds", timer.seconds},
                              {"ideal", Json::object({{"loads", loads}, {"seconds", question.delays}})}}),
                heading(style, fmt::format("timer of a digital integrator, clock {:g} pulses/s", question.clock_pps))};
  result.text += row("bits", number(timer.bits), "", "");
  for (std::size_t i = 0; i < timer.loads.size(); ++i) {
    result.text += row(fmt::format("load for {:g} s", question.delays[i]), std::to_string(timer.loads[i]),
                       fmt::format("{:.4g}", loads[i]), "") +
                   row("  overflows after", fmt::format("{:.6g}", timer.seconds[i]),
                       fmt::format("{:.6g}", question.delays[i]), "s");
  }
  return result;
}

Diagnostics problems_of(const InverseTimeQuestion& question) {
  Diagnostics problems = design::problems_of(question.range);
  if (problems.empty() && question.block)
    problems = design::problems_of(question.range, question.block->distance, question.block->feed);
  return problems;
}

void add_word(Json& object, const design::FeedWord& word, double asked) {
  object["feed_word"] = word.word;
  object["feed"] = word.feed;
  object["feed_pps"] = word.feed_pps;
  object["feed_error"] = feed_error(word.feed, asked);
}

std::string word_text(const design::FeedWord& real, const design::FeedWord& ideal, double asked) {
  return row("feed word f", number(real.word), fmt::format("{:.4f}", ideal.word), "") +
         row("feed", fmt::format("{:.4f}", real.feed), fmt::format("{:.4f}", ideal.feed), "units/min") +
         row("", numbers({real.feed_pps}), numbers({ideal.feed_pps}), "pulses/s") +
         row("error of the feed", fmt::format("{:+.3f}", 100 * feed_error(real.feed, asked)), "0", "%");
}

Sizing answer(const InverseTimeQuestion& question, const Style& style) {
  const design::InverseTimeRange& range = question.range;
  const design::InverseTimeDesign design = design::design_inverse_time(range);
  Json software = Json::object({{"q0", design.software_feed_capacity},
                                {"clock_pps", design.software_clock_pps},
                                {"interrupt_us", 1e6 / design.software_clock_pps}});
  Json object = Json::object({{"schema", sizing_schema},
                              {"blu", range.blu},
                              {"q", design.capacity},
                              {"q0", design.feed_capacity},
                              {"clock_pps", design.clock_pps}});
  Json ideal = Json::object();
  std::string hard = heading(style, "hardware: inverse-time code, fixed capacity q") +
                     row("q", std::to_string(design.capacity), "", "BLU") +
                     row("q0", std::to_string(design.feed_capacity), "", "") +
                     row("clock w0", number(design.clock_pps), "", "pulses/s");
  std::string soft = heading(style, "software: capacity q = L or R") +
                     row("q0", std::to_string(design.software_feed_capacity), "", "") +
                     row("clock w0", number(design.software_clock_pps), "", "pulses/s") +
                     row("time between interrupts", number(1e6 / design.software_clock_pps), "", "us");
  if (question.block) {
    const auto& [distance, is_radius, feed] = *question.block;
    const auto real = design::inverse_time_word(range, distance, feed, true);
    const auto meant = design::inverse_time_word(range, distance, feed, false);
    const auto real_software = design::software_word(range, feed, true);
    const auto meant_software = design::software_word(range, feed, false);
    object[is_radius ? "radius" : "distance"] = distance;
    object["time_inverse_per_min"] = feed / distance;
    add_word(object, real, feed);
    object["feed_word"] = std::llround(real.word);
    add_word(ideal, meant, feed);
    add_word(software, real_software, feed);
    software["feed_word"] = std::llround(real_software.word);
    Json ideal_software = Json::object();
    add_word(ideal_software, meant_software, feed);
    ideal["software"] = std::move(ideal_software);
    hard += word_text(real, meant, feed);
    soft += word_text(real_software, meant_software, feed);
  }
  object["software"] = std::move(software);
  object["ideal"] = std::move(ideal);
  return {std::move(object), hard + soft};
}

}  // namespace

Diagnostics problems_of(const SizingQuestion& question) {
  return std::visit([](const auto& asked) { return problems_of(asked); }, question);
}

Sizing answer(const SizingQuestion& question, const Style& style) {
  return std::visit([&](const auto& asked) { return answer(asked, style); }, question);
}

}  // namespace leadscrew::results
