// Curves turned and shifted: a line stays a line, an arc an arc, and of a NURBS curve each polynomial is turned.

#include <algorithm>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/geometry/nurbs_table.hpp>
#include <span>

namespace leadscrew::geometry {

using numeric::DoubleDouble;

namespace {

/// The coordinate along which a unit vector along `coordinate` points when it is turned, or 3.
std::size_t turned_coordinate(const RigidMotion& motion, std::size_t coordinate) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (motion.rotation[(i + 1) % 3][coordinate] == 0 && motion.rotation[(i + 2) % 3][coordinate] == 0) return i;
  }
  return 3;
}

std::optional<Curve> moved_arc(const Arc& arc, const RigidMotion& motion) {
  const Point start = motion.place(arc.start()), end = motion.place(arc.end());
  const std::size_t first = arc.first(), second = arc.second();
  const DoubleDouble sweep = arc.sweep();
  Point center = arc.start();
  center[first] = arc.turn().center_first;
  center[second] = arc.turn().center_second;
  if (first >= 3 && second >= 3)
    return Arc(start, end, first, second, center[first], center[second], sweep, arc.length());
  if (first >= 3 || second >= 3) return std::nullopt;
  const std::size_t normal = 3 - first - second, turned = turned_coordinate(motion, normal);
  if (turned == 3) return std::nullopt;
  const bool is_turned_over = ((first + 1) % 3 == second) != (motion.rotation[turned][normal] > 0);
  const std::size_t new_first = (turned + 1) % 3, new_second = (turned + 2) % 3;
  center = motion.place(center);
  return Arc(start, end, new_first, new_second, center[new_first], center[new_second], is_turned_over ? -sweep : sweep,
             arc.length());
}

base::AxisSet moved_axes(base::AxisSet moving, const RigidMotion& motion) {
  base::AxisSet moved;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const auto follows = [&](std::size_t j) {
      return motion.rotation[i][j] != 0 && moving.contains(base::all_axes[j]);
    };
    if (i < 3 ? follows(0) || follows(1) || follows(2) : moving.contains(axis)) moved.insert(axis);
  }
  return moved;
}

/// Where the numbers of each coordinate stand in a record; behind its end: nowhere.
std::array<std::size_t, base::axis_count> columns_of(const NurbsTable& table) {
  std::array<std::size_t, base::axis_count> columns;
  columns.fill(table.stride);
  const std::size_t per_coordinate = table.degree + 2;
  for (std::size_t k = 0; k < table.moving_count; ++k)
    columns[table.moving[k]] = table.stride - (table.moving_count - k) * per_coordinate;
  return columns;
}

/// One record's polynomials of the coordinates that `to` has.
void add_turned(const NurbsTable& from, const double* record, const Point& start, const RigidMotion& motion,
                NurbsTable& to) {
  const auto columns = columns_of(from);
  Point origin = start;
  for (std::size_t i = 0; i < origin.size(); ++i) {
    if (columns[i] < from.stride) origin[i] = record[columns[i]];
  }
  origin = motion.place(origin);
  for (std::size_t k = 0; k < to.moving_count; ++k) {
    const std::size_t i = to.moving[k];
    to.records.push_back(origin[i]);
    for (std::size_t power = 1; power <= from.degree + 1; ++power) {
      double sum = i < 3 ? 0 : record[columns[i] + power];
      for (std::size_t j = 0; i < 3 && j < 3; ++j) {
        if (columns[j] < from.stride) sum += motion.rotation[i][j] * record[columns[j] + power];
      }
      to.records.push_back(sum);
    }
  }
}

}  // namespace

Nurbs Nurbs::moved(const RigidMotion& motion) const {
  const NurbsTable& from = *table_;
  const auto table = std::make_shared<NurbsTable>();
  table->degree = from.degree;
  table->rational = from.rational;
  table->weights = from.weights;
  base::AxisSet in_table;
  for (std::size_t k = 0; k < from.moving_count; ++k) in_table.insert(base::all_axes[from.moving[k]]);
  const base::AxisSet in_moved = moved_axes(in_table, motion);
  for (const base::Axis axis : base::all_axes) {
    if (in_moved.contains(axis)) table->moving[table->moving_count++] = static_cast<std::uint8_t>(base::index(axis));
  }
  const std::size_t kept = NurbsTable::polynomials + (from.rational ? from.degree : 0);
  table->stride = kept + table->moving_count * (from.degree + 2);
  for (std::size_t record = first_record_; record < first_record_ + record_count_; ++record) {
    const double* const numbers = from.record(record);
    table->nodes.push_back(from.nodes[record]);
    table->records.insert(table->records.end(), numbers, numbers + kept);
    add_turned(from, numbers, start_, motion, *table);
  }
  const std::span<const double> jumps = breaks();
  table->breaks.assign(jumps.begin(), jumps.end());

  Nurbs moved = *this;
  moved.first_record_ = moved.first_break_ = 0;
  moved.moving_ = moved_axes(moving_, motion);
  moved.start_ = motion.place(start_);
  moved.end_ = motion.place(end_);
  moved.add_buckets(*table);
  moved.table_ = table;
  return moved;
}

std::optional<Curve> moved(const Curve& curve, const RigidMotion& motion) {
  if (const auto* arc = std::get_if<Arc>(&curve)) return moved_arc(*arc, motion);
  if (const auto* nurbs = std::get_if<Nurbs>(&curve)) return nurbs->moved(motion);
  const Line& line = *std::get_if<Line>(&curve);
  return Line(motion.place(line.start()), motion.place(line.end()), line.length());
}

}  // namespace leadscrew::geometry
