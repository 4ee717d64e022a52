#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/results/part_map.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <limits>

namespace leadscrew::results {

namespace {

/// Chords along everything that is travelled at feed, of the tool's tip where moves are told of it.
template <class Take>
void each_chord(gcode::Reader reader, const Take& take) {
  toolpath::Builder builder;
  bool reading = true;
  while (reading) {
    gcode::Move move;
    reading = reader.next(move);
    move.is_of_tip = false;  // its coordinates are those that are drawn
    reading ? builder.push(move) : builder.finish();
    while (const auto element = builder.pop()) {
      const auto* piece = std::get_if<toolpath::Piece>(&*element);
      if (piece == nullptr || std::isinf(piece->feed)) continue;
      constexpr int chords_of_a_curve = 24;
      const toolpath::AxisPath axes = piece->axes();
      const int chords = axes.line() ? 1 : chords_of_a_curve;
      geometry::Point from = axes.start();
      for (int k = 1; k <= chords; ++k) {
        const geometry::Point to = axes.position(axes.length() * k / chords);
        take(from, to);
        from = to;
      }
    }
  }
}

}  // namespace

PartMap::PartMap(const std::function<gcode::Reader()>& reader, int columns, int rows)
    : columns_(std::max(columns, 1)), rows_(std::max(rows, 1)) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double left = infinity, right = -infinity, bottom = infinity, top = -infinity;
  each_chord(reader(), [&](const geometry::Point& from, const geometry::Point& to) {
    left = std::min({left, from[0], to[0]});
    right = std::max({right, from[0], to[0]});
    bottom = std::min({bottom, from[1], to[1]});
    top = std::max({top, from[1], to[1]});
  });
  ideal_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  visited_ = ideal_;
  if (!(left <= right)) return;
  unit_ = std::max({(right - left) / (2 * columns_ - 1), (top - bottom) / (4 * rows_ - 1), 1e-6});
  left_ = left;
  top_ = top;
  each_chord(reader(),
             [&](const geometry::Point& from, const geometry::Point& to) { draw(from[0], from[1], to[0], to[1]); });
}

PartMap::Dot PartMap::dot_at(double x, double y) const {
  const auto clamped = [](double value) { return static_cast<int>(std::clamp(std::round(value), -1.0, 1e6)); };
  return {clamped((x - left_) / unit_), clamped((top_ - y) / unit_)};
}

void PartMap::set(std::vector<std::uint8_t>& dots, Dot dot) const {
  if (dot.column < 0 || dot.row < 0 || dot.column >= 2 * columns_ || dot.row >= 4 * rows_) return;
  constexpr std::array<std::array<std::uint8_t, 2>, 4> bits = {{{1, 8}, {2, 16}, {4, 32}, {64, 128}}};
  const std::size_t cell = cell_at(dot.row / 4, dot.column / 2);
  dots[cell] |= bits[static_cast<std::size_t>(dot.row % 4)][static_cast<std::size_t>(dot.column % 2)];
}

void PartMap::draw(double x0, double y0, double x1, double y1) {
  const int steps = std::clamp(static_cast<int>(std::hypot(x1 - x0, y1 - y0) / unit_) + 1, 1, 4096);
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    set(ideal_, dot_at(x0 + share * (x1 - x0), y0 + share * (y1 - y0)));
  }
}

void PartMap::visit(const base::AxisVector& position) {
  set(visited_, dot_at(position[0], position[1]));
}

std::string PartMap::text(const std::function<std::string(bool, std::string_view)>& paint) const {
  std::string text;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::size_t cell = cell_at(row, column);
      const unsigned dots = ideal_[cell] | visited_[cell];
      // U+2800 … U+28FF in UTF-8.
      const std::string character = {'\xE2', static_cast<char>(0xA0 + (dots >> 6)),
                                     static_cast<char>(0x80 + (dots & 0x3F))};
      text += paint(visited_[cell] != 0, character);
    }
    text += "\033[K\n";
  }
  return text;
}

}  // namespace leadscrew::results
