// The butterfly by arc length.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/butterfly.hpp>
#include <leadscrew/study/studies.hpp>
#include <utility>
#include <vector>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_butterfly {

const Rows& rows() {
  static const Rows rows = butterfly_rows({});
  return rows;
}

constexpr const char* curve = "butterfly, the curve";

/// C(u) in X and Y by the definition of the basis functions (Piegl and Tiller, eq. 2.5), in extended precision.
struct Place {
  long double x, y;
};
long double basis(const std::vector<double>& knots, std::size_t i, int degree, long double u) {
  if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  const std::size_t p = static_cast<std::size_t>(degree);
  long double sum = 0;
  if (knots[i + p] > knots[i]) sum += (u - knots[i]) / (knots[i + p] - knots[i]) * basis(knots, i, degree - 1, u);
  if (knots[i + p + 1] > knots[i + 1])
    sum += (knots[i + p + 1] - u) / (knots[i + p + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, u);
  return sum;
}
Place place(const geometry::NurbsForm& form, long double u) {
  long double x = 0, y = 0, w = 0;
  for (std::size_t i = 0; i < form.points.size(); ++i) {
    const long double share = form.weights[i] * basis(form.knots, i, form.degree, u);
    x += share * form.points[i][0];
    y += share * form.points[i][1];
    w += share;
  }
  return {x / w, y / w};
}

// Sums of chords fall short by a multiple of h², which Richardson's extrapolation takes away.
TEST(ButterflyCurve, HasTheLengthOfItsChords) {
  const geometry::NurbsForm form = butterfly();
  const auto chords = [&](int parts) {
    long double sum = 0;
    for (std::size_t k = 3; k + 4 < form.knots.size(); ++k) {
      const long double begin = form.knots[k], step = (form.knots[k + 1] - begin) / parts;
      Place last = place(form, begin);
      for (int i = 1; i <= parts; ++i) {
        // The last knot itself belongs to no basis function.
        const Place next = place(form, std::min(begin + i * step, 1 - 1e-18L));
        sum += std::hypot(next.x - last.x, next.y - last.y);
        last = next;
      }
    }
    return sum;
  };
  const long double coarse = chords(100), fine = chords(200);
  const auto length = static_cast<double>(fine + (fine - coarse) / 3);
  EXPECT_NEAR(ours(rows(), curve, "length"), length, 1e-4);
  EXPECT_NEAR(length, butterfly_length, 1e-4);
}

TEST(ButterflyCurve, HasTheReferenceLengthAndSharpestBend) {
  EXPECT_EQ(verdict(rows(), curve, "length"), "exact");
  EXPECT_EQ(verdict(rows(), curve, "smallest radius of curvature"), "exact");
}

TEST(ButterflyStudy, TakesNoFigureFromThePapers) {
  expect_none_published(rows());
}

TEST(ButterflyMap, KeepsTheSpeedFluctuationItWasMadeFor) {
  for (const auto& [bound, ppm] : {std::pair("1e-4", 100.0), {"1e-5", 10.0}, {"1e-6", 1.0}}) {
    const Row row = found(rows(), curve, std::string("measured for speed fluctuation below ") + bound);
    EXPECT_LE(row.ours.value_or(NAN), ppm);
    EXPECT_GT(row.ours.value_or(NAN), 0.1 * ppm);
    EXPECT_EQ(row.verdict, Verdict::kept);
  }
}

TEST(ButterflyMap, GetsFinerWithTheFluctuationAsked) {
  const auto pieces = [](const char* bound) {
    return ours(rows(), curve, std::string("pieces of the map for speed fluctuation below ") + bound);
  };
  EXPECT_GE(pieces("1e-4"), 2 * 48);  // two for each knot span at least
  EXPECT_LT(pieces("1e-4"), pieces("1e-5"));
  EXPECT_LT(pieces("1e-5"), pieces("1e-6"));
}

/// The least time without a limit of jerk by a recursion over knots dense in u (Bobrow et al. 1985), x = v² from knot
/// to knot: backwards the most that can still be braked, forwards the most that can be reached. v ≤ F and 200 mm/s an
/// axis.
class DenseBound {
 public:
  explicit DenseBound(int knots_per_span) {
    const geometry::NurbsForm form = butterfly();
    const geometry::Nurbs insect = geometry::smooth_pieces(form).front();
    std::vector<double> parameters;
    for (std::size_t k = 3; k + 4 < form.knots.size(); ++k) {
      for (int i = 0; i < knots_per_span; ++i)
        parameters.push_back(form.knots[k] + (form.knots[k + 1] - form.knots[k]) * i / knots_per_span);
    }
    parameters.push_back(1);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const geometry::PointJet here = insect.jets_at(parameters[i]);
      const double vx = here[0].first, vy = here[1].first, v = std::hypot(vx, vy);
      const double along = (vx * here[0].second + vy * here[1].second) / (v * v);
      Knot knot{
          {vx / v, vy / v}, {(here[0].second - vx * along) / (v * v), (here[1].second - vy * along) / (v * v)}, 0};
      if (i + 1 < parameters.size()) {
        const double step = parameters[i + 1] - parameters[i];
        const auto speed = [&](double u) {
          const geometry::PointJet jet = insect.jets_at(u);
          return std::hypot(jet[0].first, jet[1].first);
        };
        knot.step = (v + 4 * speed(parameters[i] + step / 2) + speed(parameters[i + 1])) / 6 * step;  // Simpson
      }
      knots_.push_back(knot);
    }
  }

  double seconds(double feed, double acceleration) const {
    std::vector<double> reach(knots_.size());
    for (std::size_t i = knots_.size() - 1; i-- > 0;) {
      double lower = 0, upper = greatest(knots_[i], feed);
      const auto passes = [&](double x) {
        const auto [least, most] = accelerations(knots_[i], x, acceleration);
        return least <= most && x + 2 * knots_[i].step * least <= reach[i + 1];
      };
      for (int halving = 0; halving < 50 && !passes(upper); ++halving) {
        const double middle = (lower + upper) / 2;
        (passes(middle) ? lower : upper) = middle;
      }
      reach[i] = passes(upper) ? upper : lower;
    }
    double x = 0, time = 0;
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      const double next =
          std::min(reach[i + 1], x + 2 * knots_[i].step * accelerations(knots_[i], x, acceleration).second);
      time += 2 * knots_[i].step / (std::sqrt(x) + std::sqrt(next));
      x = next;
    }
    return time;
  }

 private:
  struct Knot {
    double tangent[2], bend[2];  ///< q′, q″ by arc length
    double step;                 ///< arc length to the next
  };

  static double greatest(const Knot& knot, double feed) {
    double x = feed * feed;
    for (const double rate : knot.tangent) {
      if (rate != 0) x = std::min(x, 200 * 200 / (rate * rate));
    }
    return x;
  }
  /// The s̈ that keep |q″x + q′ s̈| ≤ a; least above most where none does.
  static std::pair<double, double> accelerations(const Knot& knot, double x, double a) {
    double least = -1e30, most = 1e30;
    for (int k = 0; k < 2; ++k) {
      const double rate = knot.tangent[k], centripetal = knot.bend[k] * x;
      if (std::abs(rate) < 1e-12) {
        if (std::abs(centripetal) > a) return {1, -1};
        continue;
      }
      const double one = (-a - centripetal) / rate, other = (a - centripetal) / rate;
      least = std::max(least, std::min(one, other));
      most = std::min(most, std::max(one, other));
    }
    return {least, most};
  }

  std::vector<Knot> knots_;
};

