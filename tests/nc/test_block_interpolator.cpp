// Blocks take exactly the commands that were counted, and end where they should.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/nc/block_interpolator.hpp>

#include "blocks.hpp"

namespace leadscrew::nc {
namespace test_block_interpolator {

constexpr std::array methods = {PulseMethod::koren,     PulseMethod::dda,
                                PulseMethod::min_error, PulseMethod::improved_min_error,
                                PulseMethod::bresenham, PulseMethod::point_comparison};
constexpr std::array preloads = {pulse::Preload::none, pulse::Preload::half, pulse::Preload::half_lagging,
                                 pulse::Preload::full};

/// Displacements of some of the nine axes, of few steps or of many.
LatticeVector random_delta(std::size_t first_axis) {
  LatticeVector delta{};
  const auto longest = *rc::gen::element<std::int64_t>(1, 2, 3, 10, 3000);
  const auto axes = *rc::gen::inRange<std::size_t>(first_axis, base::axis_count + 1);
  for (std::size_t i = first_axis; i < axes; ++i) delta[i] = *rc::gen::inRange(-longest, longest + 1);
  return delta;
}

void expect_as_counted(Block block) {
  for (const PulseMethod method : methods) {
    for (const pulse::Preload preload : preloads) {
      const InterpolationOptions options{.preload = preload};
      ArcTape tape;
      count_commands(block, method, options, tape);
      BlockInterpolator interpolator(block, method, options, tape);
      LatticeVector made{};
      std::int64_t commands = 0;
      for (; !interpolator.done(); ++commands) {
        const AxisPulse pulse = interpolator.step();
        for (std::size_t i = 0; i < made.size(); ++i) made[i] += pulse.step[i];
      }
      RC_LOG() << static_cast<int>(method) << " " << static_cast<int>(preload) << ": " << commands << " of "
               << block.commands;
      RC_ASSERT(commands == block.commands);
      RC_ASSERT(made == whole_delta(block));
    }
  }
}

RC_GTEST_PROP(BlockInterpolator, TakesTheCommandsOfALine, ()) {
  Block block;
  block.delta = random_delta(0);
  expect_as_counted(block);
}

RC_GTEST_PROP(BlockInterpolator, TakesTheCommandsOfAHelix, ()) {
  Block block;
  block.kind = Block::Kind::arc;
  const auto radius = *rc::gen::element<std::int64_t>(1, 2, 5, 300);
  block.arc = {{radius, 0}, {0, -radius}, pulse::Direction{*rc::gen::element<std::int8_t>(-1, 1)}};
  block.delta = random_delta(2);
  expect_as_counted(block);
}

}  // namespace test_block_interpolator
}  // namespace leadscrew::nc
