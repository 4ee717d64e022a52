// Feed and axes over time. A channel is drawn as the band between its least and greatest values, bin by bin, in a box
// that stretches with the page; words stand beside it as HTML so that they do not stretch.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace leadscrew::report {
namespace {

using markup::fixed;
using markup::percent;
using markup::put;
using markup::readable;
using markup::tick_decimals;
using markup::tick_step;

constexpr double box_width = 1000, box_height = 100;
constexpr std::size_t drawn_bins = 700;

struct Channel {
  std::string name;
  std::string unit;
  std::span<const Extent> extents;
  double per_unit = 1;                 ///< shown value for each recorded one
  std::optional<double> upper, lower;  ///< limits, in recorded units
  std::string_view limit_name;
  bool always_show_limits = true;
  /// Of the feed: greatest of feed moves and of rapids. The limit binds the former alone, and where there are any, the
  /// latter may leave the picture.
  struct Parts {
    double feed_moves = 0, rapids = 0;
  };
  std::optional<Parts> parts{};
};

struct Range {
  double least = 0;
  double greatest = 0;
  double width() const { return greatest - least; }
};

Range range_of(std::span<const Extent> extents) {
  Range range{0, 0};
  bool first = true;
  for (const Extent& extent : extents) {
    if (!std::isfinite(extent.least) || !std::isfinite(extent.greatest)) continue;
    range = first ? Range{extent.least, extent.greatest}
                  : Range{std::min(range.least, extent.least), std::max(range.greatest, extent.greatest)};
    first = false;
  }
  return range;
}

/// Data, and limits where they are to be seen, with some air.
Range shown_range(const Channel& channel, Range data) {
  Range shown = data;
  if (channel.parts && channel.parts->feed_moves > 0) shown.greatest = channel.parts->feed_moves;
  if (channel.always_show_limits) {
    if (channel.upper) shown.greatest = std::max(shown.greatest, *channel.upper);
    if (channel.lower) shown.least = std::min(shown.least, *channel.lower);
  }
  const double least_width = std::max(0.01 / channel.per_unit, 1e-9 * std::fabs(shown.greatest));
  if (shown.width() < least_width) {
    const double middle = (shown.least + shown.greatest) / 2;
    shown = {middle - least_width / 2, middle + least_width / 2};
  }
  const double air = shown.width() * 0.08;
  return {shown.least - air, shown.greatest + air};
}

/// Time of a bin's middle among `count` bins that end at `end`.
struct TimeScale {
  double bin_seconds;
  double period;
  double end;

  double x(double bin) const {
    const double t = (bin + 0.5) * bin_seconds - period / 2;
    return end > 0 ? std::clamp(t / end, 0.0, 1.0) * box_width : 0;
  }
};

void put_band(std::string& page, std::span<const Extent> extents, const TimeScale& time, Range shown) {
  const std::size_t group = (extents.size() + drawn_bins - 1) / drawn_bins;
  const auto y = [&](double value) {
    return fixed((shown.greatest - (std::isfinite(value) ? value : 0)) / shown.width() * box_height, 2);
  };
  std::string upper, lower;
  std::vector<std::string> back;
  for (std::size_t begin = 0; group > 0 && begin < extents.size(); begin += group) {
    const std::size_t count = std::min(group, extents.size() - begin);
    const Range range = range_of(extents.subspan(begin, count));
    const std::string x = fixed(time.x(static_cast<double>(begin) + static_cast<double>(count - 1) / 2), 1);
    put(upper, upper.empty() ? "M" : "L", x, " ", y(range.greatest));
    back.push_back("L" + x + " " + y(range.least));
  }
  for (std::size_t i = back.size(); i-- > 0;) lower += back[i];
  if (!upper.empty()) put(page, "<path class=\"band\" d=\"", upper, lower, "Z\"/>");
}

void put_limit(std::string& lines, std::string& labels, const Channel& channel, double limit, Range shown, bool below) {
  const double place = (shown.greatest - limit) / shown.width();
  if (place < 0 || place > 1) return;
  put(lines, "<path class=\"limit\" d=\"M0 ", fixed(place * box_height, 2), "H1000\"/>");
  put(labels, "<span class=\"lim ", below ? "up" : "low", "\" style=\"top:", fixed(place * 100, 1), "%\">",
      channel.limit_name, " ", readable(limit * channel.per_unit), "</span>");
}

void put_value_ticks(std::string& lines, std::string& labels, const Channel& channel, Range shown) {
  const double step = tick_step(shown.width() * channel.per_unit, 4);
  const double first = std::ceil(shown.least * channel.per_unit / step) * step;
  for (int i = 0; i < 12; ++i) {
    const double value = first + i * step;
    const double place = (shown.greatest - value / channel.per_unit) / shown.width();
    if (place < 0) break;
    put(lines, "M0 ", fixed(place * box_height, 2), "H1000");
    if (place < 0.03 || place > 0.97) continue;
    const double shown_value = std::fabs(value) < step / 2 ? 0 : value;
    put(labels, "<span class=\"ty\" style=\"top:", fixed(place * 100, 1), "%\">", readable(shown_value, 6), "</span>");
  }
}

/// How near the channel came to its limit, in words.
std::string peak(const Channel& channel, Range data) {
  if (channel.extents.empty()) return {};
  if (!channel.always_show_limits) {
    // To a thousandth of the range: a slide that swings 10 µm beyond 0 in 60 mm has been at −0.01.
    const double finest = std::pow(10.0, -tick_decimals(tick_step(data.width() * channel.per_unit, 1000)));
    const auto shown = [&](double value) {
      return readable(std::round(value * channel.per_unit / finest) * finest, 5);
    };
    std::string text = shown(data.least) + " … " + shown(data.greatest);
    if (channel.upper) text += " of " + std::string(channel.limit_name) + ' ';
    if (channel.upper && channel.lower) text += shown(*channel.lower) + " … ";
    if (channel.upper) text += shown(*channel.upper);
    return text;
  }
  const auto shown = [&](double value) { return readable(value * channel.per_unit, 4); };
  const double greatest =
      channel.parts ? channel.parts->feed_moves : std::max(std::fabs(data.least), std::fabs(data.greatest));
  const bool rapids_only = channel.parts && !(greatest > 0);
  std::string text = rapids_only ? "" : "peak " + shown(greatest);
  if (channel.upper && *channel.upper > 0 && !rapids_only)
    text += " of " + shown(*channel.upper) + " · " + percent(greatest / *channel.upper);
  if (channel.parts && channel.parts->rapids > 0)
    text += (rapids_only ? "rapids up to " : "; rapids up to ") + shown(channel.parts->rapids);
  return text;
}

/// The step of minutes and hours next to `rough` seconds.
double clock_step(double rough) {
  constexpr double steps[] = {30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 21600, 43200};
  for (const double step : steps) {
    if (rough < 1.4 * step) return step;
  }
  return std::ceil(rough / 86400) * 86400;
}

class TimeCharts {
 public:
  TimeCharts(std::string& page, const PageContent& content)
      : page_(page), time_{content.recording.bin_seconds(), content.period.seconds(), content.recording.seconds()} {}

