#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/study/surface_patch.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <leadscrew/surfaces/surface_text.hpp>
#include <limits>

namespace leadscrew::study {

namespace {

using surfaces::Pass;
using surfaces::Surface;

constexpr double clearance = 25;  // mm

double dot_product(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector from_to(const Vector& a, const Vector& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

double off_line(const Vector& point, const Vector& from, const Vector& to) {
  const Vector along = from_to(from, to);
  Vector off = from_to(from, point);
  const double share = dot_product(off, along) / dot_product(along, along);
  for (std::size_t k = 0; k < 3; ++k) off[k] -= share * along[k];
  return numeric::norm(off);
}

/// The greatest distance of the path between two parameters from the line between its ends.
double chord_error(const Pass& pass, double from, double to) {
  constexpr int places = 40;
  const Vector begin = place_of(pass, from), end = place_of(pass, to);
  double most = 0;
  for (int i = 1; i < places; ++i)
    most = std::max(most, off_line(place_of(pass, from + (to - from) * i / places), begin, end));
  return most;
}

/// Where a line from there has to end.
double end_of_line(const Pass& pass, double from, double last, double chord) {
  constexpr double step = 0.25;  // mm
  constexpr int halvings = 30;
  double good = from, bad = from;
  while (bad < last && chord_error(pass, from, bad = std::min(bad + step, last)) <= chord) good = bad;
  if (good >= last) return last;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (good + bad) / 2;
    (chord_error(pass, from, middle) <= chord ? good : bad) = middle;
  }
  return good;
}

/// How far along the normal from s the ball about this centre begins; infinite where it is not met.
double entry(const Vector& s, const Vector& n, const Vector& tip) {
  const Vector w = from_to(s, {tip[0], tip[1], tip[2] + ball_radius});
  const double along = dot_product(w, n), square = ball_radius * ball_radius - dot_product(w, w) + along * along;
  return square > 0 ? along - std::sqrt(square) : INFINITY;
}

/// The least of it over the pass near t, by golden section.
double least_entry(const Vector& s, const Vector& n, const Pass& pass, double t) {
  constexpr double reach = 3, golden = 0.6180339887498949;
  constexpr int sections = 44;
  double low = std::max(pass.nodes.front().t, t - reach), high = std::min(pass.nodes.back().t, t + reach);
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = entry(s, n, place_of(pass, a)), at_b = entry(s, n, place_of(pass, b));
  for (int i = 0; i < sections; ++i) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      at_a = entry(s, n, place_of(pass, a = high - golden * (high - low)));
    } else {
      low = a, a = b, at_a = at_b;
      at_b = entry(s, n, place_of(pass, b = low + golden * (high - low)));
    }
  }
  return std::min(at_a, at_b);
}

/// The parameter of the pass where its contact is at u.
double parameter_at(const Pass& pass, double u) {
  const auto& nodes = pass.nodes;
  const bool rises = nodes.back().u > nodes.front().u;
  const auto behind = std::find_if(nodes.begin() + 1, nodes.end() - 1,
                                   [&](const surfaces::PassNode& node) { return rises ? node.u >= u : node.u <= u; });
  const auto before = behind - 1;
  return before->t + (u - before->u) / (behind->u - before->u) * (behind->t - before->t);
}

std::string line_to(const Vector& place) {
  constexpr int decimals = 4;
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) text += "XYZ"[k] + base::fixed_text(place[k], decimals) + (k < 2 ? " " : "\n");
  return text;
}

}  // namespace

surfaces::SurfaceForm patch_form() {
  constexpr int heights[4][4] = {{0, 6, 6, 0}, {6, 14, 2, -4}, {6, 2, 14, 6}, {0, -4, 6, 8}};  // by u, then v
  surfaces::SurfaceForm form{{3, 3}, {surfaces::uniform_knots(4, 3), surfaces::uniform_knots(4, 3)}, {4, 4}, {}};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) form.net.push_back({{20.0 * i, 20.0 * j, static_cast<double>(heights[i][j])}, 1});
  }
  return form;
}

surfaces::Machining patch_machining(bool equal_steps) {
  surfaces::Machining machining;
  machining.surface = std::make_shared<const Surface>(patch_form());
  machining.cutter = {ball_radius, ball_radius};
  machining.scallop = ridge_height;
  machining.u = machining.v = {0, 1};
  machining.equal_steps = equal_steps;
  return machining;
}

std::vector<Pass> patch_passes(bool equal_steps) {
  surfaces::Passes passes(patch_machining(equal_steps));
  std::vector<Pass> all;
  while (auto pass = passes.next()) all.push_back(std::move(*pass));
  return all;
}

Vector place_of(const Pass& pass, double t, Of of) {
  const auto& nodes = pass.nodes;
  std::size_t i = 0;
  while (i + 2 < nodes.size() && nodes[i + 1].t <= t) ++i;
  const double h = nodes[i + 1].t - nodes[i].t, x = (t - nodes[i].t) / h;
  const double x2 = x * x, x3 = x2 * x, x4 = x3 * x, x5 = x4 * x;
  Vector place;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = of == Of::tip ? nodes[i].tip[k] : nodes[i].contact[k];
    const auto& b = of == Of::tip ? nodes[i + 1].tip[k] : nodes[i + 1].contact[k];
    // Hermite's quintic
    place[k] = a[0] * (1 - 10 * x3 + 15 * x4 - 6 * x5) + a[1] * h * (x - 6 * x3 + 8 * x4 - 3 * x5) +
               a[2] * h * h * (x2 - 3 * x3 + 3 * x4 - x5) / 2 + b[0] * (10 * x3 - 15 * x4 + 6 * x5) +
               b[1] * h * (-4 * x3 + 7 * x4 - 3 * x5) + b[2] * h * h * (x3 - 2 * x4 + x5) / 2;
  }
  return place;
}

