#include <leadscrew/report/speed_colors.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace leadscrew::report {
namespace {

double channel(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

void put_byte(std::string& out, double value) {
  constexpr char hexadecimal[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned>(std::lround(value * 255));
  out += hexadecimal[byte >> 4];
  out += hexadecimal[byte & 15];
}

std::string oklch(double lightness, double chroma, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double a = chroma * std::cos(angle), b = chroma * std::sin(angle);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  std::string out = "#";
  put_byte(out, channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s));
  put_byte(out, channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s));
  put_byte(out, channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
  return out;
}

}  // namespace

std::string speed_color(std::size_t level, Background background) {
  const double place = (static_cast<double>(level) + 0.5) / static_cast<double>(speed_levels);
  const double slow = background == Background::light ? 0.34 : background == Background::dark ? 0.52 : 0.46;
  const double fast = background == Background::light ? 0.78 : background == Background::dark ? 0.93 : 0.80;
  return oklch(slow + (fast - slow) * place, 0.15, 300 - 200 * place);
}

double SpeedScale::place(double feed) const {
  if (!(greatest > 0) || !(feed > 0)) return 0;
  const double part = std::min(feed / greatest, 1.0);
  return square_root ? std::sqrt(part) : part;
}

std::size_t SpeedScale::level(double feed) const {
  return std::min(static_cast<std::size_t>(place(feed) * static_cast<double>(speed_levels)), speed_levels - 1);
}

SpeedScale speed_scale(std::span<const PathPoint> path, double greatest) {
  SpeedScale scale{greatest};
  double length = 0, feed_by_length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].is_rapid) continue;
    const auto& a = path[i - 1].position;
    const auto& b = path[i].position;
    const double step = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    length += step;
    feed_by_length += step * (path[i].feed + path[i - 1].feed) / 2;
  }
  scale.square_root = feed_by_length < 0.3 * scale.greatest * length;
  return scale;
}

}  // namespace leadscrew::report