  void put_chart(const Channel& channel, std::string_view kind) {
    const Range data = range_of(channel.extents);
    const Range shown = shown_range(channel, data);
    std::string grid, lines, labels;
    put_value_ticks(grid, labels, channel, shown);
    constexpr double room = 0.3;  // of the box, that two labels between the limits need
    const bool inside = !channel.upper || !channel.lower || *channel.upper - *channel.lower > room * shown.width();
    if (channel.upper) put_limit(lines, labels, channel, *channel.upper, shown, inside);
    if (channel.lower) put_limit(lines, labels, channel, *channel.lower, shown, !inside);
    put(page_, "<figure class=\"chart ", kind, "\" data-low=\"", fixed(shown.least, 9), "\" data-high=\"",
        fixed(shown.greatest, 9), "\"><figcaption><b>", channel.name, "</b> <span>", channel.unit,
        "</span><output></output><span class=\"peak\">", peak(channel, data),
        "</span></figcaption>\n<div class=\"plot\"><svg viewBox=\"0 0 1000 100\" preserveAspectRatio=\"none\" "
        "role=\"img\" "
        "aria-label=\"",
        channel.name, " over time\"><path class=\"grid\" d=\"", grid, "\"/>");
    put_band(page_, channel.extents, time_, shown);
    put(page_, lines, "</svg>", labels, "</div></figure>\n");
    remember(channel, data);
  }

  void put_time_ticks() {
    put(page_, "<div class=\"times\">");
    const double step = time_.end < 120 ? tick_step(time_.end, 5) : clock_step(time_.end / 5);
    for (int i = 0; i < 20 && time_.end > 0; ++i) {
      const double t = i * step;
      if (t > time_.end * (1 + 1e-9)) break;
      const double place = t / time_.end;
      const char* edge = place > 0.97 ? " class=\"e\"" : i == 0 ? " class=\"b\"" : "";
      put(page_, "<span", edge, " style=\"left:", fixed(place * 100, 2), "%\">", label(t, step), "</span>");
    }
    put(page_, "</div>\n");
  }

  /// The bins for the script, each extreme as a 16-bit part of its channel's range.
  void put_data() {
    put(page_, "<script type=\"application/json\" id=\"channels\">{\"bin\":", fixed(time_.bin_seconds, 9),
        ",\"period\":", fixed(time_.period, 9), ",\"end\":", fixed(time_.end, 9), ",\"channels\":[", data_,
        "]}</script>\n");
  }

