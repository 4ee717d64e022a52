#pragma once
// A line whose parameter across is a uniform B-spline of degree 5 of the one along: so smooth that the tip has its curvature.

#include <leadscrew/surfaces/line.hpp>
#include <utility>
#include <vector>

namespace leadscrew::surfaces {

/// A uniform B-spline of degree 5 over a range of the parameter along: `spans` + 5 coefficients, all of the same value at first.
class UniformSpline : public AcrossFunction {
 public:
  UniformSpline(const Range& range, std::size_t spans, double value)
      : range_(range), spans_(spans), coefficients_(spans + 5, value) {}

  numeric::Jet<3> at(double place) const override;
  numeric::Jet<3> at_near(double place, Memo& memo) const override;
  std::vector<double> breaks(double from, double to) const override;
  std::size_t bytes() const override {
    return sizeof *this + sizeof(double) * (coefficients_.capacity() + across_breaks_.capacity());
  }
  /// Where the surface has breaks across: crossings of them are breaks too.
  void cross(std::vector<double> across_breaks) { across_breaks_ = std::move(across_breaks); }

  std::size_t spans() const { return spans_; }
  std::vector<double>& coefficients() { return coefficients_; }
  const std::vector<double>& coefficients() const { return coefficients_; }
  double knot(double index) const {
    return range_.from + (range_.to - range_.from) * index / static_cast<double>(spans_);
  }

 private:
  Range range_;
  std::size_t spans_;
  std::vector<double> coefficients_;
  std::vector<double> across_breaks_;
};

/// That is no more than wanted, > 0, at any sample, of which each span has as many as `per_span`.
UniformSpline spline_below(const Range& range, std::size_t spans, std::size_t per_span,
                           const std::vector<double>& wanted);

}  // namespace leadscrew::surfaces
