#pragma once
// The ridge that two passes leave, by brute force: the lowest of both swept tools over places of the surface on a section across
// the pass.

#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <limits>
#include <vector>

#include "pass_curves.hpp"

namespace leadscrew::surfaces::test {

/// Of a point from a tool that goes on upwards without end.
inline double from_tool(const Cutter& cutter, const Vector& tip, const Vector& axis, const Vector& point) {
  const Vector d = numeric::difference(point, tip);
  const double up = numeric::dot(d, axis) - cutter.corner_radius;
  const double aside = std::sqrt(std::max(0.0, numeric::dot(d, d) - std::pow(numeric::dot(d, axis), 2))) -
                       (cutter.radius - cutter.corner_radius);
  if (up >= 0) return std::max(aside, -up) - cutter.corner_radius;
  if (aside <= 0) return -up - cutter.corner_radius;
  return std::hypot(aside, up) - cutter.corner_radius;
}

/// The least over a window of t of f, which has one minimum there, found to 0.618 to the power of rounds.
template <typename F>
double least_of(const F& f, double from, double to, int rounds) {
  constexpr double golden = 0.6180339887498949;
  double a = to - golden * (to - from), b = from + golden * (to - from), at_a = f(a), at_b = f(b);
  for (int round = 0; round < rounds; ++round) {
    if (at_a < at_b) {
      to = b, b = a, at_b = at_a;
      a = to - golden * (to - from), at_a = f(a);
    } else {
      from = a, a = b, at_a = at_b;
      b = from + golden * (to - from), at_b = f(b);
    }
  }
  return std::min(at_a, at_b);
}

class Ridges {
 public:
  explicit Ridges(const Machining& machining) : machining_(machining) {}

  /// Between the pass k, at t, and those after it, whichever cuts deepest: its height above the surface, mm.
  double height(const std::vector<Pass>& passes, std::size_t k, double t) const {
    double least = std::numeric_limits<double>::infinity();
    const Vector contact = at(passes[k], &PassNode::contact, t);
    const auto is_near = [&](const Pass& pass) {
      const Vector nearest_contact = at(pass, &PassNode::contact, nearest(pass, contact));
      return numeric::distance(nearest_contact, contact) < machining_.cutter.radius;
    };
    for (std::size_t j = k + 1; j < passes.size(); ++j) {
      const bool is_told = j <= k + 4 || j + 8 > passes.size();
      if (is_told && passes[j].number != passes[k].number && is_near(passes[j])) {
        least = std::min(least, height(passes[k], t, passes[j]));
      }
    }
    return least;
  }

  /// What all passes leave at a place of the surface: its height above it, mm.
  double left_at(const std::vector<Pass>& passes, double u, double v) const {
    const SurfaceJet jet = machining_.surface->jet(u, v);
    const Vector up = frame_of(jet, machining_.side)->n;
    double least = std::numeric_limits<double>::infinity();
    for (const Pass& pass : passes) {
      const double t = nearest(pass, jet.s);
      if (numeric::distance(at(pass, &PassNode::contact, t), jet.s) < 0.7 * machining_.cutter.radius)
        least = std::min(least, left(pass, t, jet.s, up));
    }
    return least;
  }

  /// Between the pass a, at t, and b.
  double height(const Pass& a, double t, const Pass& b) const {
    const Vector contact = at(a, &PassNode::contact, t);
    const double h = 1e-4;
    Vector f = numeric::difference(at(a, &PassNode::contact, t + h), at(a, &PassNode::contact, t - h));
    const double length = numeric::norm(f);
    for (double& x : f) x /= length;
    const double t_b = nearest(b, contact);
    const Vector other = at(b, &PassNode::contact, t_b);
    // The surface's own places on the section, s to the side of the other pass.
    double u = parameter(a, t, true), v = parameter(a, t, false);
    const SurfaceJet here = machining_.surface->jet(u, v);
    const Vector n = frame_of(here, machining_.side)->n;
    Vector across = {n[1] * f[2] - n[2] * f[1], n[2] * f[0] - n[0] * f[2], n[0] * f[1] - n[1] * f[0]};
    if (numeric::dot(across, numeric::difference(other, contact)) < 0) {
      for (double& x : across) x = -x;
    }
    double low = 0, high = numeric::dot(across, numeric::difference(other, contact)), found = 0;
    for (int round = 0; round < 22; ++round) {
      const double s = (low + high) / 2;
      const Vector place = on_section(contact, f, across, s, u, v);
      const Vector up = frame_of(machining_.surface->jet(u, v), machining_.side)->n;
      const double of_a = left(a, t, place, up), of_b = left(b, t_b, place, up);
      (of_a < of_b ? low : high) = s;
      found = std::min(of_a, of_b);
    }
    return found;
  }

 private:
  double parameter(const Pass& pass, double t, bool is_u) const {
    // From the node before; found exactly by on_section at s = 0.
    double best = 0, distance = 1e300;
    for (const PassNode& node : pass.nodes) {
      if (std::abs(node.t - t) < distance) distance = std::abs(node.t - t), best = is_u ? node.u : node.v;
    }
    return best;
  }
  double nearest(const Pass& pass, const Vector& point) const {
    double best = 0, least = 1e300;
    const double end = pass.nodes.back().t;
    for (int k = 0; k <= 100; ++k) {
      const double d = numeric::distance(at(pass, &PassNode::contact, end * k / 100), point);
      if (d < least) least = d, best = end * k / 100;
    }
    return best;
  }
  Vector on_section(const Vector& contact, const Vector& f, const Vector& across, double s, double& u,
                    double& v) const {
    for (int round = 0; round < 6; ++round) {
      const SurfaceJet jet = machining_.surface->jet(u, v);
      const Vector d = numeric::difference(jet.s, contact);
      const double p = numeric::dot(d, f), q = numeric::dot(d, across) - s;
      const double a = numeric::dot(jet.u, f), b = numeric::dot(jet.v, f), c = numeric::dot(jet.u, across),
                   e = numeric::dot(jet.v, across), determinant = a * e - b * c;
      u -= (e * p - b * q) / determinant;
      v -= (a * q - c * p) / determinant;
    }
    return machining_.surface->at(u, v);
  }
  /// How high above the place along `up` the tool's sweep about t begins.
  double left(const Pass& pass, double t, const Vector& place, const Vector& up) const {
    const double window = 1.5 * machining_.cutter.radius + 1;
    const int rounds = machining_.cutter.corner_radius > 0 ? 24 : 36;  // an edge's least is sharp, others are flat
    const auto clear = [&](double height) {
      const Vector point = numeric::sum(place, height, up);
      return least_of(
          [&](double at_t) {
            return from_tool(machining_.cutter, at(pass, &PassNode::tip, at_t), at(pass, &PassNode::axis, at_t), point);
          },
          std::max(t - window, 0.0), std::min(t + window, pass.nodes.back().t), rounds);
    };
    double h0 = 0, f0 = clear(h0), h1 = f0, f1 = clear(h1);
    for (int round = 0; round < 6 && std::abs(f1) > 1e-9 && f1 != f0; ++round) {
      const double next = h1 - f1 * (h1 - h0) / (f1 - f0);
      h0 = h1, f0 = f1;
      h1 = next, f1 = clear(h1);
    }
    return h1;
  }

  const Machining& machining_;
};

}  // namespace leadscrew::surfaces::test