 private:
  std::string label(double t, double step) const {
    if (time_.end < 120) return fixed(t, tick_decimals(step)) + " s";
    const auto seconds = static_cast<long long>(std::llround(t));
    const auto two = [](long long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    if (time_.end < 7200) return std::to_string(seconds / 60) + ":" + two(seconds % 60);
    return std::to_string(seconds / 3600) + ":" + two(seconds / 60 % 60) + ":" + two(seconds % 60);
  }

  void remember(const Channel& channel, Range data) {
    const double per_step = data.width() > 0 ? 65535 / data.width() : 0;
    const auto steps = [&](double value) {
      const double part = std::isfinite(value) ? (value - data.least) * per_step : 0;
      return static_cast<unsigned>(std::clamp(part + 0.5, 0.0, 65535.0));
    };
    std::string bytes;
    for (const Extent& extent : channel.extents) {
      for (const unsigned value : {steps(extent.least), steps(extent.greatest)}) {
        bytes += static_cast<char>(value & 255);
        bytes += static_cast<char>(value >> 8);
      }
    }
    put(data_, data_.empty() ? "" : ",", "{\"low\":", fixed(data.least, 12), ",\"high\":", fixed(data.greatest, 12),
        ",\"per\":", fixed(channel.per_unit, 3), ",\"bins\":\"");
    put(data_, markup::base64(bytes), "\"}");
  }

  std::string& page_;
  TimeScale time_;
  std::string data_;
};

std::string times(std::string_view unit, std::string_view per) {
  return std::string(unit) + std::string(per);
}

void put_axis(TimeCharts& charts, std::string& page, const PageContent& content, base::Axis axis) {
  const machine::AxisLimits& limits = content.machine.limits(axis);
  const std::string_view u = unit(axis);
  const auto bins = [&](int order) { return content.recording.axis(axis, order); };
  put(page, "<div class=\"axis\"><h3>Axis ", std::string(1, base::letter(axis)), "</h3>\n");
  charts.put_chart({"position", std::string(u), bins(0), 1, limits.travel_max, limits.travel_min, "travel", false},
                   "small");
  if (content.followed != nullptr) {
    const auto of_slide = [&](double FollowedAxis::* value) { return content.followed->axis(axis, value); };
    const auto put_plain = [&](std::string name, std::string shown_unit, double FollowedAxis::* value,
                               double per_unit) {
      charts.put_chart(
          {std::move(name), std::move(shown_unit), of_slide(value), per_unit, std::nullopt, std::nullopt, "", false},
          "small");
    };
    put_plain("following error", base::is_rotary(axis) ? "°/1000" : "µm", &FollowedAxis::error, 1000);
    put_plain("tachometer", times(u, "/s"), &FollowedAxis::velocity, 1);
    put_plain("control signal", "", &FollowedAxis::control, 1);
    put_plain("motor current", "as " + times(u, "/s²"), &FollowedAxis::current, 1);
  }
  const struct {
    int order;
    std::string_view name, per;
    double limit;
  } rates[] = {{1, "velocity", "/s", limits.velocity},
               {2, "acceleration", "/s²", limits.acceleration},
               {3, "jerk", "/s³", limits.jerk}};
  for (const auto& rate : rates) {
    charts.put_chart(
        {std::string(rate.name), times(u, rate.per), bins(rate.order), 1, rate.limit, -rate.limit, "limit", true},
        "small");
  }
  charts.put_time_ticks();
  put(page, "</div>\n");
}

}  // namespace

void put_time_section(std::string& page, const PageContent& content) {
  put(page, "<section id=\"time\"><h2>Over time</h2>\n");
  if (content.recording.words() < 2) {
    put(page, "<p class=\"note\">Nothing moves: there is no time to show.</p></section>\n");
    return;
  }
  put(page, "<p class=\"note\">Velocity, acceleration and jerk are differences of the reference words. ");
  const auto samples = std::llround(content.recording.bin_seconds() / content.period.seconds());
  if (samples > 1) {
    put(page, "Bands reach from the least to the greatest value of every ", std::to_string(samples), " words. ");
  }
  put(page,
      "<span class=\"live\">Point at a chart to read it, drag across it to look closer, double-click to see all.</span>"
      "</p>\n<p class=\"live readout\"><b>time</b> <output id=\"now\">—</output> <button type=\"button\" id=\"all\" "
      "hidden>Show all</button></p>\n");
  TimeCharts charts(page, content);
  Channel feed{"feed", "mm/min", content.recording.feed(), 60, std::nullopt, std::nullopt, "", true};
  feed.parts = {content.recording.greatest_feed(), content.recording.greatest_rapid()};
  if (content.report.feed_programmed_max > 0) {
    feed.upper = content.report.feed_programmed_max;
    feed.limit_name = "greatest F";
  }
  charts.put_chart(feed, "large");
  if (content.followed != nullptr) {
    charts.put_chart({"contour error", "µm", content.followed->contour(), 1000, content.report.tolerance_mm,
                      std::nullopt, "tolerance", false},
                     "large");
    charts.put_chart({"measured feed", "mm/min", content.followed->feed(), 60, std::nullopt, std::nullopt, "", true},
                     "large");
  }
  charts.put_time_ticks();
  put(page, "<div class=\"axes\">\n");
  for (const base::Axis axis : base::all_axes) {
    if (content.machine.has(axis)) put_axis(charts, page, content, axis);
  }
  put(page, "</div>\n");
  charts.put_data();
  put(page, "</section>\n");
}

}  // namespace leadscrew::report
