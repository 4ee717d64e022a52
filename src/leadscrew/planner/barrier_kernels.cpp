#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/planner/barrier_kernels.hpp>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#pragma GCC diagnostic ignored "-Wpsabi"  // no vector is handed from function to function that is not inline

namespace leadscrew::planner {

std::uint8_t nearest_weight(double weight) {
  constexpr double half_step = 0.84089641525371454;  // 2^(−1/4)
  std::uint8_t index = 0;
  while (index + 1u < cap_weights.size() && weight < half_step * cap_weights[index]) ++index;
  return index;
}

void WeighedLogarithms::flush(std::size_t weight) {
  sum_ -= cap_weights[weight] * numeric::log(products_[weight]);
  products_[weight] = 1;
}

double WeighedLogarithms::sum() {
  for (std::size_t weight = 0; weight < products_.size(); ++weight) {
    if (products_[weight] != 1) flush(weight);
  }
  return std::exchange(sum_, 0);
}

namespace plain {
namespace {
#include <leadscrew/planner/barrier_kernel.inl>
constexpr BarrierKernel kernel = {measure, assemble, step_duals, center_duals};
}  // namespace
}  // namespace plain

#if defined(__x86_64__)

#define LEADSCREW_WIDE

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace avx2 {
namespace {
#include <leadscrew/planner/barrier_kernel.inl>
constexpr BarrierKernel kernel = {measure, assemble, step_duals, center_duals};
}  // namespace
}  // namespace avx2
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#undef LEADSCREW_WIDE
#endif

const BarrierKernel& plain_barrier_kernel() {
  return plain::kernel;
}

const BarrierKernel& barrier_kernel() {
#if defined(__x86_64__)
  static const bool is_wide = __builtin_cpu_supports("avx2") != 0;
  if (is_wide) return avx2::kernel;
#endif
  return plain::kernel;
}

}  // namespace leadscrew::planner