struct ButterflyRun {
  const char* group;
  double feed, acceleration;
};
class ButterflyTime : public ::testing::TestWithParam<ButterflyRun> {};

TEST_P(ButterflyTime, IsAboveTheLeastTimeWithoutALimitOfJerk) {
  static const DenseBound dense(500);
  const auto& [group, feed, acceleration] = GetParam();
  const double least = dense.seconds(feed, acceleration);
  EXPECT_NEAR(ours(rows(), group, "least time without a limit of jerk"), least, 3e-4 * least);
  EXPECT_GT(ours(rows(), group, "time"), least);
}

TEST_P(ButterflyTime, NothingIsFasterThanTheOptimum) {
  EXPECT_GT(ours(rows(), GetParam().group, "time over optimum"), 0.998);
}

INSTANTIATE_TEST_SUITE_P(Published, ButterflyTime,
                         ::testing::Values(ButterflyRun{"butterfly, F 10 mm/s, a 1000 mm/s², j 20000 mm/s³", 10, 1000},
                                           ButterflyRun{"butterfly, F 100 mm/s, a 1000 mm/s², j 20000 mm/s³", 100,
                                                        1000},
                                           ButterflyRun{"butterfly, F 10 mm/s, a 200 mm/s², j 5000 mm/s³", 10, 200},
                                           ButterflyRun{"butterfly, F 100 mm/s, a 200 mm/s², j 5000 mm/s³", 100, 200}),
                         [](const auto& run) {
                           return "F" + std::to_string(static_cast<int>(run.param.feed)) + "A" +
                                  std::to_string(static_cast<int>(run.param.acceleration));
                         });

}  // namespace test_butterfly
}  // namespace leadscrew::study::testing
