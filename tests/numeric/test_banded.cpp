#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/banded.hpp>
#include <limits>
#include <vector>

namespace test_banded {

using leadscrew::numeric::BandedMatrix;
using Dense = std::vector<std::vector<long double>>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double uniform() {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-1000000, 1000001)) / 1e6;
}

/// Gauss, with the greatest pivot of each column.
std::vector<long double> solve_dense(Dense a, std::vector<long double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const long double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// The same matrix banded and dense, element by element as it was added up.
template <std::size_t half_bandwidth>
struct Both {
  BandedMatrix<half_bandwidth> banded;
  Dense dense;

  explicit Both(std::size_t n) : dense(n, std::vector<long double>(n, 0)) { banded.reset(n); }
  /// As rows of limits do it: w p pᵀ, p in neighbours from `at` on.
  void add_outer(std::size_t at, const std::vector<double>& p, double w) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const double value = w * p[i] * p[j];
        // Either triangle may be named.
        (i + j) % 2 == 0 ? banded.add(at + i, at + j, value) : banded.add(at + j, at + i, value);
        dense[at + i][at + j] += value;
        if (i != j) dense[at + j][at + i] += value;
      }
    }
  }
};

/// Positive definite: a sum of squares over windows as wide as the band, and a share of the unit matrix.
template <std::size_t half_bandwidth>
Both<half_bandwidth> random_matrix(std::size_t n, double definite) {
  Both<half_bandwidth> both(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double scale = std::pow(10.0, 3 * uniform());
    std::vector<double> p(std::min<std::size_t>(half_bandwidth + 1, n - i), 1.0);
    if (*rc::gen::arbitrary<bool>()) std::generate(p.begin(), p.end(), uniform);
    both.add_outer(i, p, scale);
    both.add_outer(i, {1}, definite * scale);
  }
  return both;
}

long double norm(const std::vector<long double>& v) {
  long double greatest = 0;
  for (const long double x : v) greatest = std::max(greatest, std::abs(x));
  return greatest;
}

template <std::size_t half_bandwidth>
void expect_the_dense_solution() {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 40));
  auto both = random_matrix<half_bandwidth>(n, 0.1);
  std::vector<double> b(n);
  for (double& x : b) x = uniform();
  const std::vector<long double> exact = solve_dense(both.dense, {b.begin(), b.end()});
  both.banded.factor(1e-13);
  std::vector<double> found = b;
  both.banded.solve(found);
  // What is asked of a stable elimination (Golub and Van Loan, 4.2.7): the residual is a few roundings of |A||x|,
  // whatever the condition.
  for (std::size_t i = 0; i < n; ++i) {
    long double residual = b[i], size = 0;
    for (std::size_t j = 0; j < n; ++j) {
      residual -= both.dense[i][j] * found[j];
      size += std::sqrt(both.dense[i][i] * both.dense[j][j]) * std::abs(found[j]);
    }
    RC_ASSERT(std::abs(residual) <= 30 * epsilon * (size + std::abs(b[i])));
  }
  long double apart = 0;
  for (std::size_t i = 0; i < n; ++i) apart = std::max(apart, std::abs(found[i] - exact[i]));
  RC_ASSERT(apart <= 1e-8 * norm(exact));
}

RC_GTEST_PROP(Banded, OfHalfBandwidthThreeSolvesAsDenseEliminationDoes, ()) {
  expect_the_dense_solution<3>();
}
RC_GTEST_PROP(Banded, OfHalfBandwidthFiveSolvesAsDenseEliminationDoes, ()) {
  expect_the_dense_solution<5>();
}

RC_GTEST_PROP(Banded, LeavesNothingOfWhatItHeldBefore, ()) {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 12));
  BandedMatrix<3> matrix = random_matrix<3>(n + 5, 1).banded;
  matrix.factor(1e-13);
  matrix.reset(n);
  RC_ASSERT(matrix.size() == n);
  std::vector<double> b(n);
  for (std::size_t i = 0; i < n; ++i) matrix.add(i, i, 1.0 + static_cast<double>(i)), b[i] = 1;
  matrix.factor(1e-13);
  matrix.solve(b);
  for (std::size_t i = 0; i < n; ++i) RC_ASSERT(std::abs(b[i] * (1.0 + static_cast<double>(i)) - 1) <= 2 * epsilon);
}

TEST(Banded, RaisesAPivotOfASingularMatrixToTheFloor) {
  // (1 1; 1 1) is 0 in the direction (1, −1): with its second pivot at the floor it is (1 1; 1 1 + floor).
  BandedMatrix<3> matrix;
  matrix.reset(2);
  matrix.add(0, 0, 1);
  matrix.add(0, 1, 1);
  matrix.add(1, 1, 1);
  constexpr double floor = 1.0 / (1 << 20);
  matrix.factor(floor);
  std::vector<double> b = {1, 2};
  matrix.solve(b);
  EXPECT_DOUBLE_EQ(b[1], 1 / floor);
  EXPECT_DOUBLE_EQ(b[0], 1 - 1 / floor);
}

TEST(Banded, TakesTheFloorInTheScaleOfTheDiagonal) {
  BandedMatrix<3> matrix;
  matrix.reset(2);
  matrix.add(0, 0, 1);
  matrix.add(0, 1, 1e3);
  matrix.add(1, 1, 1e6);
  constexpr double floor = 1.0 / (1 << 20);
  matrix.factor(floor);
  std::vector<double> b = {0, 1};
  matrix.solve(b);
  EXPECT_NEAR(b[1], 1 / (floor * 1e6), 1e-12 / (floor * 1e6));
}

/// Sums of squares, all but singular where columns are equal: the solution stays finite, and along the gradient it was
/// made for it is a descent.
RC_GTEST_PROP(Banded, GivesADescentWhereNearlySingular, ()) {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(2, 30));
  auto both = random_matrix<3>(n, 1e-6);
  std::vector<double> gradient(n);
  for (double& x : gradient) x = uniform();
  gradient[0] = 1;
  both.banded.factor(1e-13);
  std::vector<double> step = gradient;
  both.banded.solve(step);
  long double along = 0;
  for (std::size_t i = 0; i < n; ++i) {
    RC_ASSERT(std::isfinite(step[i]));
    along += static_cast<long double>(step[i]) * gradient[i];
  }
  RC_ASSERT(along > 0);
}

}  // namespace test_banded
