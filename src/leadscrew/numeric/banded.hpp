#pragma once
// Symmetric positive definite systems of small half-bandwidth, factored as L D Lᵀ in one pass (Golub and Van Loan,
// "Matrix Computations", 4.3).

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace leadscrew::numeric {

/// Row i holds A(i, i), A(i, i−1), … A(i, i−half_bandwidth); entries left of the first column are 0.
template <std::size_t half_bandwidth>
class BandedMatrix {
 public:
  using Row = std::array<double, half_bandwidth + 1>;

  void reset(std::size_t size) { rows_.assign(size, Row{}); }
  std::size_t size() const { return rows_.size(); }

  /// Adds to A(i, j) and, by symmetry, A(j, i); |i − j| ≤ half_bandwidth.
  void add(std::size_t i, std::size_t j, double value) {
    if (i < j) std::swap(i, j);
    rows_[i][i - j] += value;
  }
  Row& row(std::size_t i) { return rows_[i]; }

  /// A ← L D Lᵀ. A pivot below `pivot_floor` times its diagonal element is raised to that, which keeps the factors
  /// those of a positive definite matrix near A.
  void factor(double pivot_floor) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Row& a = rows_[i];
      const double diagonal = a[0];
      const std::size_t width = std::min(half_bandwidth, i);
      // W(i, j) = L(i, j) D(j) = A(i, j) − Σ_m W(i, m) L(j, m), from the left.
      Row w = a;
      double pivot = diagonal;
      for (std::size_t k = width; k > 0; --k) {
        for (std::size_t m = width; m > k; --m) w[k] -= w[m] * rows_[i - k][m - k];
        a[k] = w[k] * inverse(i - k);
        pivot -= w[k] * a[k];
      }
      pivot = std::max(pivot, pivot_floor * diagonal);
      a[0] = 1 / pivot;
    }
  }

  /// b ← A⁻¹ b, after factor().
  void solve(std::vector<double>& b) const {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i) {
      double sum = b[i];
      for (std::size_t k = 1; k <= std::min(half_bandwidth, i); ++k) sum -= rows_[i][k] * b[i - k];
      b[i] = sum;
    }
    for (std::size_t i = 0; i < n; ++i) b[i] *= inverse(i);
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = 1; k <= std::min(half_bandwidth, i); ++k) b[i - k] -= rows_[i][k] * b[i];
    }
  }

 private:
  double inverse(std::size_t i) const { return rows_[i][0]; }  // 1 / D(i) once row i is factored

  std::vector<Row> rows_;
};

}  // namespace leadscrew::numeric
