#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/reach.hpp>

namespace leadscrew::surfaces {

namespace {

using kinematics::cross_product;
using numeric::dot;
using numeric::sum;

constexpr double least_sine = 1e-3;                           // of the tool's lean
constexpr double least_turn = 0.02;                           // of c_t × c_φ, of the product of their lengths
constexpr double widest_angle_step = 0.3;                     // radians, of one round
constexpr double greatest_angle = 2.8;                        // radians
constexpr double near_reach_height = 1e-3, near_foot = 5e-3;  // before the last round, which squares them: of h; mm
constexpr int most_reach_rounds = 20;
constexpr double least_gap = 1e-3;  // between two overlaps, of all there are

/// The edge of a tool at one place of a line, with what its sweep needs.
class Edge {
 public:
  Edge(const Cutter& cutter, const Touch<Jet1>& touch, const Vector& towards) : corner_(cutter.corner_radius) {
    const Jet1 r = corner_;
    VectorOf<Jet1> center, first;
    for (std::size_t k = 0; k < 3; ++k) {
      center[k] = touch.tip[k] + r * touch.axis[k];
      first[k] = touch.contact[k] + r * touch.normal[k] - center[k];
    }
    VectorOf<Jet1> second = cross_of(touch.axis, first);
    for (std::size_t k = 0; k < 3; ++k) normal_[k] = touch.normal[k][0];
    const double sign = second[0][0] * towards[0] + second[1][0] * towards[1] + second[2][0] * towards[2] < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      center_[k] = center[k][0], center_rate_[k] = center[k][1];
      first_[k] = first[k][0], first_rate_[k] = first[k][1];
      second_[k] = sign * second[k][0], second_rate_[k] = sign * second[k][1];
    }
    const Vector across = cross_product(sum(center_rate_, 1, first_rate_), second_);
    down_ = dot(across, normal_) > 0 ? -1 : 1;
  }

  struct Point {
    Vector position, by_angle;
  };
  /// X and X_φ; none where N turns too fast to be found.
  std::optional<Point> at(double angle) const {
    const auto [s, c, cosine_less_one] = numeric::sines(angle);
    Vector out, tangent, rate, tangent_rate;
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] = c * first_[k] + s * second_[k];
      tangent[k] = c * second_[k] - s * first_[k];
      rate[k] = center_rate_[k] + c * first_rate_[k] + s * second_rate_[k];
      tangent_rate[k] = c * second_rate_[k] - s * first_rate_[k];
    }
    Point point{sum(center_, 1, out), tangent};
    if (corner_ == 0) return point;
    const Vector cross = cross_product(rate, tangent);
    // c_φφ = −(c − C)
    const Vector turn = sum(cross_product(tangent_rate, tangent), -1, cross_product(rate, out));
    const double square = dot(cross, cross);
    if (!(square > least_turn * least_turn * dot(rate, rate) * dot(tangent, tangent))) return std::nullopt;
    const double length = std::sqrt(square), along = dot(cross, turn) / square;
    for (std::size_t k = 0; k < 3; ++k) {
      point.position[k] += corner_ * down_ * cross[k] / length;
      point.by_angle[k] += corner_ * down_ * (turn[k] - along * cross[k]) / length;
    }
    return point;
  }

 private:
  double corner_, down_ = 1;
  Vector center_{}, center_rate_{}, first_{}, first_rate_{}, second_{}, second_rate_{}, normal_{};
};

/// The place with both first derivatives. Beyond its range the surface goes on as the quadric of its border.
SurfaceJet extended_jet(const Surface& surface, double u, double v) {
  const Range us = surface.range(Direction::u), vs = surface.range(Direction::v);
  const double at_u = std::clamp(u, us.from, us.to), at_v = std::clamp(v, vs.from, vs.to), du = u - at_u, dv = v - at_v;
  if (du == 0 && dv == 0) return surface.jet_of_first_order(u, v);
  SurfaceJet jet = surface.jet_of_second_order(at_u, at_v);
  for (std::size_t k = 0; k < 3; ++k) {
    jet.s[k] += du * (jet.u[k] + du * jet.uu[k] / 2 + dv * jet.uv[k]) + dv * (jet.v[k] + dv * jet.vv[k] / 2);
    jet.u[k] += du * jet.uu[k] + dv * jet.uv[k];
    jet.v[k] += du * jet.uv[k] + dv * jet.vv[k];
  }
  return jet;
}

