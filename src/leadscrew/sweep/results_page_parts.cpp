#include <algorithm>
#include <cmath>
#include <functional>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/sweep/results_page.hpp>
#include <utility>

namespace leadscrew::sweep {

using markup::escaped;
using markup::put;
using markup::readable;

namespace {

constexpr std::array<std::string_view, parameter_names.size()> parameter_titles = {
    "Tolerance, mm",          "Override of the feed",       "Servo period, µs",
    "Velocity of every axis", "Acceleration of every axis", "Jerk of every axis"};
constexpr std::array<std::string_view, 5> ratio_titles = {"velocity", "acceleration", "jerk", "feed", "deviation"};
constexpr std::size_t most_causes = 10;
constexpr double chart_width = 560, chart_height = 270, left = 78, right = 16, above = 12, below = 34;

std::string coordinate(double value) {
  return markup::fixed(value, 1);
}

/// One machine's times by a parameter.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< value, s
};

/// From values to the width of a chart; by magnitude where they are spread over more than a factor of four.
class Across {
 public:
  Across(double least, double greatest)
      : is_logarithmic_(least > 0 && greatest > 4 * least), least_(scaled(least)), greatest_(scaled(greatest)) {}
  double operator()(double value) const {
    constexpr double inset = 24;
    const double width = chart_width - left - right - 2 * inset;
    return left + inset + width * (scaled(value) - least_) / (greatest_ - least_);
  }

 private:
  double scaled(double value) const { return is_logarithmic_ ? std::log(value) : value; }

  bool is_logarithmic_;
  double least_, greatest_;
};

void put_levels(std::string& page, double most) {
  const double step = markup::tick_step(most, 4);
  const auto height = [&](double seconds) {
    return chart_height - below - (chart_height - above - below) * seconds / most;
  };
  for (double seconds = 0; seconds <= most * 1.0001; seconds += step) {
    const std::string y = coordinate(height(seconds));
    put(page, "<line class=\"grid\" x1=\"", coordinate(left), "\" x2=\"", coordinate(chart_width - right), "\" y1=\"",
        y, "\" y2=\"", y, "\"/><text x=\"", coordinate(left - 8), "\" y=\"", coordinate(height(seconds) + 4),
        "\" text-anchor=\"end\">", readable(seconds), " s</text>\n");
  }
}

void put_series(std::string& page, const std::vector<Series>& all, double most) {
  const auto& values = all.front().points;
  const Across across(values.front().first, values.back().first);
  const auto height = [&](double seconds) {
    return chart_height - below - (chart_height - above - below) * seconds / most;
  };
  for (const auto& [value, seconds] : values)
    put(page, "<text x=\"", coordinate(across(value)), "\" y=\"", coordinate(chart_height - 12),
        "\" text-anchor=\"middle\">", readable(value), "</text>\n");
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string color = "c" + std::to_string(k % 8);
    put(page, "<g class=\"series\"><path class=\"", color, "\" d=\"");
    const char* command = "M";
    for (const auto& [value, seconds] : all[k].points) {
      put(page, command, coordinate(across(value)), " ", coordinate(height(seconds)));
      command = "L";
    }
    put(page, "\"/>\n");
    for (const auto& [value, seconds] : all[k].points)
      put(page, "<circle class=\"", color, "\" cx=\"", coordinate(across(value)), "\" cy=\"",
          coordinate(height(seconds)), "\" r=\"4\"><title>", escaped(all[k].name), ", ", readable(value), ": ",
          markup::readable_time(seconds), "</title></circle>\n");
    put(page, "</g>\n");
  }
}

void put_figure(std::string& page, std::string_view name, const std::string& value) {
  put(page, "<div><dt>", name, "</dt><dd>", value, "</dd></div>\n");
}

void put_share(std::string& page, double share) {
  put(page, "<td class=\"share\"><i style=\"width:", markup::fixed(100 * std::clamp(share, 0.0, 1.0), 2),
      "%\"></i></td></tr>\n");
}

std::string counted(std::int64_t programs) {
  return readable(static_cast<double>(programs), 12) + (programs == 1 ? " program" : " programs");
}

std::string number_cell(double value, const std::string& shown) {
  std::string cell;
  put(cell, "<td data-value=\"", markup::fixed(value, 9), "\">", shown, "</td>");
  return cell;
}

}  // namespace

