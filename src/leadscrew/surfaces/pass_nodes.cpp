#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/surfaces/hermite.hpp>
#include <leadscrew/surfaces/pass_nodes.hpp>
#include <limits>

namespace leadscrew::surfaces {

namespace {

using Why = PassFailure::Kind;

constexpr double axis_tolerance = 1e-9;  // radians
constexpr double draft_tolerance = 1e-2, square_of_draft_turn = 1e-6;
/// |Su × Sv| of |Su|·|Sv| below which there is no normal.
constexpr double least_cross = 1e-9;
/// Speed of the tip, of the contact's, below which it stands still.
constexpr double least_speed = 1e-6;
/// Steps where smooth parts of a line meet: of the tip, mm, beyond which there is an edge; of directions, radians, beyond which there
/// is a corner; and of derivatives, below which there is none.
constexpr double widest_leap = knot_tolerance, widest_axis_leap = 1e-7, widest_turn_at_knot = 1e-5, no_step = 1e-10;
/// Deepest halving of a smooth part of a line.
constexpr std::size_t most_halvings = 40;
constexpr std::size_t most_parts = 64;

/// A place of the line with derivatives by t.
struct Sample {
  double distance = 0;  // the line's parameter
  LinePlace place;
  VectorOf<Jet2> tip, axis, contact;
  double speed = 0, speed_rate = 0;  // dt by the line's parameter, and its derivative
  double tolerance = 0;              // 0: the machining's
};

/// f by t, from f by the line's parameter.
VectorOf<Jet2> by_length(const VectorOf<Jet2>& f, double speed, double rate) {
  VectorOf<Jet2> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double first = f[k][1] / speed;
    result[k].derivative = {f[k][0], first, (f[k][2] - first * rate) / (speed * speed)};
  }
  return result;
}

double dot_first(const VectorOf<Jet2>& a, std::size_t i, std::size_t j) {
  return a[0][i] * a[0][j] + a[1][i] * a[1][j] + a[2][i] * a[2][j];
}

/// How far apart two derivatives are.
double step_of(const VectorOf<Jet2>& a, const VectorOf<Jet2>& b, std::size_t order) {
  return numeric::hypot(a[0][order] - b[0][order], a[1][order] - b[1][order], a[2][order] - b[2][order]);
}

}  // namespace

/// A flat tool with no lean touches with all of its bottom: right on a plane, and where it follows a normal that it leaves nowhere.
std::optional<Contact> contact_at(PassLog& log, const LinePlace& place, const SurfaceJet& jet) {
  const Machining& machining = *log.machining;
  const double u = place.u.value, v = place.v.value;
  Contact contact{jet, {}, {}};
  const std::optional<Frame> frame = frame_of(contact.jet, machining.side);
  const bool has_normal =
      frame && frame->E * frame->G - frame->F * frame->F > least_cross * least_cross * frame->E * frame->G;
  if (!has_normal) {
    log.fail(Why::normal, u, v);
    return std::nullopt;
  }
  contact.frame = *frame;
  contact.bending = bending_at(machining, contact.jet, contact.frame, place);
  const Bending& bending = contact.bending;
  if (!log.least || bending.clearance < log.least->clearance) log.least = {bending.clearance, u, v, log.number};
  // Of the curvatures rounding leaves this much.
  const double rounding = 1e-11 * (1 / machining.cutter.radius + bending.greatest);
  if (bending.axis[2] < -1e-9) {
    log.fail(Why::overhang, u, v, bending.axis[2]);
  } else if (bending.clearance < -rounding && !machining.allows_gouging) {
    log.fail(Why::gouge, u, v, bending.clearance);
  } else if (!machining.cutter.is_ball() && machining.orientation.rule == Orientation::Rule::fixed &&
             numeric::hypot(bending.axis[0], bending.axis[1]) < 1e-6 && bending.greatest > 1e-9) {
    log.fail(Why::flat_contact, u, v);
  }
  return log.failure ? std::nullopt : std::optional(contact);
}

std::optional<Contact> contact_at(PassLog& log, const LinePlace& place) {
  return contact_at(log, place, log.machining->surface->jet_of_second_order(place.u.value, place.v.value));
}

namespace {

class LineOfNodes {
 public:
  LineOfNodes(PassLog& log, const Line& line) : log_(log), line_(line), breaks_(line.breaks(*log.machining->surface)) {}

