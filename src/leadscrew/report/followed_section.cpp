// Ideal, commanded and actual path in one picture: the part as it is made. Errors are drawn magnified, away from the
// place of the path that each place of the slides is matched to; by how much is chosen by buttons that need no script.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>
#include <leadscrew/report/path_view.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace leadscrew::report {
namespace {

using markup::fixed;
using markup::put;
using markup::readable;
using markup::readable_distance;

constexpr double width = 1200, height = 640, border = 40;
constexpr double magnified_share = 0.05;  // of the picture's lesser side, that the greatest error may take

/// The one that shows most.
ViewSide side_of(std::span<const PathPoint> path) {
  const auto size = [&](ViewSide side) {
    const SeenExtent extent = extent_of(path, side);
    return std::min(extent.width(), extent.height()) + 1e-3 * std::max(extent.width(), extent.height());
  };
  const std::array<ViewSide, 3> sides = {ViewSide::top, ViewSide::front, ViewSide::right};
  return *std::ranges::max_element(sides, {}, size);
}

std::string_view name_of(ViewSide side) {
  return side == ViewSide::top ? "Top" : side == ViewSide::front ? "Front" : "Right side";
}

/// 1, 2 or 5 times a power of ten, not above the value, at least 1.
double round_factor(double value) {
  double factor = 1;
  for (const double step : {1.0, 2.0, 5.0}) {
    const double power = std::pow(10, std::floor(std::log10(std::max(value, 1.0) / step)));
    if (power >= 1) factor = std::max(factor, step * power);
  }
  return std::min(factor, 1e6);
}

class Picture {
 public:
  Picture(std::span<const PathPoint> path, ViewSide side) : side_(side) {
    const SeenExtent extent = extent_of(path, side);
    const double wide = std::max(extent.width(), 1e-3), high = std::max(extent.height(), 1e-3);
    placement_ = centred(extent, std::min((width - 2 * border) / wide, (height - 2 * border) / high), border, border,
                         width - 2 * border, height - 2 * border);
  }

  double scale() const { return placement_.scale; }

  std::string line(std::span<const PathPoint> path) const {
    std::string data;
    for (const PathPoint& point : path) add(data, point.position);
    return data;
  }

  std::string magnified(std::span<const FollowedPoint> points, double factor) const {
    std::string data;
    for (const FollowedPoint& point : points) {
      base::AxisVector shown = point.nearest;
      for (std::size_t k = 0; k < shown.size(); ++k) shown[k] += factor * (point.actual[k] - point.nearest[k]);
      add(data, shown);
    }
    return data;
  }

 private:
  void add(std::string& data, const base::AxisVector& position) const {
    const Seen seen = seen_from(side_, position);
    put(data, data.empty() ? "M" : "L", fixed(placement_.x(seen.right), 1), " ", fixed(placement_.y(seen.up), 1));
  }

  ViewSide side_;
  Placement placement_;
};

/// None, the greatest, and one between.
std::vector<double> factors_to(double greatest) {
  std::vector<double> factors = {1};
  const double between = round_factor(std::sqrt(greatest));
  if (between > 1) factors.push_back(between);
  if (greatest > between) factors.push_back(greatest);
  return factors;
}

void put_buttons(std::string& page, const std::vector<double>& factors) {
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string id = "magnify" + std::to_string(i);
    put(page, "<input type=\"radio\" name=\"magnify\" id=\"", id, "\"", i + 1 == factors.size() ? " checked" : "",
        "/><label for=\"", id, "\">errors × ", readable(factors[i], 7), "</label>\n");
  }
}

}  // namespace

void put_followed_section(std::string& page, const PageContent& content) {
  if (content.followed == nullptr) return;
  FollowedRecording& followed = *content.followed;
  const auto ideal = followed.ideal().empty() ? content.recording.path() : followed.ideal();
  const ViewSide side = side_of(ideal);
  const Picture picture(ideal, side);
  const double error = std::max(followed.greatest_contour(), 1e-9) * picture.scale();
  const double greatest = round_factor(magnified_share * height / error);
  const std::vector<double> factors = factors_to(greatest);
  put(page, "<section id=\"slides\"><h2>The part as it is made</h2>\n<p class=\"note\">",
      content.recording.shows_tip() ? "Where the slides brought the tool's tip, seen from the workpiece,"
                                    : "Where the slides were,",
      " over the programmed geometry; what they are off by is drawn magnified, away from the path of the words. At "
      "most ",
      readable_distance(followed.greatest_contour()), ".</p>\n<figure class=\"card slides\"><figcaption><b>",
      name_of(side), "</b></figcaption>\n");
  put_buttons(page, factors);
  put(page, "<p class=\"keys\"><i class=\"ideal\"></i>ideal <i class=\"commanded\"></i>commanded ",
      "<i class=\"actual\"></i>actual</p>\n<svg viewBox=\"0 0 1200 640\" role=\"img\" aria-label=\"Ideal, commanded "
      "and "
      "actual path\">\n<path class=\"ideal\" d=\"",
      picture.line(ideal), "\"/>\n<path class=\"commanded\" d=\"", picture.line(content.recording.path()), "\"/>\n");
  for (std::size_t i = 0; i < factors.size(); ++i) {
    put(page, "<path class=\"actual by", std::to_string(i), "\" d=\"", picture.magnified(followed.points(), factors[i]),
        "\"/>\n");
  }
  put(page, "</svg></figure></section>\n");
}

}  // namespace leadscrew::report
