// Title, verdict in a machinist's words, key figures.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

#include <algorithm>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::percent;
using markup::put;
using markup::readable;
using markup::readable_distance;
using markup::readable_time;

/// What rounding of positions can make of a deviation of nothing, mm.
constexpr double deviation_rounding = 1e-6;

void add_broken_limits(std::vector<std::string>& broken, const AxisRatios& ratios, const machine::AxisLimits& limits) {
  const struct {
    std::string_view name, per;
    double found, planned, limit;
  } kinds[] = {{"velocity", "/s", ratios.velocity, ratios.planned_velocity, limits.velocity},
               {"acceleration", "/s²", ratios.acceleration, ratios.planned_acceleration, limits.acceleration},
               {"jerk", "/s³", ratios.jerk, ratios.planned_jerk, limits.jerk}};
  for (const auto& kind : kinds) {
    const double worst = std::max(kind.found, kind.planned);
    if (!(worst > keeps_up_to)) continue;
    std::string sentence;
    put(sentence, "Exceeds the ", kind.name, " limit of axis ", std::string(1, base::letter(ratios.axis)), " by ",
        percent(worst - 1), ": ", readable(worst * kind.limit), " of ", readable(kind.limit), " ", unit(ratios.axis),
        kind.per, kind.found > keeps_up_to ? "" : ", in the plan alone");
    broken.push_back(std::move(sentence));
  }
}

void add_broken_travel(std::vector<std::string>& broken, const PageContent& content) {
  for (const base::Axis axis : base::all_axes) {
    const std::span<const Extent> extents = content.recording.axis(axis, 0);
    if (extents.empty()) continue;
    const machine::AxisLimits& limits = content.machine.limits(axis);
    const double least = std::ranges::min(extents, {}, &Extent::least).least;
    const double greatest = std::ranges::max(extents, {}, &Extent::greatest).greatest;
    if (limits.travel_min - deviation_rounding <= least && greatest <= limits.travel_max + deviation_rounding) continue;
    std::string sentence;
    put(sentence, "Leaves the travel of axis ", std::string(1, base::letter(axis)), ": ", readable(least, 6), " … ",
        readable(greatest, 6), " of ", readable(limits.travel_min), " … ", readable(limits.travel_max), " ",
        unit(axis));
    broken.push_back(std::move(sentence));
  }
}

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return readable(static_cast<double>(count), 15) + " " + std::string(count == 1 ? one : many);
}

void put_verdict(std::string& page, const PageContent& content) {
  const Report& report = content.report;
  const std::vector<std::string> broken = broken_promises(content);
  const auto errors = std::ranges::count(report.diagnostics, base::Severity::error, &base::Diagnostic::severity);
  if (errors > 0) {
    put(page, "<div class=\"verdict bad\"><strong>▲ Has ",
        errors == 1 ? std::string("an error") : std::to_string(errors) + " errors",
        "</strong><a href=\"#diagnostics\">See the diagnostics.</a>");
  } else if (!broken.empty() || report.violation_count > 0) {
    put(page, "<div class=\"verdict bad\"><strong>▲ Exceeds what was asked</strong>");
    if (report.violation_count > 0)
      put(page, "<a href=\"#violations\">The referee objects in ", counted(report.violation_count, "word", "words"),
          ".</a>");
  } else if (content.recording.words() < 2) {
    put(page, "<div class=\"verdict idle\"><strong>Nothing moves</strong>The program asks for no motion.");
  } else {
    put(page, "<div class=\"verdict good\"><strong>✓ Keeps every limit</strong>",
        "Velocity, acceleration and jerk of every axis stay within the machine’s limits, and the path within its "
        "tolerance.");
  }
  if (!broken.empty()) {
    put(page, "<ul>");
    for (const std::string& sentence : broken) put(page, "<li>", sentence, "</li>");
    put(page, "</ul>");
  }
  put(page, "</div>\n");
}