  std::vector<Pass> parts() {
    std::optional<Sample> begin;
    for (std::size_t k = 0; k + 1 < breaks_.size() && !log_.failure; ++k) add_smooth_part(begin, k);
    end_part();
    return std::move(parts_);
  }

 private:
  Span span_after(std::size_t index) const;
  void add_smooth_part(std::optional<Sample>& begin, std::size_t index);
  void add_nodes(const Sample& begin, const Sample& end, const Span& span);
  bool join(Sample& before, Sample& after);
  std::optional<Sample> sample_at(const Span& span, double distance);
  bool is_close(const Sample& a, const Sample& m, const Sample& b, const Span& span, double length);
  bool is_close_at(const Sample& a, const Sample& b, double length, double share, const Vector& tip,
                   const Vector& axis) const;
  void begin_part(const Sample& sample, double t);
  void add_node(const Sample& sample, double t);
  void end_part();

  PassLog& log_;
  const Line& line_;
  std::vector<Pass> parts_;
  Pass part_;
  std::vector<double> breaks_;
  AcrossFunction::Memo memo_;
};

std::optional<Sample> LineOfNodes::sample_at(const Span& span, double distance) {
  Sample sample{distance, span.inside(line_.at_near(distance, memo_)), {}, {}, {}};
  const LinePlace& place = sample.place;
  const std::optional<Contact> contact =
      contact_at(log_, place, log_.machining->surface->jet(place.u.value, place.v.value));
  if (!contact) return std::nullopt;
  const Touch<Jet2> touch = touch_along(*log_.machining, contact->jet, sample.place);
  const double square = dot_first(touch.tip, 1, 1);
  if (!(square > least_speed * least_speed * dot_first(touch.contact, 1, 1)) || !std::isfinite(square)) {
    log_.fail(Why::cusp, sample.place.u.value, sample.place.v.value);
    return std::nullopt;
  }
  sample.speed = std::sqrt(square);
  sample.speed_rate = dot_first(touch.tip, 1, 2) / sample.speed;
  sample.tip = by_length(touch.tip, sample.speed, sample.speed_rate);
  sample.axis = by_length(touch.axis, sample.speed, sample.speed_rate);
  sample.contact = by_length(touch.contact, sample.speed, sample.speed_rate);
  return sample;
}

/// Is the curve between a and b at a share of the parameter where the tip and axis are?
bool LineOfNodes::is_close_at(const Sample& a, const Sample& b, double length, double share, const Vector& tip,
                              const Vector& axis) const {
  const double tolerance = std::max({log_.machining->tolerance, a.tolerance, b.tolerance});
  const double width = b.distance - a.distance;
  Jet2 begin, end;
  begin.derivative = {0, a.speed, a.speed_rate};
  end.derivative = {length, b.speed, b.speed_rate};
  const double x = hermite_value(begin, end, width, share) / length;
  double off = 0, turned = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double tip_off = hermite_value(a.tip[k], b.tip[k], length, x) - tip[k];
    const double axis_off = hermite_value(a.axis[k], b.axis[k], length, x) - axis[k];
    off += tip_off * tip_off;
    turned += axis_off * axis_off;
    size = std::max(size, std::abs(tip[k]));
  }
  if (log_.machining->is_draft) return off <= draft_tolerance * draft_tolerance && turned <= square_of_draft_turn;
  const double least = 16 * std::numeric_limits<double>::epsilon() * size;
  const double allowed = std::max(tolerance, least);
  const double allowed_turn = tolerance > log_.machining->tolerance ? 100 * axis_tolerance : axis_tolerance;
  return off <= allowed * allowed && turned <= allowed_turn * allowed_turn;
}

bool LineOfNodes::is_close(const Sample& a, const Sample& m, const Sample& b, const Span& span, double length) {
  Vector tip, axis;
  for (std::size_t k = 0; k < 3; ++k) {
    tip[k] = m.tip[k][0];
    axis[k] = m.axis[k][0];
  }
  if (!is_close_at(a, b, length, 0.5, tip, axis)) return false;
  for (const double share : {0.25, 0.75}) {
    const LinePlace place = span.inside(line_.at_near(a.distance + share * (b.distance - a.distance), memo_));
    const SurfaceJet jet = log_.machining->surface->jet_of_first_order(place.u.value, place.v.value);
    const Touch<double> touch = touch_at(*log_.machining, jet, place);
    if (!is_close_at(a, b, length, share, touch.tip, touch.axis)) return false;
  }
  return true;
}

