// Steps beside the true curve.

#include <algorithm>
#include <cmath>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/nc/ellipse_distance.hpp>
#include <leadscrew/nc/pulse_curve.hpp>
#include <leadscrew/waves/pulses.hpp>
#include <numbers>

namespace leadscrew::waves {
namespace {

using markup::escaped;
using markup::fixed;
using markup::put;
using markup::readable;

using nc::PulseCurve;
using nc::PulseRun;
using pulse::Point;

constexpr double panel_side = 340, gap = 28, margin = 24, title_height = 50, caption_height = 78, legend_height = 40;
constexpr double most_seen = 48;    // BLU, that a panel shows whole
constexpr double half_window = 12;  // BLU, around the worst place

struct Place {
  double x = 0, y = 0;
};

Place place_of(Point at) {
  return {static_cast<double>(at.x), static_cast<double>(at.y)};
}

/// What a panel shows, BLU.
struct Window {
  double left = 0, bottom = 0, side = 1;

  bool holds(Place at, double beyond) const {
    return at.x >= left - beyond && at.x <= left + side + beyond && at.y >= bottom - beyond &&
           at.y <= bottom + side + beyond;
  }
};

struct Panel {
  Window window;
  double x = 0, y = 0;  ///< of its upper left corner

  double scale() const { return panel_side / window.side; }
  double across(Place at) const { return x + (at.x - window.left) * scale(); }
  double down(Place at) const { return y + panel_side - (at.y - window.bottom) * scale(); }
  std::string at(Place place) const { return fixed(across(place), 1) + " " + fixed(down(place), 1); }
};

/// The true curve by its length along it, of an ellipse by its parameter: 0 … 1 from start to end; where it is closed, on
/// and on.
class TrueCurve {
 public:
  explicit TrueCurve(const PulseCurve& curve)
      : curve_(curve), start_(place_of(curve.start)), end_(place_of(curve.end)), center_(place_of(curve.center)) {
    if (!curve.is_arc()) {
      length_ = std::hypot(end_.x - start_.x, end_.y - start_.y);
      return;
    }
    if (curve.is_ellipse()) {
      semi_ = place_of({curve.semi_axes->x, curve.semi_axes->y});
    } else {
      semi_ = {curve.radius(), curve.radius()};
    }
    from_ = angle_of(start_);
    sweep_ = turned_to(end_);
    if (sweep_ == 0 || curve.start == curve.end) sweep_ = 2 * std::numbers::pi;
    length_ = sweep_ * std::max(semi_.x, semi_.y);
  }

  double length() const { return length_; }  ///< BLU; of an ellipse at least that
  bool is_closed() const { return sweep_ == 2 * std::numbers::pi; }

  Place at(double part) const {
    if (!curve_.is_arc()) return {std::lerp(start_.x, end_.x, part), std::lerp(start_.y, end_.y, part)};
    const double angle = from_ + sense() * sweep_ * part;
    return {center_.x + semi_.x * std::cos(angle), center_.y + semi_.y * std::sin(angle)};
  }

  /// How much of it is so long, about there.
  double part_of(double length, double part) const {
    if (!curve_.is_arc()) return length / length_;
    const double angle = from_ + sense() * sweep_ * part;
    return length / (sweep_ * std::hypot(semi_.x * std::sin(angle), semi_.y * std::cos(angle)));
  }

  /// The part that is nearest to a place beside the curve.
  double nearest(Place place) const {
    if (!curve_.is_arc()) {
      const double along = (place.x - start_.x) * (end_.x - start_.x) + (place.y - start_.y) * (end_.y - start_.y);
      return std::clamp(along / (length_ * length_), 0.0, 1.0);
    }
    const double turned = turned_to(place);
    if (turned <= sweep_) return turned / sweep_;
    return turned - sweep_ < 2 * std::numbers::pi - turned ? 1 : 0;
  }

 private:
  double sense() const { return static_cast<double>(curve_.direction); }

  /// Of the point of the curve that is nearest to a place: of an ellipse its parameter.
  double angle_of(Place place) const {
    const double x = place.x - center_.x, y = place.y - center_.y;
    if (!curve_.is_ellipse()) return std::atan2(y, x);
    const nc::EllipseFoot foot = nc::foot_on_ellipse(semi_.x, semi_.y, x, y);
    return std::atan2(foot.y / semi_.y, foot.x / semi_.x);
  }

  /// Angle from the start on, 0 … 2π.
  double turned_to(Place place) const {
    const double angle = sense() * (angle_of(place) - from_);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }

