#pragma once
// One line or one arc, of a circle or of an ellipse, on the lattice of steps, as it is asked for: before any register is
// loaded.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/pulse/elliptic_dda.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::nc {

/// Coordinates in BLU. An arc whose end is where it starts is a full circle.
struct PulseCurve {
  enum class Shape : std::uint8_t { line, arc };

  Shape shape = Shape::line;
  pulse::Point start, end;
  pulse::Point center;                                              ///< of an arc
  pulse::Direction direction = pulse::Direction::counterclockwise;  ///< of an arc
  std::optional<pulse::SemiAxes> semi_axes{};                       ///< of an arc of an ellipse, along X and Y

  bool is_arc() const { return shape == Shape::arc; }
  bool is_ellipse() const { return is_arc() && semi_axes.has_value(); }
  /// Where the interpolator's own coordinates begin: the centre of an arc, the start of a line.
  pulse::Point origin() const { return is_arc() ? center : start; }
  /// The arc about the origin.
  pulse::Arc arc() const;
  /// The line's end from its start.
  pulse::Point delta() const;
  double radius() const;  ///< of an arc of a circle, BLU
};

/// (x, y)
std::string point_text(pulse::Point at);

/// What no interpolator could do: a line of length 0, an arc of radius 0, an end off the circle by more than half a
/// BLU, a semi-axis that is not more than 0, a start or an end off the ellipse by more than half a BLU, a coordinate that
/// the registers do not hold: 2ⁿ − 1 is the greatest of n `bits`, pulse::greatest_coordinate without. Codes: `no-way`,
/// `zero-radius`, `end-off-circle`, `off-ellipse`, `register-overflow`. Empty where all is well. Each says of which field
/// it is, "start", "end", "center", "semi_axes" or "bits", and of which coordinate.
std::vector<base::Diagnostic> problems_of(const PulseCurve& curve, std::optional<int> bits);

struct RegisterContent {
  const char* name;
  std::int64_t value;
  std::string meaning;  ///< in words
};

/// `register-overflow` where a register of so many bits does not hold it; without bits it is as wide as the
/// interpolators can have it.
std::optional<base::Diagnostic> overflow_of(const RegisterContent& content, std::optional<int> bits);

/// The same diagnostic of a value, in digits, that no register holds however wide.
base::Diagnostic overflow_beyond(std::string_view name, std::string_view meaning, std::string_view value);

/// How far places are from a curve.
class PulseError {
 public:
  explicit PulseError(const PulseCurve& curve);

  /// Of a place, BLU: across an arc, > 0 outside; across a line, > 0 to its left.
  double operator()(pulse::Point at) const;

 private:
  PulseCurve curve_;
  pulse::Point delta_;
  std::int64_t square_;  ///< of the radius or the length
  double root_;
};

}  // namespace leadscrew::nc