/// Joins two smooth parts: both get the mean of both sides' derivatives, and are within knot_tolerance where these are not the same.
/// False where there is a corner or a failure.
bool LineOfNodes::join(Sample& before, Sample& after) {
  const auto step = [&](std::size_t order) {
    return std::max(step_of(before.tip, after.tip, order), step_of(before.axis, after.axis, order));
  };
  if (step_of(before.tip, after.tip, 0) > widest_leap || step_of(before.axis, after.axis, 0) > widest_axis_leap) {
    log_.fail(Why::edge, after.place.u.value, after.place.v.value);
    return false;
  }
  if (step(1) > widest_turn_at_knot) return false;
  if (std::max({step(0), step(1), step(2)}) > no_step) before.tolerance = after.tolerance = knot_tolerance;
  for (VectorOf<Jet2> Sample::* const member : {&Sample::tip, &Sample::axis, &Sample::contact}) {
    for (std::size_t k = 0; k < 3; ++k) {
      Jet2 &a = (before.*member)[k], &b = (after.*member)[k];
      for (std::size_t order = 0; order <= 2; ++order) a[order] = b[order] = (a[order] + b[order]) / 2;
    }
  }
  return true;
}

Span LineOfNodes::span_after(std::size_t index) const {
  return span_of(*log_.machining->surface, line_.at((breaks_[index] + breaks_[index + 1]) / 2));
}

/// From one break to the next; `begin` goes on as the sample behind.
void LineOfNodes::add_smooth_part(std::optional<Sample>& begin, std::size_t index) {
  const Span span = span_after(index);
  if (!begin) begin = sample_at(span, breaks_[index]);
  std::optional<Sample> end = sample_at(span, breaks_[index + 1]), next;
  if (!begin || !end) return;
  bool goes_on = false;
  if (index + 2 < breaks_.size()) {
    next = sample_at(span_after(index + 1), breaks_[index + 1]);
    if (!next) return;
    goes_on = join(*end, *next);
    if (log_.failure) return;
  }
  if (part_.nodes.empty()) begin_part(*begin, 0);
  add_nodes(*begin, *end, span);
  if (!goes_on) end_part();
  begin = next;
}

/// Depth first, from the beginning: what waits on the stack lies behind.
void LineOfNodes::add_nodes(const Sample& begin, const Sample& end, const Span& span) {
  Sample at = begin;
  std::vector<Sample> ahead = {end};
  while (!ahead.empty()) {
    const Sample& to = ahead.back();
    const double width = to.distance - at.distance;
    const std::optional<Sample> middle = sample_at(span, at.distance + width / 2);
    if (!middle) return;
    const double length =
        width * ((7 * (at.speed + to.speed) + 16 * middle->speed) / 30 + width * (at.speed_rate - to.speed_rate) / 60);
    if (length > 0 && is_close(at, *middle, to, span, length)) {
      if (part_.nodes.size() == most_nodes) {
        end_part();
        begin_part(at, 0);
      }
      add_node(to, part_.nodes.back().t + length);
      at = to;
      ahead.pop_back();
    } else if (ahead.size() == most_halvings || parts_.size() == most_parts) {
      log_.fail(Why::too_many, at.place.u.value, at.place.v.value, static_cast<double>(most_parts * most_nodes));
      return;
    } else {
      ahead.push_back(*middle);
    }
  }
}

void LineOfNodes::begin_part(const Sample& sample, double t) {
  part_ = Pass{{}, false, log_.number, (line_.along == Direction::u ? sample.place.v : sample.place.u).value};
  add_node(sample, t);
}

void LineOfNodes::add_node(const Sample& sample, double t) {
  part_.nodes.push_back({t, sample.tip, sample.axis, sample.contact, sample.place.u.value, sample.place.v.value});
}

void LineOfNodes::end_part() {
  if (part_.nodes.size() > 1) parts_.push_back(std::move(part_));
  part_ = Pass{};
}

}  // namespace

std::vector<Pass> passes_along(PassLog& log, const Line& line) {
  return LineOfNodes(log, line).parts();
}

}  // namespace leadscrew::surfaces