/// Adds to u and v what moves a place of the surface by this in its tangent plane.
void move_foot(const SurfaceJet& jet, const Frame& frame, const Vector& by, double& u, double& v) {
  const double a = dot(jet.u, by), b = dot(jet.v, by), determinant = frame.E * frame.G - frame.F * frame.F;
  u += (frame.G * a - frame.F * b) / determinant;
  v += (frame.E * b - frame.F * a) / determinant;
}

/// Of a tool with an edge that touches at a place of a line. towards: on the surface, to the side; near: of a neighbouring place,
/// counted from that one's contact. None where the tool stands (almost) on its bottom, leans sideways alone, or is nowhere so high.
///
/// d√H = H′/(2 √H) dφ, H the height of X(φ) above the surface.
std::optional<ReachEnd> reach_at(const Machining& machining, const SurfaceJet& jet, const LinePlace& place,
                                 const Vector& towards, double height, const std::optional<ReachEnd>& near) {
  const Touch<Jet1> touch = touch_of_first_order(machining, jet, place);
  double cosine = 0;
  for (std::size_t k = 0; k < 3; ++k) cosine += touch.axis[k][0] * touch.normal[k][0];
  if (!(1 - cosine * cosine > least_sine * least_sine)) return std::nullopt;
  const Edge edge(machining.cutter, touch, towards);
  ReachEnd end{0.1, place.u.value, place.v.value};
  if (near) end = {near->angle, end.u + near->u, end.v + near->v};
  const double wanted = std::sqrt(height);
  for (int round = 0; round < most_reach_rounds; ++round) {
    const std::optional<Edge::Point> point = edge.at(end.angle);
    const SurfaceJet foot = extended_jet(*machining.surface, end.u, end.v);
    const std::optional<Frame> frame = frame_of(foot, machining.side);
    if (!point || !frame) return std::nullopt;
    const Vector off = numeric::difference(point->position, foot.s);
    const double high = dot(off, frame->n), rise = dot(point->by_angle, frame->n);
    double step = 0;
    if (high > 0 && rise > 0) {
      const double root = std::sqrt(high);
      step = std::clamp(2 * root * (wanted - root) / rise, -widest_angle_step, widest_angle_step);
      if (end.angle + step <= 0) step = -end.angle / 2;
    }
    const Vector ahead = sum(sum(off, step, point->by_angle), -high - step * rise, frame->n);
    move_foot(foot, *frame, ahead, end.u, end.v);
    end.angle += step;
    if (!(end.angle < greatest_angle)) return std::nullopt;
    const bool is_at = high > 0 && rise > 0 && std::abs(high - height) <= near_reach_height * height;
    if (is_at && dot(ahead, ahead) <= near_foot * near_foot) return end;
  }
  return std::nullopt;
}

}  // namespace

bool has_reach(const Machining& machining) {
  return machining.scallop > 0 && !machining.cutter.is_ball() &&
         machining.orientation.rule == Orientation::Rule::leaned;
}

namespace {

/// What the next place's reach is expected to be, from its contact, by those of the last two.
class Expected {
 public:
  std::optional<ReachEnd> next() const {
    if (!last_ || !before_) return last_;
    return ReachEnd{2 * last_->angle - before_->angle, 2 * last_->u - before_->u, 2 * last_->v - before_->v};
  }
  void add(const ReachEnd& end, const LinePlace& place) {
    before_ = last_;
    last_ = {end.angle, end.u - place.u.value, end.v - place.v.value};
  }

