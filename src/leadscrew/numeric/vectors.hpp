#pragma once
// Vectors of coordinates. Each sum is taken in the order of the coordinates, from 0.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace leadscrew::numeric {

/// Of the first `count` coordinates.
template <std::size_t n>
constexpr double dot(const std::array<double, n>& a, const std::array<double, n>& b, std::size_t count = n) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t n>
inline double norm(const std::array<double, n>& a, std::size_t count = n) {
  return std::sqrt(dot(a, a, count));
}

/// a − b
template <std::size_t n>
constexpr std::array<double, n> difference(const std::array<double, n>& a, const std::array<double, n>& b) {
  std::array<double, n> d;
  for (std::size_t i = 0; i < n; ++i) d[i] = a[i] - b[i];
  return d;
}

/// a + share·b
template <std::size_t n>
constexpr std::array<double, n> sum(const std::array<double, n>& a, double share, const std::array<double, n>& b) {
  std::array<double, n> s;
  for (std::size_t i = 0; i < n; ++i) s[i] = a[i] + share * b[i];
  return s;
}

template <std::size_t n>
inline double distance(const std::array<double, n>& a, const std::array<double, n>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// Distance of a point from the segment between two others.
template <std::size_t n>
inline double distance_to_segment(const std::array<double, n>& p, const std::array<double, n>& a,
                                  const std::array<double, n>& b) {
  const std::array<double, n> along = difference(b, a), to = difference(p, a);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
  return norm(sum(to, -share, along));
}

}  // namespace leadscrew::numeric
