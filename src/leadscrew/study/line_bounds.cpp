#include <leadscrew/pulse/linear.hpp>
#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/lattice_path.hpp>

namespace leadscrew::study {

namespace {

using pulse::LinearDda;
using pulse::Point;
using pulse::Preload;

struct Found {
  double error = 0;            ///< BLU
  double beside = 0;           ///< clocks, beside what they ought to be
  std::int64_t not_ended = 0;  ///< lines
};

void add(Found& to, const Found& found) {
  to.error = std::max(to.error, found.error);
  to.beside = std::max(to.beside, found.beside);
  to.not_ended += found.not_ended;
}

template <pulse::Interpolator State>
Found found_by(State state, Point delta, double expected_clocks) {
  const LatticePath path = follow_line(std::move(state), delta);
  return {line_error(path, delta), std::abs(static_cast<double>(path.clocks) - expected_clocks), !path.ends};
}

double length(Point delta) {
  return std::hypot(static_cast<double>(delta.x), static_cast<double>(delta.y));
}

enum class Rounded : std::uint8_t { up, nearest, down };

template <Rounded rounded, Preload preload>
Found by_length(Point delta) {
  const double exact = length(delta);
  const double capacity = rounded == Rounded::up        ? std::ceil(exact)
                          : rounded == Rounded::nearest ? std::round(exact)
                                                        : std::floor(exact);
  return found_by(LinearDda<2>({delta.x, delta.y}, static_cast<std::int64_t>(capacity), preload), delta, exact);
}

/// In every register of up to 8 bits that holds the line. Its last pulse may come before clock 2ⁿ, never after it.
template <Preload preload>
Found by_bits(Point delta) {
  Found all;
  for (int bits = 1; bits <= 8; ++bits) {
    const std::int64_t capacity = std::int64_t{1} << bits;
    if (std::max(delta.x, delta.y) >= capacity) continue;
    Found found = found_by(LinearDda<2>({delta.x, delta.y}, capacity, preload), delta, 0);
    found.beside = std::max(0.0, found.beside - static_cast<double>(capacity));
    add(all, found);
  }
  return all;
}

Found by_point_comparison(Point delta) {
  return found_by(pulse::LinearPointComparison<2>({delta.x, delta.y}), delta, static_cast<double>(delta.x + delta.y));
}
Found by_bresenham(Point delta) {
  return found_by(pulse::LinearBresenham(delta), delta, static_cast<double>(std::max(delta.x, delta.y)));
}

struct Method {
  const char* name;
  Found (*of)(Point);
  std::int64_t reach;  ///< greatest coordinate of the lines
  double bound;        ///< BLU; 0 where none was told
  const char* clocks;  ///< what they are beside
  double clocks_bound;
};

constexpr const char* line_length = "L";
constexpr std::array<Method, 10> methods = {{
    {"DDA, q = L rounded up, empty", by_length<Rounded::up, Preload::none>, 120, 0.992, line_length, 1},
    {"DDA, q = L rounded up, half", by_length<Rounded::up, Preload::half>, 120, 0.702, line_length, 1},
    {"DDA, q = L rounded, empty", by_length<Rounded::nearest, Preload::none>, 120, 0.992, line_length, 1},
    {"DDA, q = L rounded, half", by_length<Rounded::nearest, Preload::half>, 120, 0.702, line_length, 1},
    {"DDA, q = L rounded down, empty", by_length<Rounded::down, Preload::none>, 120, 0.992, line_length, 1},
    {"DDA, q = L rounded down, half", by_length<Rounded::down, Preload::half>, 120, 0.702, line_length, 1},
    {"DDA of 1 … 8 bits, empty", by_bits<Preload::none>, 255, 0.996, "2ⁿ, beyond it", 0},
    {"DDA of 1 … 8 bits, half", by_bits<Preload::half>, 255, 0.704, "2ⁿ, beyond it", 0},
    {"point comparison", by_point_comparison, 256, 0, "a + b", 0},
    {"Bresenham", by_bresenham, 256, 0, "max(a, b)", 0},
}};

Rows rows_of(const Method& method, const Found& found) {
  const std::string what = "greatest error to a, b = " + std::to_string(method.reach);
  Row error = method.bound > 0 ? limit_row(what, {"BLU", 3}, method.bound, found.error, 5e-4)
                               : measured_row(what, {"BLU", 4}, found.error);
  if (method.bound == 0) error.why = "the table of bounds has none";
  return under(
      std::string("lines, ") + method.name,
      {std::move(error),
       limit_row(std::string("clocks, farthest from ") + method.clocks, {"", 3}, method.clocks_bound, found.beside),
       limit_row("lines that do not end at their end", {"", 0}, 0, static_cast<double>(found.not_ended))});
}

}  // namespace

Rows line_bounds(const Host& host) {
  constexpr std::int64_t reach = 256;
  std::vector<Found> found(methods.size() * (reach + 1));
  share_out(host, found.size(), [&](std::size_t i) {
    const Method& method = methods[i / (reach + 1)];
    const auto a = static_cast<std::int64_t>(i % (reach + 1));
    for (std::int64_t b = a == 0 ? 1 : 0; a <= method.reach && b <= method.reach; ++b) add(found[i], method.of({a, b}));
  });
  Rows rows;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    Found all;
    for (std::size_t a = 0; a <= reach; ++a) add(all, found[m * (reach + 1) + a]);
    append(rows, rows_of(methods[m], all));
  }
  return rows;
}

}  // namespace leadscrew::study
