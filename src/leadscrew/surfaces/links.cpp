#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/hermite.hpp>
#include <leadscrew/surfaces/links.hpp>
#include <numbers>

namespace leadscrew::surfaces {

namespace {

/// Lifts that are tried, of the distance (near) or of the tool's radius (far).
constexpr std::array<double, 10> lifts = {0.5, 1, 2, 4, 8, 16, 32, 64, 128, 256};
/// Where links are checked, of the way from each end to the middle, or to where far ones fly.
constexpr std::array<double, 12> checked_shares = {0.02, 0.04, 0.07, 0.1, 0.14, 0.2, 0.27, 0.35, 0.45, 0.6, 0.8, 1.0};
/// Deeper than at the passes' own ends a link does not go, mm.
constexpr double clearance_tolerance = 1e-7;
/// Axes farther apart, radians, go by the middle of their great circle.
constexpr double widest_turn = std::numbers::pi / 3;
/// Nodes of a link whose axis turns: so close that axis and tip between them are this exact, radians and mm.
constexpr double link_axis_tolerance = 1e-8, link_tip_tolerance = 1e-7;
constexpr std::size_t most_link_nodes = 256;
/// A quintic of the length w that begins with the second derivative k swings out by k w²/58, and falls behind the parabola of its beginning
/// by 3/2 k/w: beyond this k w the end rises first.
constexpr double most_bend = 4;

Vector values_of(const VectorOf<Jet2>& jets) {
  return {jets[0][0], jets[1][0], jets[2][0]};
}
Vector rates_of(const VectorOf<Jet2>& jets) {
  return {jets[0][1], jets[1][1], jets[2][1]};
}
VectorOf<Jet2> straight(const Vector& place, const Vector& rate) {
  VectorOf<Jet2> jets;
  for (std::size_t k = 0; k < 3; ++k) jets[k].derivative = {place[k], rate[k], 0};
  return jets;
}

/// A quintic off the surface, by t from 0 to `width`.
struct Rise {
  double width = 0;  // mm
  VectorOf<Jet2> end;
};

/// From an end that is bent so much as a ball's is that is nearly as round as the surface: so short as the end's radius of curvature, half
/// ahead and half across in the plane of the axis, to where it is straight. None where the way on, `length`, is no longer, and where
/// the pass goes along the axis.
Rise rise_from(const VectorOf<Jet2>& centre, const Vector& axis, double length) {
  const double bend = numeric::hypot(centre[0][2], centre[1][2], centre[2][2]);
  if (!(bend * length > most_bend)) return {0, centre};
  const Vector rate = rates_of(centre);
  const double square = numeric::dot(rate, rate);
  const Vector off = square > 0 ? numeric::sum(axis, -numeric::dot(axis, rate) / square, rate) : axis;
  if (numeric::norm(off) < 0.1) return {0, centre};
  const Vector ahead = numeric::sum(rate, 1, kinematics::unit_vector(off));
  Vector direction;
  for (std::size_t k = 0; k < 3; ++k) direction[k] = 0.7 * ahead[k];
  return {1 / bend, straight(numeric::sum(values_of(centre), 0.6 / bend, ahead), direction)};
}

/// Gone the other way.
VectorOf<Jet2> reversed(VectorOf<Jet2> jets) {
  for (Jet2& jet : jets) jet[1] = -jet[1];
  return jets;
}

}  // namespace

VectorOf<Jet2> LinkMaker::Track::at(double place) const {
  std::size_t k = 0;
  while (k + 2 < t.size() && t[k + 1] <= place) ++k;
  const double width = t[k + 1] - t[k];
  VectorOf<Jet2> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = hermite_jet(jets[k][i], jets[k + 1][i], width, (place - t[k]) / width);
  return result;
}

LinkMaker::Ends LinkMaker::ends_of(const PassNode& from, const PassNode& to) const {
  Ends ends{&from, &to, from.tip, to.tip};
  const Jet2 r = machining_.cutter.corner_radius;
  for (std::size_t k = 0; k < 3; ++k) {
    ends.from_centre[k] = from.tip[k] + r * from.axis[k];
    ends.to_centre[k] = to.tip[k] + r * to.axis[k];
  }
  ends.distance = numeric::distance(values_of(ends.from_centre), values_of(ends.to_centre));
  ends.turn = kinematics::angle_between(values_of(from.axis), values_of(to.axis));
  return ends;
}

/// A course's beginning, the ends rising first where it needs to: `ends` become those that it goes between, for `length` at either.
LinkMaker::Course LinkMaker::begun_course(Ends& ends, double length) const {
  const Rise rise = rise_from(ends.from_centre, values_of(ends.from->axis), length);
  const Rise descent = rise_from(reversed(ends.to_centre), values_of(ends.to->axis), length);
  Course course;
  if (rise.width > 0) course.centre.add(0, ends.from_centre);
  course.rise = rise.width;
  course.descent = descent.width;
  ends.from_centre = rise.end;
  ends.to_centre = reversed(descent.end);
  course.centre.add(course.rise, ends.from_centre);
  return course;
}

void LinkMaker::end_course(const Ends& ends, const Ends& between, double t, Course& course) const {
  course.centre.add(t, between.to_centre);
  course.length = t + course.descent;
  if (course.descent > 0) course.centre.add(course.length, ends.to_centre);
  add_axis(ends, course);
}

/// The quintic from end to end, lifted in its middle by so much as 64 (x (1 − x))³ is: 24 is its second derivative there.
LinkMaker::Course LinkMaker::near_course(const Ends& ends, double lift) const {
  const double length = 2.5 * ends.distance + 2 * lift + machining_.cutter.corner_radius * ends.turn;
  Ends between = ends;
  Course course = begun_course(between, length / 2);
  const Vector up = kinematics::unit_vector(numeric::sum(values_of(ends.from->axis), 1, values_of(ends.to->axis)));
  VectorOf<Jet2> middle;
  for (std::size_t k = 0; k < 3; ++k) {
    middle[k] = hermite_jet(between.from_centre[k], between.to_centre[k], length, 0.5);
    middle[k][0] += lift * up[k];
    middle[k][2] -= 24 * lift * up[k] / (length * length);
  }
  course.swing_up = course.rise + length / 2;
  course.swing_down = course.descent + length / 2;
  course.centre.add(course.swing_up, middle);
  end_course(ends, between, course.rise + length, course);
  return course;
}

/// Lifted along each end's axis; straight between.
LinkMaker::Course LinkMaker::far_course(const Ends& ends, double lift) const {
  const double swing = 1.5 * lift;
  Ends between = ends;
  Course course = begun_course(between, swing);
  const Vector up_from = values_of(ends.from->axis), up_to = values_of(ends.to->axis);
  const Vector a = numeric::sum(values_of(between.from_centre), lift, up_from),
               b = numeric::sum(values_of(between.to_centre), lift, up_to);
  const double flight = numeric::distance(a, b);
  const Vector along = flight > 0 ? kinematics::unit_vector(numeric::difference(b, a)) : rates_of(ends.from_centre);
  course.swing_up = course.rise + swing;
  course.swing_down = course.descent + swing;
  course.centre.add(course.swing_up, straight(a, along));
  course.centre.add(course.swing_up + flight, straight(b, along));
  end_course(ends, between, course.swing_up + flight + swing, course);
  return course;
}

/// By the middle of the great circle at its own rate where the axes are far apart.
void LinkMaker::add_axis(const Ends& ends, Course& course) const {
  course.axis.add(0, ends.from->axis);
  if (ends.turn > widest_turn) {
    const kinematics::GreatCircle circle(values_of(ends.from->axis), values_of(ends.to->axis));
    const Vector middle = circle.at(0.5), ahead = kinematics::cross_product(circle.axis(), middle);
    const double rate = ends.turn / course.length;
    VectorOf<Jet2> jets;
    for (std::size_t k = 0; k < 3; ++k) jets[k].derivative = {middle[k], rate * ahead[k], -rate * rate * middle[k]};
    course.axis.add(course.length / 2, jets);
  }
  course.axis.add(course.length, ends.to->axis);
}

PassNode LinkMaker::node_at(const Course& course, double t) const {
  PassNode node;
  node.t = t;
  node.axis = unit_of(course.axis.at(t));
  node.tip = course.centre.at(t);
  const Jet2 r = machining_.cutter.corner_radius;
  for (std::size_t k = 0; k < 3; ++k) node.tip[k] = node.tip[k] - r * node.axis[k];
  return node;
}

ToolPose LinkMaker::pose_at(const Course& course, double t) const {
  const PassNode node = node_at(course, t);
  return {values_of(node.tip), values_of(node.axis)};
}

/// How much less clear than at its ends, mm, below 0 where it gouges. In flight the tool is that much above the surface that nothing
/// reaches up to it between places half a radius apart.
double LinkMaker::worst_clearance(const Course& course, const Ends& ends) const {
  const double radius = machining_.cutter.radius;
  const auto clearance = [&](double t, ToolClearance::Place& place, double enough) {
    place = clearance_->least(pose_at(course, t), place, enough);
    return place.distance;
  };
  ToolClearance::Place from{0, ends.from->u, ends.from->v}, to{0, ends.to->u, ends.to->v};
  const double at_ends = std::min({0.0, clearance(0, from, 0), clearance(course.length, to, 0)});
  double worst = std::numeric_limits<double>::infinity();
  const auto check = [&](double begin, double end, bool is_up) {
    for (const double share : checked_shares) {
      if (!(end > begin) || (worst < at_ends - clearance_tolerance && !machining_.allows_gouging)) return;
      const double way = begin + share * (end - begin);
      worst = std::min(worst, is_up ? clearance(way, from, 0) : clearance(course.length - way, to, 0));
    }
  };
  check(0, course.rise, true);
  check(course.rise, course.swing_up, true);
  check(0, course.descent, false);
  check(course.descent, course.swing_down, false);
  if (worst < at_ends - clearance_tolerance && !machining_.allows_gouging) return worst - at_ends;
  const double flight = course.length - course.swing_up - course.swing_down, margin = radius / 16;
  const double parts = std::min(std::ceil(2 * flight / radius), 256.0);
  for (int k = 1; k < parts; ++k) {
    const double free = clearance(course.swing_up + flight * k / parts, from, margin) - margin;
    if (free < 0 && !machining_.allows_gouging) return free;
    if (free < 0) worst = std::min(worst, at_ends + free);
  }
  return worst - at_ends;
}

/// The course's own nodes; where the axis turns, more, halved until tip and axis are exact between them.
std::vector<PassNode> LinkMaker::nodes_of(const Course& course, const Ends& ends) const {
  std::vector<double> ahead = course.centre.t;
  ahead.insert(ahead.end(), course.axis.t.begin(), course.axis.t.end());
  std::sort(ahead.begin(), ahead.end(), std::greater<>());
  ahead.erase(std::unique(ahead.begin(), ahead.end()), ahead.end());
  ahead.pop_back();
  std::vector<PassNode> nodes = {*ends.from};
  nodes.front().t = 0;
  const bool turns = machining_.orientation.rule != Orientation::Rule::fixed;
  while (!ahead.empty()) {
    const PassNode& a = nodes.back();
    PassNode b = ahead.back() == course.length ? *ends.to : node_at(course, ahead.back());
    b.t = ahead.back();
    const double width = b.t - a.t;
    const PassNode middle = node_at(course, a.t + width / 2);
    double off = 0, turned = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      off = std::max(off, std::abs(hermite_value(a.tip[k], b.tip[k], width, 0.5) - middle.tip[k][0]));
      turned = std::max(turned, std::abs(hermite_value(a.axis[k], b.axis[k], width, 0.5) - middle.axis[k][0]));
    }
    const double loose = machining_.is_draft ? 1e5 : 1;
    const bool is_close = off <= loose * link_tip_tolerance && turned <= loose * link_axis_tolerance;
    if (turns && !is_close && nodes.size() + ahead.size() < most_link_nodes) {
      ahead.push_back(middle.t);
    } else {
      nodes.push_back(b);
      ahead.pop_back();
    }
  }
  for (PassNode& node : nodes) {
    const double share = node.t / course.length;
    node.u = ends.from->u + share * (ends.to->u - ends.from->u);
    node.v = ends.from->v + share * (ends.to->v - ends.from->v);
  }
  return nodes;
}