  PulseCurve curve_;
  Place start_, end_, center_;
  Place semi_;  ///< semi-axes, or the radius twice
  double from_ = 0, sweep_ = 0, length_ = 0;
};

/// The square around everything the run passes.
Window whole(const MeasuredPulses& pulses, const PulseCurve& curve) {
  const auto& x = pulses.figures.registers[0];
  const auto& y = pulses.figures.registers[1];
  const Place low = place_of({x.least + curve.origin().x, y.least + curve.origin().y});
  const Place high = place_of({x.greatest + curve.origin().x, y.greatest + curve.origin().y});
  const double side = std::max(high.x - low.x, high.y - low.y) + 2;
  return {(low.x + high.x - side) / 2, (low.y + high.y - side) / 2, side};
}

Window window_of(const MeasuredPulses& pulses, const PulseCurve& curve) {
  const Window all = whole(pulses, curve);
  if (all.side <= most_seen) return all;
  const Place worst = place_of(pulses.figures.worst);
  return {worst.x - half_window, worst.y - half_window, 2 * half_window};
}

void put_lattice(std::string& out, const Panel& panel) {
  out += "<path class=\"lattice\" d=\"";
  const Window& window = panel.window;
  for (double v = std::ceil(window.left); v <= window.left + window.side; ++v)
    put(out, "M", panel.at({v, window.bottom}), "v", fixed(-panel_side, 0));
  for (double v = std::ceil(window.bottom); v <= window.bottom + window.side; ++v)
    put(out, "M", panel.at({window.left, v}), "h", fixed(panel_side, 0));
  out += "\"/>\n";
}

void put_curve(std::string& out, const Panel& panel, const TrueCurve& curve, Place worst) {
  constexpr int parts = 240;
  // As much of it to both sides of the worst place as the panel can show.
  const double middle = curve.nearest(worst), reach = curve.part_of(2 * panel.window.side, middle);
  const bool is_whole =
      panel.window.holds(curve.at(0), 1) && panel.window.holds(curve.at(1), 1) && curve.length() < 4 * most_seen;
  const double least = curve.is_closed() ? middle - 0.5 : 0, greatest = curve.is_closed() ? middle + 0.5 : 1;
  const double first = is_whole ? 0 : std::max(least, middle - reach),
               last = is_whole ? 1 : std::min(greatest, middle + reach);
  out += "<path class=\"curve\" d=\"";
  for (int i = 0; i <= parts; ++i)
    put(out, i == 0 ? "M" : "L", panel.at(curve.at(std::lerp(first, last, static_cast<double>(i) / parts))));
  out += "\"/>\n";
}

/// The path of the steps, and a dot at each place.
void put_steps(std::string& out, const Panel& panel, PulseRun run) {
  std::string dots;
  bool was_seen = false;
  const auto put_place = [&] {
    const bool is_seen = panel.window.holds(place_of(run.at()), 1);
    if (is_seen) put(out, was_seen ? "L" : "M", panel.at(place_of(run.at())));
    if (is_seen) put(dots, "M", panel.at(place_of(run.at())), "h0");
    was_seen = is_seen;
  };
  out += "<path class=\"steps\" d=\"";
  put_place();
  while (!run.done()) {
    if (run.step() != pulse::Pulse<2>{}) put_place();
  }
  put(out, "\"/>\n<path class=\"dots\" d=\"", dots, "\"/>\n");
}

void put_worst(std::string& out, const Panel& panel, const TrueCurve& curve, const MeasuredPulses& pulses) {
  if (pulses.figures.max_error == 0) return;
  const Place worst = place_of(pulses.figures.worst);
  put(out, "<path class=\"off\" d=\"M", panel.at(worst), "L", panel.at(curve.at(curve.nearest(worst))), "\"/>\n");
  put(out, "<circle class=\"worst\" cx=\"", fixed(panel.across(worst), 1), "\" cy=\"", fixed(panel.down(worst), 1),
      "\" r=\"7\"/>\n");
}

void put_caption(std::string& out, const Panel& panel, const MeasuredPulses& pulses, bool is_whole) {
  const nc::PulseFigures& figures = pulses.figures;
  const auto line = [&](double below, std::string_view kind, const std::string& text) {
    put(out, "<text", kind, " x=\"", fixed(panel.x, 0), "\" y=\"", fixed(panel.y + panel_side + below, 0), "\">", text,
        "</text>\n");
  };
  line(22, " class=\"name\"", escaped(nc::name(pulses.run.method())));
  line(40, "", std::to_string(figures.clocks) + " clocks, " + std::to_string(figures.pulses) + " pulses");
  line(57, "", "greatest error " + readable(figures.max_error) + " BLU, at " + nc::point_text(figures.worst));
  line(74, "", "r.m.s. " + readable(figures.rms_error) + " BLU" + (is_whole ? "" : "; shown around the worst place"));
}

void put_panel(std::string& out, const Panel& panel, std::size_t number, const PulseCurve& curve,
               const MeasuredPulses& pulses) {
  const TrueCurve true_curve(curve);
  const std::string clip = "p" + std::to_string(number);
  put(out, "<clipPath id=\"", clip, "\"><rect x=\"", fixed(panel.x, 0), "\" y=\"", fixed(panel.y, 0), "\" width=\"",
      fixed(panel_side, 0), "\" height=\"", fixed(panel_side, 0), "\"/></clipPath>\n<g clip-path=\"url(#", clip,
      ")\">\n");
  put_lattice(out, panel);
  put_curve(out, panel, true_curve, place_of(pulses.figures.worst));
  put_steps(out, panel, pulses.run);
  put_worst(out, panel, true_curve, pulses);
  out += "</g>\n";
  put_caption(out, panel, pulses, whole(pulses, curve).side <= most_seen);
}

/// Colours that read on white and on black, where a page does not tell which it is.
constexpr std::string_view style =
    "<style>text{font:500 13px system-ui,-apple-system,'Segoe UI',sans-serif;fill:#6b747c}.title{font-size:16px;"
    "font-weight:600}.name{font-size:14px;font-weight:600}path,circle{fill:none}.lattice{stroke:#7d868e;stroke-width:."
    "5;"
    "opacity:.45}.curve{stroke:#8a9299;stroke-width:5;opacity:.6}.steps{stroke:#2481b5;stroke-width:2;"
    "stroke-linejoin:round}.dots{stroke:#2481b5;stroke-width:5;stroke-linecap:round}.off{stroke:#d2622f;stroke-width:2."
    "5}"
    ".worst{stroke:#d2622f;stroke-width:2.5}@media(prefers-color-scheme:dark){text{fill:#9aa5ad}.steps,.dots{"
    "stroke:#5db6d4}.off,.worst{stroke:#ee8f66}}</style>\n";

void put_legend(std::string& out, double y) {
  const auto entry = [&](double x, const std::string& sign, std::string_view text) {
    put(out, sign, "<text x=\"", fixed(x + 40, 0), "\" y=\"", fixed(y + 4, 0), "\">", text, "</text>\n");
  };
  const auto stroke = [&](std::string_view kind, double x, double length) {
    return "<path class=\"" + std::string(kind) + "\" d=\"M" + fixed(x, 0) + " " + fixed(y, 0) + "h" +
           fixed(length, 0) + "\"/>";
  };
  entry(margin, stroke("curve", margin, 32), "true curve");
  entry(margin + 124, stroke("steps", margin + 124, 32) + stroke("dots", margin + 140, 0), "steps");
  entry(margin + 222,
        "<circle class=\"worst\" cx=\"" + fixed(margin + 240, 0) + "\" cy=\"" + fixed(y, 0) + "\" r=\"7\"/>", "worst");
  entry(margin + 296, "", "a square is one BLU");
}

}  // namespace

std::string title_of(const PulseCurve& curve) {
  const std::string ends = "from " + nc::point_text(curve.start) + " to " + nc::point_text(curve.end);
  if (!curve.is_arc()) return "line " + ends;
  const bool is_ccw = curve.direction == pulse::Direction::counterclockwise;
  const std::string what = curve.is_ellipse() ? "arc of an ellipse " : "arc ";
  return what + ends + " about " + nc::point_text(curve.center) + (is_ccw ? ", counterclockwise" : ", clockwise");
}

base::Result<void> write_pulse_picture(const PulseCurve& curve, const std::vector<MeasuredPulses>& pulses,
                                       const base::ByteSink& sink) {
  const std::size_t columns = pulses.size() == 4 ? 2 : std::min<std::size_t>(pulses.size(), 3);
  const std::size_t rows = (pulses.size() + columns - 1) / columns;
  const double across = panel_side + gap, down = panel_side + caption_height + gap;
  const double width = 2 * margin + static_cast<double>(std::max<std::size_t>(columns, 2)) * across - gap;
  const double height = title_height + static_cast<double>(rows) * down + legend_height - gap;
  std::string out;
  put(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", fixed(width, 0), " ", fixed(height, 0),
      "\" width=\"", fixed(width, 0), "\" height=\"", fixed(height, 0), "\" role=\"img\">\n<title>",
      escaped(title_of(curve)), "</title>\n", style, "<text class=\"title\" x=\"", fixed(margin, 0), "\" y=\"30\">",
      escaped(title_of(curve)), "</text>\n");
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    const Panel place{window_of(pulses[i], curve), margin + static_cast<double>(column) * across,
                      title_height + static_cast<double>(row) * down};
    put_panel(out, place, i, curve, pulses[i]);
    if (auto written = sink(out); !written) return written;
    out.clear();
  }
  put_legend(out, height - 18);
  out += "</svg>\n";
  return sink(out);
}

}  // namespace leadscrew::waves
