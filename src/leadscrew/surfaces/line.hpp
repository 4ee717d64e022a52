#pragma once
// Lines of a surface's parameters that passes follow: the parameter across is a function of the one along.

#include <array>
#include <leadscrew/surfaces/touch.hpp>
#include <limits>
#include <memory>
#include <vector>

namespace leadscrew::surfaces {

/// A place by the parameter along, which is gone up (1) or down (−1), and the one across, told by the one along: derivatives of the
/// result are by the distance gone.
LinePlace line_place(Direction along, double place, double direction, const numeric::Jet<3>& across);

/// The parameter across, with three derivatives by the one along.
class AcrossFunction {
 public:
  virtual ~AcrossFunction() = default;
  /// Within the range it was made for.
  virtual numeric::Jet<3> at(double along) const = 0;
  /// The polynomial that was needed last, kept by whoever asks for one place after another of one function.
  struct Memo {
    std::size_t span = std::numeric_limits<std::size_t>::max();
    std::array<double, 6> polynomial{};
  };
  virtual numeric::Jet<3> at_near(double along, Memo& /*memo*/) const { return at(along); }
  /// Places inside (from, to), ascending, where a derivative has a step.
  virtual std::vector<double> breaks(double from, double to) const = 0;
  /// Of memory, held by this one alone, itself included.
  virtual std::size_t bytes() const = 0;
};

/// A part of a line between two places of the parameter along, gone from `from` to `to`, which may be the lesser.
struct Line {
  Direction along = Direction::u;
  double from = 0, to = 0;
  double across = 0;                               ///< all along it, unless
  std::shared_ptr<const AcrossFunction> function;  ///< this tells

  bool is_forward() const { return from < to; }
  double length() const { return std::abs(to - from); }
  /// At a distance of the parameter along from the beginning; derivatives are by that distance.
  LinePlace at(double distance) const;
  LinePlace at_near(double distance, AcrossFunction::Memo& memo) const;
  /// Distances, ascending, both ends among them, between which a surface is smooth along the line.
  std::vector<double> breaks(const Surface& surface) const;
};

/// A polynomial span of the surface, in parameters: places at its border are taken as inside, so that derivatives are its own.
struct Span {
  Range u, v;

  LinePlace inside(LinePlace place) const;
};
/// The one that holds a place.
Span span_of(const Surface& surface, const LinePlace& place);

}  // namespace leadscrew::surfaces