/// Of a program that was allowed to.
void put_gouging_verdict(std::string& page, const Report& report) {
  if (!report.gouging || report.gouging->blocks.empty()) return;
  const Gouge& worst = report.gouging->blocks.front();
  put(page, "<div class=\"verdict bad\"><strong>▲ The tool gouges, as it was allowed to</strong>");
  if (worst.depth_mm)
    put(page, readable_distance(*worst.depth_mm), " deep in surface ", std::to_string(worst.surface), " on ",
        escaped(worst.motion), " of line ", place_text(report, worst.line), ". ");
  put(page, "<a href=\"#gouging\">See where.</a></div>\n");
}

void put_figure(std::string& page, std::string_view name, const std::string& value, const std::string& more) {
  put(page, "<div><dt>", name, "</dt><dd>", value, more.empty() ? "" : "<small>" + more + "</small>", "</dd></div>\n");
}

/// Programmed feed, and what rapids reach.
std::string more_of_feed(const PageContent& content) {
  const double programmed = content.report.feed_programmed_max, rapid = content.recording.greatest_rapid();
  std::string text;
  if (programmed > 0) text = "programmed " + readable(programmed * 60, 5);
  if (rapid > 0) text += (text.empty() ? "rapids " : "; rapids ") + readable(rapid * 60, 5);
  return text;
}

}  // namespace

std::string_view unit(base::Axis axis) {
  return base::is_rotary(axis) ? "°" : "mm";
}

std::vector<std::string> broken_promises(const PageContent& content) {
  const Report& report = content.report;
  std::vector<std::string> broken;
  for (const AxisRatios& ratios : report.limits) {
    if (content.machine.has(ratios.axis)) add_broken_limits(broken, ratios, content.machine.limits(ratios.axis));
  }
  add_broken_travel(broken, content);
  if (report.deviation_mm > report.tolerance_mm * keeps_up_to + deviation_rounding) {
    broken.push_back("Leaves the programmed path by " + readable_distance(report.deviation_mm) + "; " +
                     readable_distance(report.tolerance_mm) + " is allowed");
  }
  if (report.feed_max_ratio > keeps_up_to) {
    broken.push_back("Exceeds the programmed feed by " + percent(report.feed_max_ratio - 1));
  }
  return broken;
}

void put_heading(std::string& page, const PageContent& content) {
  const Report& report = content.report;
  put(page, "<header><p class=\"over\">", report.plan ? "Motion report" : "Judgement of a trace", " · machine ",
      escaped(content.machine.name), "</p>\n<h1>", escaped(report.title), "</h1>\n");
  if (!report.program.empty()) put(page, "<p>Judged by ", escaped(report.program), ".</p>\n");
  put_verdict(page, content);
  put_gouging_verdict(page, content.report);
  put(page, "<dl class=\"figures\">\n");
  put_figure(page, "Time", readable_time(report.time_s),
             report.plan ? "dwell " + readable_time(report.dwell_s) + "; without jerk limit " +
                               readable_time(report.plan->bound_s)
                         : "");
  put_figure(page, "Path length", readable(report.length_mm, 7) + " mm",
             report.plan ? counted(report.moves, "move", "moves") : "");
  put_figure(page, "Deviation", readable_distance(report.deviation_mm),
             "tolerance " + readable_distance(report.tolerance_mm));
  if (report.tip) {
    put_figure(page, "Of the tip", readable_distance(report.tip->tip_mm), "from its path");
    put_figure(page, "Of the tool’s direction", readable(report.tip->orientation_deg) + "°",
               "tolerance " + readable(report.tip->orientation_tolerance_deg) + "°");
  }
  put_figure(page, "Greatest feed", readable(content.recording.greatest_feed() * 60) + " mm/min",
             more_of_feed(content));
  if (report.plan) put_figure(page, "Program", counted(report.plan->blocks, "block", "blocks"), "");
  put_figure(page, report.plan ? "Reference words" : "Rows of the trace",
             readable(static_cast<double>(report.words), 15),
             "every " + readable(content.period.seconds() * 1e3) + " ms");
  put(page, "</dl></header>\n");
}

}  // namespace leadscrew::report