 private:
  std::optional<ReachEnd> last_, before_;
};

}  // namespace

std::optional<Reaches> reaches_along(PassLog& log, Direction along, const std::vector<std::optional<LinePlace>>& places,
                                     double towards) {
  Reaches reaches;
  reaches.reserve(places.size());
  Expected expected;
  for (const std::optional<LinePlace>& place : places) {
    reaches.emplace_back();
    if (!place) continue;
    const std::optional<Contact> contact = contact_at(log, *place);
    if (!contact) return std::nullopt;
    const Vector side = sum(Vector{}, towards, along == Direction::u ? contact->jet.v : contact->jet.u);
    const double height = log.machining->scallop;
    reaches.back() = reach_at(*log.machining, contact->jet, *place, side, height, expected.next());
    if (!reaches.back()) return std::nullopt;
    expected.add(*reaches.back(), *place);
  }
  return reaches;
}

namespace {

/// The ends of a line's reaches as a curve of the parameter across by the one along.
class ReachCurve {
 public:
  ReachCurve(Direction along, const Reaches& reaches) {
    for (const std::optional<ReachEnd>& end : reaches) {
      if (!end) continue;
      const Place place = along == Direction::u ? Place{end->u, end->v} : Place{end->v, end->u};
      if (places_.empty() || place.along > places_.back().along) places_.push_back(place);
    }
  }
  std::optional<double> across(double along) const;

 private:
  struct Place {
    double along, across;
  };
  std::vector<Place> places_;
};

/// The cubic through the four nearest.
std::optional<double> ReachCurve::across(double along) const {
  if (places_.size() < 4 || !(along >= places_.front().along && along <= places_.back().along)) return std::nullopt;
  const auto after = std::lower_bound(places_.begin(), places_.end(), along,
                                      [](const Place& place, double wanted) { return place.along < wanted; });
  const auto index = static_cast<std::size_t>(after - places_.begin());
  const std::size_t first = std::min(index < 2 ? 0 : index - 2, places_.size() - 4);
  double across = 0;
  for (std::size_t i = first; i < first + 4; ++i) {
    double share = 1;
    for (std::size_t j = first; j < first + 4; ++j) {
      if (j != i) share *= (along - places_[j].along) / (places_[i].along - places_[j].along);
    }
    across += share * places_[i].across;
  }
  return across;
}

}  // namespace

std::vector<std::optional<double>> overlaps(Direction along, const Reaches& here, const Reaches& there,
                                            double towards) {
  const bool is_u = along == Direction::u;
  const ReachCurve limit(along, here);
  std::vector<std::optional<double>> found;
  for (const std::optional<ReachEnd>& end : there) {
    found.emplace_back();
    if (!end) continue;
    if (const std::optional<double> across = limit.across(is_u ? end->u : end->v)) {
      found.back() = towards * (*across - (is_u ? end->v : end->u));
    }
  }
  return found;
}

std::vector<Overlap> overlaps_between(Direction along, const Reaches& here, const Reaches& there, double towards) {
  std::vector<Overlap> found;
  const auto add = [&](const Reaches& line, const std::vector<std::optional<double>>& overlap, std::size_t k) {
    if (overlap[k]) found.push_back({along == Direction::u ? line[k]->u : line[k]->v, *overlap[k]});
  };
  const std::vector<std::optional<double>> of_there = overlaps(along, here, there, towards),
                                           of_here = overlaps(along, there, here, -towards);
  add(here, of_here, 0);
  for (std::size_t k = 0; k < of_there.size(); ++k) add(there, of_there, k);
  add(here, of_here, of_here.size() - 1);
  // Places so near to each other tell the same, and a parabola through them nothing.
  const double least = found.empty() ? 0 : least_gap * (found.back().along - found.front().along);
  const auto last = std::unique(found.begin(), found.end(),
                                [&](const Overlap& a, const Overlap& b) { return b.along - a.along <= least; });
  found.erase(last, found.end());
  return found;
}

}  // namespace leadscrew::surfaces