std::string ResultsPage::written(const Summary& summary, const std::string& folder) const {
  std::string page;
  put(page,
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>",
      escaped(folder), " – sweep</title>\n<style>", page_css, "</style>\n</head>\n<body>\n<main>\n",
      "<p class=\"over\">leadscrew sweep</p>\n<h1>", escaped(folder), "</h1>\n");
  // Variants with changed limits count, though they are not listed.
  const std::int64_t broken = std::max(static_cast<std::int64_t>(broken_.size()) + more_broken_, summary.not_kept);
  put(page, "<p class=\"verdict",
      broken > 0         ? " bad\">"
      : summary.kept > 0 ? " good\">"
                         : "\">",
      broken > 0         ? readable(static_cast<double>(broken), 12) + " of the tasks did not keep what is promised."
      : summary.kept > 0 ? std::string("Every motion keeps every limit and tolerance.")
                         : std::string("No program has run."),
      summary.rows == summary.tasks ? "" : " Not all is done yet.", "</p>\n");
  if (const std::string others = told_of_others(summary); !others.empty())
    put(page, "<p class=\"note\">Of builds: ", escaped(others), ".</p>\n");
  put(page, "<dl class=\"figures\">\n");
  const std::pair<std::string_view, std::int64_t> counts[] = {
      {"tasks", summary.tasks},       {"with a result", summary.rows}, {"kept", summary.kept},
      {"not kept", summary.not_kept}, {"rejected", summary.rejected},  {"unreadable", summary.unreadable}};
  for (const auto& [name, count] : counts) put_figure(page, name, readable(static_cast<double>(count), 12));
  put_figure(page, "all motions together", markup::readable_time(summary.time_s));
  put_figure(page, "processor for all", markup::readable_time(summary.tasks_processor_s));
  put(page, "</dl>\n");
  put_times(page);
  put_losses(page);
  put_kinds(page);
  put_broken(page);
  put_refusals(page);
  put(page, "</main>\n<script>", page_js, "</script>\n</body>\n</html>\n");
  return page;
}

void ResultsPage::put_times(std::string& page) const {
  std::vector<Times> of_machines;
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) of_machines.push_back(times(machine));
  if (std::ranges::none_of(of_machines, [](const Times& each) { return each.programs > 0; })) return;
  put(page,
      "<h2>Time</h2>\n<p class=\"note\">Of the programs that run with every value. What a picture does not show is as "
      "in "
      "the first variant.</p>\n<div class=\"cards\">\n");
  if (machines_.size() > 1) put_machines(page);
  for (std::size_t parameter = 0; parameter < parameter_names.size(); ++parameter)
    put_chart(page, of_machines, parameter);
  put(page, "</div>\n");
}

void ResultsPage::put_machines(std::string& page) const {
  const Times all = times();
  if (all.programs == 0) return;
  double most = 0;
  for (std::size_t machine = 0; machine < machines_.size(); ++machine)
    most = std::max(most, all.by_variant[first_of(machine)]);
  put(page, "<figure class=\"card\"><h3>Machine, ", counted(all.programs),
      " that all of them run</h3>\n<table class=\"sorted\"><thead><tr><th class=\"text\">machine</th>"
      "<th>time of all</th><th></th></tr></thead><tbody>\n");
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) {
    const double seconds = all.by_variant[first_of(machine)];
    put(page, "<tr><td class=\"text\">", escaped(machines_[machine]), "</td>",
        number_cell(seconds, markup::readable_time(seconds)));
    put_share(page, seconds / most);
  }
  put(page, "</tbody></table></figure>\n");
}

void ResultsPage::put_chart(std::string& page, const std::vector<Times>& of_machines, std::size_t parameter) const {
  const auto is_same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  std::vector<Series> all;
  double most = 0;
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) {
    const ParameterValues& first = variants_[first_of(machine)].values;
    Series series{machines_[machine] + ", " + counted(of_machines[machine].programs), {}};
    for (std::size_t k = 0; k < variants_.size(); ++k) {
      ParameterValues values = variants_[k].values;
      const double value = std::exchange(values[parameter], first[parameter]);
      if (variants_[k].machine == machine && std::ranges::equal(values, first, is_same) && std::isfinite(value))
        series.points.emplace_back(value, of_machines[machine].by_variant[k]);
    }
    std::ranges::sort(series.points);
    if (series.points.size() < 2 || of_machines[machine].programs == 0) continue;
    for (const auto& [value, seconds] : series.points) most = std::max(most, seconds);
    all.push_back(std::move(series));
  }
  if (all.empty()) return;
  put(page, "<figure class=\"card\"><h3>", parameter_titles[parameter], "</h3>\n<svg viewBox=\"0 0 ",
      coordinate(chart_width), " ", coordinate(chart_height), "\" role=\"img\" aria-label=\"Time by ",
      parameter_titles[parameter], "\">\n");
  put_levels(page, most * 1.05);
  put_series(page, all, most * 1.05);
  put(page, "</svg>\n<ul class=\"keys\">");
  for (std::size_t k = 0; k < all.size(); ++k)
    put(page, "<li><svg viewBox=\"0 0 22 8\"><path class=\"c", std::to_string(k % 8), "\" d=\"M0 4H22\"/></svg>",
        escaped(all[k].name), "</li>");
  put(page, "</ul></figure>\n");
}