double length_of(const Pass& pass, Of of) {
  constexpr int pieces = 2000;
  const double from = pass.nodes.front().t, to = pass.nodes.back().t;
  double length = 0;
  Vector last = place_of(pass, from, of);
  for (int i = 1; i <= pieces; ++i) {
    const Vector here = place_of(pass, from + (to - from) * i / pieces, of);
    length += numeric::distance(last, here);
    last = here;
  }
  return length;
}

LinesOfPasses lines_of(const std::vector<Pass>& passes, double chord) {
  LinesOfPasses lines{chord, {place_of(passes.front(), passes.front().nodes.front().t)}, 0};
  for (const Pass& pass : passes) {
    const double last = pass.nodes.back().t;
    for (double t = pass.nodes.front().t; t < last;) {
      t = end_of_line(pass, t, last, chord);
      lines.ends.push_back(place_of(pass, t));
      lines.of_passes += pass.is_link ? 0 : 1;
    }
  }
  return lines;
}

double ridge_between(const Surface& surface, const Pass& a, const Pass& b, int sections) {
  constexpr int across = 30;
  double most = 0;
  for (int i = 1; i < sections; ++i) {
    const double u = static_cast<double>(i) / sections;
    const double at_a = parameter_at(a, u), at_b = parameter_at(b, u);
    // The ridge is where both leave the same height, which one leaves more of the farther it is: by bisection.
    double low = a.across, high = b.across;
    double height = 0;
    for (int k = 0; k < across; ++k) {
      const double v = (low + high) / 2;
      const auto jet = surface.jet(u, v);
      const Vector n = surfaces::frame_of(jet, 1)->n;
      const double by_a = least_entry(jet.s, n, a, at_a), by_b = least_entry(jet.s, n, b, at_b);
      height = std::min(by_a, by_b);
      (by_a < by_b ? low : high) = v;
    }
    most = std::max(most, height);
  }
  return most;
}

double contact_error(const Surface& surface, const Vector& tip) {
  constexpr int steps = 30;
  const Vector centre = {tip[0], tip[1], tip[2] + ball_radius};
  double u = std::clamp(tip[0] / 60, 0.0, 1.0), v = std::clamp(tip[1] / 60, 0.0, 1.0);
  for (int i = 0; i < steps; ++i) {  // Gauss and Newton, with the surface's own curvature
    const auto jet = surface.jet(u, v);
    const Vector d = from_to(centre, jet.s);
    const double a = dot_product(jet.u, jet.u) + dot_product(d, jet.uu),
                 b = dot_product(jet.u, jet.v) + dot_product(d, jet.uv),
                 c = dot_product(jet.v, jet.v) + dot_product(d, jet.vv);
    const double p = dot_product(d, jet.u), q = dot_product(d, jet.v), determinant = a * c - b * b;
    u = std::clamp(u - (c * p - b * q) / determinant, 0.0, 1.0);
    v = std::clamp(v - (a * q - b * p) / determinant, 0.0, 1.0);
  }
  return std::abs(numeric::distance(surface.at(u, v), centre) - ball_radius);
}

FeedErrors feed_errors(int order, double feed, double period) {
  const Surface surface(patch_form());
  constexpr double v = 0.5;
  const double step = feed * period;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  FeedErrors errors{infinity, -infinity};
  for (double u = 0;;) {
    const auto jet = surface.jet(u, v);
    const double speed = numeric::norm(jet.u);
    double du = step / speed;
    if (order > 1) du -= dot_product(jet.u, jet.uu) * step * step / (2 * std::pow(speed, 4));
    if (u + du > 1) return errors;
    const double error = 100 * (numeric::distance(jet.s, surface.at(u + du, v)) / step - 1);
    errors = {std::min(errors.least, error), std::max(errors.most, error)};
    u += du;
  }
}

std::string surface_blocks(double feed) {
  return surfaces::definition_text(patch_form(), 1) + "G6.5 D1 T1 H0.01 Z25" + word('F', 60 * feed) + "\n";
}

PartProgram surface_program(double feed) {
  PartProgram program{"G21 G90 G17 G94\n" + surface_blocks(feed) + "M2\n", {0, 0, clearance}, {}};
  program.tools.set({.number = 1, .diameter = 2 * ball_radius, .corner_radius = ball_radius, .length = 60});
  return program;
}

PartProgram lines_program(const LinesOfPasses& lines, double feed, const std::string& path_control) {
  const Vector& first = lines.ends.front();
  std::string text = "G21 G90 G17 G94 " + path_control + word('F', 60 * feed) + "\nG0 " +
                     line_to({first[0], first[1], clearance}) + "G1 ";
  for (const Vector& end : lines.ends) text += line_to(end);
  return {text + "G0" + word('Z', clearance) + "\nM2\n", {0, 0, clearance}, {}};
}

PartProgram leaning_program(double feed) {
  PartProgram program{"G21 G90 G17 G94\n" + surfaces::definition_text(patch_form(), 1) +
                          "G43.4\nG6.5 D1 T1 A8 H0.1 Z25" + word('F', 60 * feed) + "\nM2\n",
                      {0, 0, clearance},
                      {}};
  program.tools.set({.number = 1, .diameter = 10, .corner_radius = 1, .length = 60});
  return program;
}

}  // namespace leadscrew::study
