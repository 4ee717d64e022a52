// The parts of the page that are tables and text: ratios, blocks, diagnostics, origin.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

#include <algorithm>
#include <cmath>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::fixed;
using markup::percent;
using markup::put;
using markup::readable;
using markup::readable_distance;
using markup::readable_time;

constexpr std::size_t most_diagnostics = 200;

void put_ratio(std::string& page, double ratio) {
  put(page, "<td", ratio > keeps_up_to ? " class=\"over-limit\"" : "", ">", percent(ratio),
      "<span class=\"gauge\"><i style=\"width:", fixed(std::clamp(ratio, 0.0, 1.0) * 100, 1), "%\"></i></span></td>");
}

void put_line_and_source(std::string& page, const Report& report, base::Line line) {
  const std::string source = escaped(source_of(report, line), 120);
  put(page, "<td>", place_text(report, line), "</td><td class=\"source\" title=\"", source, "\">", source, "</td>");
}

std::string_view order_name(int order) {
  return order == 1 ? "velocity" : order == 2 ? "acceleration" : "jerk";
}

void put_slowest(std::string& page, const PageContent& content) {
  put(page,
      "<div><h3>The slowest blocks</h3>\n<div class=\"scroll\"><table><thead><tr><th>Line</th><th "
      "class=\"text\">Block</th>"
      "<th>From</th><th>Takes</th><th>Length</th></tr></thead><tbody>\n");
  for (const BlockFigures& block : content.recording.slowest_blocks()) {
    put(page, "<tr>");
    put_line_and_source(page, content.report, block.line);
    put(page, "<td>", readable_time(block.t_begin), "</td><td>", readable_time(block.duration), "</td><td>",
        readable(std::round(block.length * 1e4) / 1e4), " mm</td></tr>\n");
  }
  put(page, "</tbody></table></div></div>\n");
}

void put_nearest(std::string& page, const PageContent& content) {
  put(page,
      "<div><h3>The blocks nearest to a limit</h3>\n<div class=\"scroll\"><table><thead><tr><th>Line</th>"
      "<th class=\"text\">Block</th><th>From</th><th class=\"text\">Limit</th><th>Reaches</th></tr></thead><tbody>\n");
  for (const BlockFigures& block : content.recording.nearest_to_limit()) {
    put(page, "<tr>");
    put_line_and_source(page, content.report, block.line);
    put(page, "<td>", readable_time(block.t_begin), "</td><td class=\"text\">",
        std::string(1, base::letter(block.worst_axis)), " ", order_name(block.worst_order), "</td><td",
        block.worst_ratio > keeps_up_to ? " class=\"over-limit\"" : "", ">", percent(block.worst_ratio),
        "</td></tr>\n");
  }
  put(page, "</tbody></table></div></div>\n");
}

void put_diagnostic(std::string& page, const base::Diagnostic& diagnostic) {
  const base::Place& place = diagnostic.place;
  put(page, "<li><pre>", escaped(place.file));
  if (place.line > 0) put(page, ":", std::to_string(place.line));
  if (place.column > 0) put(page, ":", std::to_string(place.column));
  put(page, place.file.empty() && place.line == 0 ? "" : ": ", "<b class=\"", base::name(diagnostic.severity), "\">",
      base::name(diagnostic.severity), ":</b> ", escaped(diagnostic.message, 1000), " [", escaped(diagnostic.code),
      "]");
  if (!diagnostic.source.empty()) {
    put(page, "\n  ", escaped(diagnostic.source));
    const auto column = static_cast<std::size_t>(std::max<std::int64_t>(place.column, 0));
    if (column > 0 && column <= diagnostic.source.size() + 1) {
      // The caret stands under a character; bytes inside one, and tabs, take the room that the line above takes.
      std::string before;
      for (const char c : std::string_view(diagnostic.source).substr(0, column - 1)) {
        if (c == '\t')
          before += c;
        else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80)
          before += ' ';
      }
      put(page, "\n  ", before, "^");
    }
  }
  if (!diagnostic.hint.empty()) put(page, "\n  <span class=\"hint\">", escaped(diagnostic.hint, 1000), "</span>");
  put(page, "</pre></li>\n");
}

}  // namespace

std::string_view source_of(const Report& report, base::Line line) {
  const auto found =
      std::ranges::find(report.source, base::place_of(line), [](const auto& entry) { return entry.first; });
  return found == report.source.end() ? std::string_view() : std::string_view(found->second);
}

std::string place_text(const Report& report, base::Line line) {
  std::string text;
  if (const auto file = static_cast<std::size_t>(base::file(line)); file != 0 && file < report.texts.size()) {
    const std::string& name = report.texts[file];
    text = escaped(name.substr(name.find_last_of('/') + 1), 60) + ":";
  }
  text += std::to_string(base::number(line));
  if (base::visit(line) != 0) text += ", visit " + std::to_string(base::visit(line));
  return text;
}

