#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/servo/axis_loop.hpp>
#include <leadscrew/study/blended_programs.hpp>
#include <leadscrew/study/curves.hpp>
#include <leadscrew/study/motion.hpp>
#include <leadscrew/study/studies.hpp>
#include <string>
#include <vector>

// Lin and Koren, "Real-time interpolators for multi-axis CNC machine tools", section 5: the plane cubic as one curve
// block, and as 92 lines with a stop at each, through the same servo loops. What the paper does not say is taken as
// follows: the plant is K/(s(τs + 1)) in both axes; lines are equal in u; each begins and ends at rest and is as fast
// between as one acceleration allows, 106.3 mm/s²: the one with which the lines take the time that was measured, 10.1 s.

namespace leadscrew::study {

namespace {

constexpr double feed = 10, period = 0.01;  // mm/s, s
constexpr int lines = 92;
constexpr double acceleration = 106.3;  // mm/s²
constexpr Source measured_in_paper = {Paper::real_time_interpolators, "section 5"};
constexpr Published decoding(0.3, measured_in_paper);  // s for all lines

struct Place {
  double x = 0, y = 0;
};

Place cubic(double u) {
  return {20 * u, ((-50 * u + 80) * u - 10) * u};
}

/// Δu of Taylor's series of second order.
std::vector<Place> words_of_curve() {
  const std::vector<geometry::Nurbs> pieces = geometry::smooth_pieces(plane_cubic());
  std::vector<Place> words = {cubic(0)};
  for (const geometry::Nurbs& piece : pieces) {
    for (double u = piece.first_parameter(); u < piece.last_parameter();) {
      u = interpolator::next_parameter(piece, interpolator::StepRule::taylor2, u, 0, feed * period);
      const geometry::PointJet jet = piece.jets_at(u);
      words.push_back({jet[0].value, jet[1].value});
    }
  }
  return words;
}

/// A line from rest to rest.
struct Line {
  Place from, to;
  double length = 0;
  double peak = 0;  ///< speed, mm/s
  double time = 0;  ///< of cutting, s
};

std::vector<Line> lines_of_cubic() {
  std::vector<Line> all;
  for (int k = 0; k < lines; ++k) {
    Line line{cubic(static_cast<double>(k) / lines), cubic(static_cast<double>(k + 1) / lines)};
    line.length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    line.peak = std::min(feed, std::sqrt(line.length * acceleration));
    line.time = line.length / line.peak + line.peak / acceleration;
    all.push_back(line);
  }
  return all;
}

/// Distance from the line's start, at a time 0 … line.time.
double distance_at(const Line& line, double time) {
  const double ramp = line.peak / acceleration, left = line.time - time;
  if (time < ramp) return acceleration * time * time / 2;
  if (left < ramp) return line.length - acceleration * left * left / 2;
  return line.peak * (time - ramp / 2);
}

/// Each line is read and decoded while the table stands.
std::vector<Place> words_of_lines(const std::vector<Line>& all) {
  std::vector<Place> words;
  double begins = 0;
  for (const Line& line : all) {
    begins += decoding.value / lines;
    while (static_cast<double>(words.size()) * period < begins + line.time) {
      const double time = std::max(0.0, static_cast<double>(words.size()) * period - begins);
      const double share = distance_at(line, time) / line.length;
      words.push_back(
          {line.from.x + share * (line.to.x - line.from.x), line.from.y + share * (line.to.y - line.from.y)});
    }
    begins += line.time;
  }
  words.push_back(all.back().to);
  return words;
}

struct Plant {
  double gain = 0, time_constant = 0;  ///< K, 1/s a unit of command; τ, s
};
constexpr std::array<Plant, 2> plants = {{{10, 0.02}, {17.8, 0.05}}};

struct Gains {
  const char* name;
  servo::PidGains gains;
  const char* published;  ///< of the feed on the curve
};
constexpr std::array<Gains, 2> sets = {
    {{"(2, 2, 15)", {2, 2, 15}, "published as a picture, of a plant it does not name: hardly any"},
     {"(6, 50, 25)", {6, 50, 25}, "published as a picture, of a plant it does not name: a large one"}}};

enum class Until : std::uint8_t { last_word, rest };
constexpr double at_rest = 0.05;   // mm/s
constexpr int quiet_periods = 10;  // that feed stays below it, at rest
constexpr int most_periods = 500;  // behind the last word

/// √(Vx² + Vy²) at the tachogenerators, mm/s, a period apart. To rest the last word is repeated.
base::Result<std::vector<double>> measured_feed(const std::vector<Place>& words, const servo::PidGains& gains,
                                                const Plant& plant, Until until) {
  const auto axis = servo::SimulatedAxis::create({.drive = servo::velocity_drive(plant.gain, plant.time_constant)});
  if (!axis) return base::failure(axis.error());
  const auto pid = servo::Pid::create({.gains = gains}, period);
  if (!pid) return base::failure(pid.error());
  servo::AxisLoop x(*axis, *pid, period), y = x;
  std::vector<double> feeds;
  const auto follow = [&](const Place& word) {
    x.follow({word.x});
    y.follow({word.y});
    feeds.push_back(std::hypot(x.axis().screw().velocity, y.axis().screw().velocity));
  };
  for (const Place& word : words) follow(word);
  int quiet = until == Until::rest ? 0 : quiet_periods;
  for (int k = 0; quiet < quiet_periods && k < most_periods; ++k) {
    follow(words.back());
    quiet = feeds.back() < at_rest ? quiet + 1 : 0;
  }
  return feeds;
}

double greatest(const std::vector<double>& feeds) {
  return *std::max_element(feeds.begin(), feeds.end());
}
/// Over the middle half.
double least(const std::vector<double>& feeds) {
  const auto quarter = static_cast<std::ptrdiff_t>(feeds.size() / 4);
  return *std::min_element(feeds.begin() + quarter + 1, feeds.begin() + 3 * quarter);
}

std::string plant_text(const Plant& plant) {
  return "K " + decimal(plant.gain, 1) + ", τ " + decimal(plant.time_constant * 1000, 0) + " ms";
}

std::string group_of(const Gains& set, const Plant& plant) {
  return std::string("gains (P, I, D) = ") + set.name + ", " + plant_text(plant);
}

Rows speed_rows(const std::vector<Place>& curve, const std::vector<Place>& stops) {
  Rows rows;
  for (const Plant& plant : plants) {
    for (const Gains& set : sets) {
      const std::string group = group_of(set, plant);
      const auto on_curve = measured_feed(curve, set.gains, plant, Until::last_word);
      const auto on_lines = measured_feed(stops, set.gains, plant, Until::last_word);
      if (!on_curve || !on_lines) {
        append(rows, under(group, {not_run_row("measured feed", (on_curve ? on_lines : on_curve).error().message)}));
        continue;
      }
      append(rows, under(group, {because(measured_row("curve: overshoot of the feed", {"%", 1},
                                                      (greatest(*on_curve) / feed - 1) * 100),
                                         set.published),
                                 measured_row("lines: greatest measured feed", {"mm/s", 2}, greatest(*on_lines)),
                                 measured_row("lines: least, over the middle half", {"mm/s", 2}, least(*on_lines))}));
    }
  }
  return rows;
}

Rows time_rows(const std::vector<Place>& curve) {
  const std::vector<Line> all = lines_of_cubic();
  double cutting = 0, slowest = feed, fastest = 0;
  for (const Line& line : all) {
    cutting += line.time;
    slowest = std::min(slowest, line.peak);
    fastest = std::max(fastest, line.peak);
  }
  const double seconds = static_cast<double>(curve.size() - 1) * period, whole = cutting + decoding.value;
  return under(
      "times, 10 mm/s, T 10 ms",
      {exact_row("one block for the curve", {"s", 1}, Published(3.0, measured_in_paper), seconds),
       because(fitted_row("92 lines: cutting", {"s", 1}, Published(10.1, measured_in_paper), cutting),
               "with 106.3 mm/s², which the paper does not state: solved from this time"),
       not_reproducible_row("92 lines: reading and decoding", {"s", 1}, decoding,
                            "the computer is not here: taken as published"),
       because(measured_row("92 lines: reading and decoding one", {"ms", 2}, decoding.value / lines * 1000),
               "0.3 s in all"),
       because(fitted_row("92 lines: in all", {"s", 1}, Published(10.4, measured_in_paper), whole),
               "with that acceleration"),
       because(fitted_row("times as long", {"", 1}, Published(3.5, measured_in_paper), whole / seconds),
               "with that acceleration"),
       because(limit_row("greatest feed along any line", {"mm/s", 1}, feed, fastest), "10 mm/s is never reached"),
       measured_row("least of the greatest", {"mm/s", 1}, slowest)});
}

Row time_row(std::string what, const PartProgram& program, const machine::Machine& machine) {
  const base::Result<Judged> judged = judge(program, machine);
  if (!judged) return not_run_row(std::move(what), judged.error().message);
  return measured_row(std::move(what), {"s", 3}, judged->summary.time_s);
}

/// The same curve and lines by this planner, each axis within these limits.
Rows planner_rows(const LimitSet& limits) {
  const machine::Machine machine = machine_with(limits, {1'000'000});
  const BlendedProgram slow = cubic_as_lines(feed);
  Rows rows = {time_row("one block for the curve", program_of(plane_cubic(), feed), machine)};
  rows.push_back(time_row("92 lines, a stop at each", stopping(slow), machine));
  rows.push_back(time_row("92 lines within 10 µm", blended(slow), machine));
  const int digits = limits.acceleration == std::round(limits.acceleration) ? 0 : 1;
  return under("this planner, 10 mm/s, a " + decimal(limits.acceleration, digits) + " mm/s², j " +
                   decimal(limits.jerk, 0) + " mm/s³",
               std::move(rows));
}

Rows size_rows() {
  const BlendedProgram slow = cubic_as_lines(feed);
  const auto bytes = [](const PartProgram& program) { return static_cast<double>(program.text.size()); };
  return under("sizes of both programs", {measured_row("curve", {"bytes", 0}, bytes(program_of(plane_cubic(), feed))),
                                          measured_row("92 lines", {"bytes", 0}, bytes(stopping(slow)))});
}

}  // namespace

Rows real_time_rows(const Host&) {
  const std::vector<Place> curve = words_of_curve(), stops = words_of_lines(lines_of_cubic());
  Rows rows = time_rows(curve);
  append(rows, speed_rows(curve, stops));
  append(rows, planner_rows({200, acceleration, 1e6}));
  append(rows, planner_rows({200, 1000, 20000}));
  append(rows, size_rows());
  return rows;
}

report::ChartSheet real_time_picture() {
  report::ChartSheet sheet;
  sheet.title = "feed at the tachometers, mm/s";
  const std::vector<Place> curve = words_of_curve(), stops = words_of_lines(lines_of_cubic());
  for (const Plant& plant : plants) {
    for (const Gains& set : sets) {
      for (const bool is_curve : {true, false}) {
        auto feeds = measured_feed(is_curve ? curve : stops, set.gains, plant, Until::rest);
        if (!feeds) continue;
        sheet.charts.push_back(
            {std::string(is_curve ? "one block" : "92 lines") + ", gains " + set.name + ", " + plant_text(plant),
             {report::evenly_spaced(*feeds, period)},
             {feed}});
      }
    }
  }
  return sheet;
}

}  // namespace leadscrew::study
