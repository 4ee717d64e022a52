// Position, velocity, acceleration and jerk of all axes over time, as a picture of its own. Limits differ from axis to
// axis, so derivatives are shown as shares of them: what every axis may reach is one line, at ±100 %.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/charts.hpp>
#include <leadscrew/report/page_parts.hpp>
#include <leadscrew/report/path_thinning.hpp>

#include <algorithm>
#include <cmath>

namespace leadscrew::report {
namespace {

using markup::put;
using markup::readable;

constexpr double finest = 5e-4;             // of time and of what is shown, that a curve may leave out
constexpr std::size_t most_samples = 3000;  // of a curve

double limit_of(const machine::AxisLimits& limits, int order) {
  return order == 1 ? limits.velocity : order == 2 ? limits.acceleration : limits.jerk;
}

class MotionCharts {
 public:
  MotionCharts(const Recording& recording, const machine::Machine& machine) : recording_(recording), machine_(machine) {
    for (const base::Axis axis : base::all_axes) {
      if (machine.has(axis)) axes_.push_back(axis);
    }
  }

  std::vector<Chart> charts() const {
    std::vector<Chart> all;
    for (const bool rotary : {false, true}) {
      Chart chart{rotary ? "position, °" : "position, mm", {}, {}};
      for (const base::Axis axis : axes_) {
        if (base::is_rotary(axis) == rotary) chart.curves.push_back(curve_of(axis, 0, 1));
      }
      if (!chart.curves.empty()) all.push_back(std::move(chart));
    }
    constexpr std::string_view names[] = {"", "velocity", "acceleration", "jerk"};
    for (int order = 1; order <= 3; ++order) {
      Chart chart{std::string(names[order]) + ", % of the limit", {}, {100, -100}};
      for (const base::Axis axis : axes_)
        chart.curves.push_back(curve_of(axis, order, 100 / limit_of(machine_.limits(axis), order)));
      all.push_back(std::move(chart));
    }
    return all;
  }

  /// "X  200 mm/s, 1000 mm/s², 20 000 mm/s³"
  std::vector<ChartKey> keys() const {
    std::vector<ChartKey> keys;
    for (const base::Axis axis : axes_) {
      std::string name(1, base::letter(axis));
      constexpr std::string_view per[] = {"", "/s", "/s²", "/s³"};
      for (int order = 1; order <= 3; ++order) {
        put(name, order == 1 ? ":  " : ", ", readable(limit_of(machine_.limits(axis), order)), " ", unit(axis),
            per[order]);
      }
      keys.push_back({base::index(axis), std::move(name)});
    }
    return keys;
  }

 private:
  /// Where a bin holds several words, its least and its greatest value, the nearer to the one before first.
  Curve curve_of(base::Axis axis, int order, double per_unit) const {
    const std::span<const Extent> extents = recording_.axis(axis, order);
    std::vector<PathPoint> points;
    double greatest = 0;
    const auto add = [&](double bin, double value) {
      points.push_back({{bin * recording_.bin_seconds(), value * per_unit}});
      greatest = std::max(greatest, std::fabs(value * per_unit));
    };
    for (std::size_t i = 0; i < extents.size(); ++i) {
      const Extent& extent = extents[i];
      if (!std::isfinite(extent.least) || !std::isfinite(extent.greatest)) continue;
      const auto bin = static_cast<double>(i);
      const bool rises = points.empty() || points.back().position[1] < (extent.least + extent.greatest) / 2 * per_unit;
      add(bin, rises ? extent.least : extent.greatest);
      if (extent.least < extent.greatest) add(bin + 0.5, rises ? extent.greatest : extent.least);
    }
    base::AxisSet both;
    both.insert(base::Axis::X);
    both.insert(base::Axis::Y);
    // The thinner goes by the distance travelled: time counts as much as values do.
    const double height = greatest > 0 ? greatest : 1, time_scale = height / std::max(recording_.seconds(), 1e-9);
    for (PathPoint& point : points) point.position[0] *= time_scale;
    const ThinningTolerance tolerance{finest * height, 0};
    thin(points, both, tolerance);
    Curve curve{{}, base::index(axis)};
    for (const PathPoint& point : thinned_to(points, both, most_samples, tolerance))
      curve.samples.push_back({point.position[0] / time_scale, point.position[1]});
    return curve;
  }

  const Recording& recording_;
  const machine::Machine& machine_;
  std::vector<base::Axis> axes_;
};

}  // namespace

base::Result<void> write_motion_charts(const std::string& title, const Recording& recording,
                                       const machine::Machine& machine, const base::ByteSink& sink) {
  const MotionCharts motion(recording, machine);
  return write_charts({title, motion.charts(), motion.keys(), false}, sink);
}

}  // namespace leadscrew::report
