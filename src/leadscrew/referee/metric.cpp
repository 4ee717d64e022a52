#include <leadscrew/referee/metric.hpp>

namespace leadscrew::referee {

Metric::Metric(const machine::Machine& machine, double per_degree) : per_degree_(per_degree) {
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    axes_[dimensions_] = axis;
    scale_[dimensions_] = base::is_rotary(axis) ? per_degree : 1;
    acceleration_[dimensions_] = machine.limits(axis).acceleration * scale_[dimensions_];
    jerk_[dimensions_] = machine.limits(axis).jerk * scale_[dimensions_];
    ++dimensions_;
  }
  coordinate_.fill(dimensions_);
  for (std::size_t i = 0; i < dimensions_; ++i) coordinate_[base::index(axes_[i])] = i;
}

Chord chord_between(const Metric& metric, const Point& from, const Point& to) {
  Chord chord;
  chord.from = from;
  for (std::size_t i = 0; i < metric.dimensions(); ++i) chord.along[i] = to[i] - from[i];
  chord.squared_length = metric.dot(chord.along, chord.along);
  return chord;
}

}  // namespace leadscrew::referee