std::optional<Pass> LinkMaker::between(PassLog& log, const PassNode& from, const PassNode& to) {
  if (!clearance_ && !machining_.is_draft) clearance_.emplace(*machining_.surface, machining_.cutter);
  const Ends ends = ends_of(from, to);
  double worst = -std::numeric_limits<double>::infinity();
  std::optional<Course> deepens_least;
  if (ends.turn < std::numbers::pi - 1e-3) {
    for (const bool is_far : {false, true}) {
      if (!is_far && ends.distance > 4 * machining_.cutter.radius) continue;
      // From a lift less than the last that was clear: what is asked for changes little from link to link.
      std::size_t& last = last_lift_[is_far ? 1 : 0];
      for (std::size_t k = last > 0 ? last - 1 : 0; k < lifts.size(); ++k) {
        const double lift = lifts[k] * (is_far ? machining_.cutter.radius : ends.distance);
        if (!is_far && lift > 2 * machining_.cutter.radius + ends.distance) break;
        const Course course = is_far ? far_course(ends, lift) : near_course(ends, lift);
        const double clearance = machining_.is_draft ? 0 : worst_clearance(course, ends);
        if (clearance > worst && clearance < -clearance_tolerance && machining_.allows_gouging) deepens_least = course;
        worst = std::max(worst, clearance);
        if (clearance < -clearance_tolerance) continue;
        last = k;
        Pass link{nodes_of(course, ends), true, log.number};
        return link;
      }
    }
  }
  if (deepens_least) return Pass{nodes_of(*deepens_least, ends), true, log.number};
  log.fail(PassFailure::Kind::link, from.u, from.v, worst);
  return std::nullopt;
}

}  // namespace leadscrew::surfaces