void put_limit_section(std::string& page, const PageContent& content) {
  if (content.report.limits.empty()) return;
  const bool has_plan = content.report.plan.has_value();
  put(page,
      "<section><h2>Limits</h2>\n<p class=\"note\">Greatest value over the machine’s limit. Measured: differences of "
      "the words, less what rounding can add to them. ",
      has_plan ? "Planned: evaluated from the plan itself." : "", "</p>\n<div class=\"scroll\"><table><thead>");
  if (has_plan) {
    put(page,
        "<tr><th rowspan=\"2\">Axis</th><th colspan=\"2\">Velocity</th><th colspan=\"2\">Acceleration</th>"
        "<th colspan=\"2\">Jerk</th></tr><tr>");
    for (int i = 0; i < 3; ++i) put(page, "<th>measured</th><th>planned</th>");
  } else {
    put(page, "<tr><th>Axis</th><th>Velocity</th><th>Acceleration</th><th>Jerk</th>");
  }
  put(page, "</tr></thead><tbody>\n");
  for (const AxisRatios& ratios : content.report.limits) {
    put(page, "<tr><td>", std::string(1, base::letter(ratios.axis)), "</td>");
    for (const auto& [measured, planned] : {std::pair(ratios.velocity, ratios.planned_velocity),
                                            {ratios.acceleration, ratios.planned_acceleration},
                                            {ratios.jerk, ratios.planned_jerk}}) {
      put_ratio(page, measured);
      if (has_plan) put_ratio(page, planned);
    }
    put(page, "</tr>\n");
  }
  put(page, "</tbody></table></div></section>\n");
}

void put_violation_section(std::string& page, const PageContent& content) {
  const Report& report = content.report;
  if (report.violation_count == 0) return;
  put(page,
      "<section id=\"violations\"><h2>What the referee objects to</h2>\n<p class=\"note\">Block by block, with the "
      "worst "
      "of its words; mm, degrees and seconds.</p>\n<div class=\"scroll\"><table><thead><tr><th>Line</th><th "
      "class=\"text\">Block</th><th class=\"text\">What</th><th>Worst</th><th>Limit</th><th>Words</th><th>From</th>"
      "<th>To</th></tr></thead><tbody>\n");
  std::int64_t shown = 0;
  for (const Violation& violation : report.violations) {
    put(page, "<tr>");
    put_line_and_source(page, report, violation.line);
    put(page, "<td class=\"text\">", escaped(violation.what), "</td><td class=\"over-limit\">",
        readable(violation.value), "</td><td>", readable(violation.limit), "</td><td>",
        readable(static_cast<double>(violation.count), 15), "</td><td>", readable_time(violation.first), "</td><td>",
        readable_time(violation.last), "</td></tr>\n");
    shown += violation.count;
  }
  put(page, "</tbody></table></div>\n");
  const std::int64_t left = report.violation_count - shown;
  if (left > 0) put(page, "<p class=\"note\">And in ", readable(static_cast<double>(left), 15), " words more.</p>\n");
  put(page, "</section>\n");
}

void put_block_section(std::string& page, const PageContent& content) {
  if (content.recording.words() < 2) return;
  put(page, "<section><h2>Blocks</h2>\n<div class=\"pair\">\n");
  put_slowest(page, content);
  put_nearest(page, content);
  put(page, "</div></section>\n");
}

void put_diagnostics(std::string& page, const PageContent& content) {
  const std::vector<base::Diagnostic>& diagnostics = content.report.diagnostics;
  put(page, "<section id=\"diagnostics\"><h2>Diagnostics</h2>\n");
  if (diagnostics.empty()) {
    put(page, "<p class=\"note\">None.</p></section>\n");
    return;
  }
  put(page, "<ul class=\"diagnostics\">\n");
  const std::size_t shown = std::min(diagnostics.size(), most_diagnostics);
  for (std::size_t i = 0; i < shown; ++i) put_diagnostic(page, diagnostics[i]);
  put(page, "</ul>\n");
  if (shown < diagnostics.size()) {
    put(page, "<p class=\"note\">And ", std::to_string(diagnostics.size() - shown), " more.</p>\n");
  }
  put(page, "</section>\n");
}

void put_origin(std::string& page, const PageContent& content) {
  const machine::Machine& machine = content.machine;
  put(page, "<section><h2>How to make this report again</h2>\n<pre>", escaped(content.report.command, 4000),
      "</pre>\n<dl class=\"facts\"><dt>Leadscrew</dt><dd>", escaped(content.report.version),
      "</dd><dt>Machine</dt><dd>", escaped(machine.name), ", ", escaped(machine.kinematics),
      "</dd><dt>Servo period</dt><dd>", readable(content.period.seconds() * 1e3), " ms</dd><dt>Tolerance</dt><dd>",
      readable_distance(content.report.tolerance_mm), "</dd><dt>Chord error</dt><dd>",
      readable_distance(machine.chord_error), "</dd></dl>\n");
  put(page,
      "<div class=\"scroll\"><table><thead><tr><th>Axis</th><th>Travel</th><th>Velocity</th><th>Acceleration</th>"
      "<th>Jerk</th><th>BLU</th></tr></thead><tbody>\n");
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const std::string_view u = unit(axis);
    put(page, "<tr><td>", std::string(1, base::letter(axis)), "</td><td>", readable(limits.travel_min), " … ",
        readable(limits.travel_max), " ", u, "</td><td>", readable(limits.velocity), " ", u, "/s</td><td>",
        readable(limits.acceleration), " ", u, "/s²</td><td>", readable(limits.jerk), " ", u, "/s³</td><td>",
        readable(limits.blu), " ", u, "</td></tr>\n");
  }
  put(page, "</tbody></table></div></section>\n");
}

}  // namespace leadscrew::report