void ResultsPage::put_losses(std::string& page) const {
  if (std::ranges::none_of(lost_, [](const Lost& lost) { return lost.time_s > 0; })) return;
  put(page,
      "<h2>Where time is lost</h2>\n<p class=\"note\">Against the feed words, over all programs, each machine in its "
      "first variant; the dearest causes.</p>\n<div class=\"cards\">\n");
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) {
    std::vector<std::pair<double, std::string>> causes;
    double whole = 0;
    for (const auto& [cause, seconds] : lost_[machine].by_cause) {
      causes.emplace_back(seconds, cause);
      whole += seconds;
    }
    if (causes.empty()) continue;
    std::ranges::sort(causes, std::greater<>());
    put(page, "<figure class=\"card\"><h3>", escaped(machines_[machine]), ": ", markup::readable_time(whole), " of ",
        markup::readable_time(lost_[machine].time_s), "</h3>\n<table><tbody>\n");
    for (std::size_t k = 0; k < std::min(most_causes, causes.size()); ++k) {
      const auto& [seconds, cause] = causes[k];
      put(page, "<tr><td class=\"text\">", escaped(cause), "</td><td>", markup::readable_time(seconds), "</td><td>",
          markup::percent(seconds / lost_[machine].time_s), "</td>");
      put_share(page, seconds / causes.front().first);
    }
    put(page, "</tbody></table></figure>\n");
  }
  put(page, "</div>\n");
}

void ResultsPage::put_kinds(std::string& page) const {
  if (kinds_.empty()) return;
  put(page,
      "<h2>Random programs</h2>\n<p class=\"note\">The worst of each kind, of its limit or tolerance.</p>\n"
      "<div class=\"scroll\"><table class=\"sorted\"><thead><tr><th class=\"text\">kind</th><th>programs</th><th>not "
      "kept</th>"
      "<th>motion</th>");
  for (const std::string_view title : ratio_titles) put(page, "<th>", title, "</th>");
  put(page, "</tr></thead><tbody>\n");
  for (const auto& [name, kind] : kinds_) {
    const auto cases = static_cast<double>(kind.cases), broken = static_cast<double>(kind.broken);
    put(page, "<tr><td class=\"text\">", escaped(name), "</td>", number_cell(cases, readable(cases, 12)),
        number_cell(broken, readable(broken, 12)), number_cell(kind.time_s, markup::readable_time(kind.time_s)));
    for (const double ratio : kind.worst) put(page, number_cell(ratio, readable(ratio, 6)));
    put(page, "</tr>\n");
  }
  put(page, "</tbody></table></div>\n");
}

void ResultsPage::put_broken(std::string& page) const {
  if (broken_.empty()) return;
  put(page,
      "<h2>What does not keep its promise</h2>\n<div class=\"scroll\"><table class=\"sorted\"><thead><tr>"
      "<th class=\"text\">where</th><th class=\"text\">what</th></tr></thead><tbody>\n");
  for (const Broken& each : broken_)
    put(page, "<tr><td class=\"text\">", escaped(each.place), "</td><td class=\"text long bad\">", escaped(each.what),
        "</td></tr>\n");
  put(page, "</tbody></table></div>\n");
  if (more_broken_ > 0) put(page, "<p class=\"note\">And ", std::to_string(more_broken_), " more.</p>\n");
}

void ResultsPage::put_refusals(std::string& page) const {
  if (refusals_.empty()) return;
  put(page,
      "<h2>Refused</h2>\n<p class=\"note\">Each program once a machine, by its first error.</p>\n<div class=\"scroll\">"
      "<table class=\"sorted\"><thead><tr><th class=\"text\">program</th><th class=\"text\">machine</th><th>line</th>"
      "<th class=\"text\">code</th><th class=\"text\">what</th><th>variants</th></tr></thead><tbody>\n");
  for (const Refusal& each : refusals_)
    put(page, "<tr><td class=\"text\">", escaped(each.program), "</td><td class=\"text\">", escaped(each.machine),
        "</td><td>", each.line > 0 ? std::to_string(each.line) : std::string(), "</td><td class=\"text\"><code>",
        escaped(each.code), "</code></td><td class=\"text long\">", escaped(each.message), "</td><td>",
        std::to_string(each.variants), "</td></tr>\n");
  put(page, "</tbody></table></div>\n");
  if (more_refusals_ > 0) put(page, "<p class=\"note\">And ", std::to_string(more_refusals_), " more.</p>\n");
}

}  // namespace leadscrew::sweep
