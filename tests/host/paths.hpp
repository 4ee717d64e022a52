#pragma once
// Programs and motions that tests of a host's motion share.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/host/motion.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace leadscrew::host_tests {

inline std::vector<base::Word> words_of(host::Motion& motion, std::size_t capacity = 256) {
  std::vector<base::Word> all, some(capacity);
  while (const std::size_t count = motion.next(some))
    all.insert(all.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  return all;
}

inline std::unique_ptr<host::Motion> program(const std::string& text, host::MotionOptions options = {}) {
  auto motion = host::Motion::of_program(machine::mill3(), text, std::move(options));
  EXPECT_TRUE(motion);
  return motion ? std::move(*motion) : nullptr;
}

/// Lines, half circles and rests.
inline std::string random_path() {
  std::string text = "G21 G90 G17 G64 P0.01 F" + std::to_string(*rc::gen::inRange(300, 9000)) + "\n";
  double x = 0;
  const int blocks = *rc::gen::inRange(1, 20);
  for (int i = 0; i < blocks; ++i) {
    const double step = *rc::gen::inRange(1, 400) / 20.0 * (x > 0 ? -1 : 1);
    x += step;
    switch (*rc::gen::inRange(0, 8)) {
      case 0:
        text += "G4 P0.01\n";
        [[fallthrough]];
      case 1:
        text += "G3 X" + std::to_string(x) + " I" + std::to_string(step / 2) + " J0\n";
        break;
      default:
        text += "G1 X" + std::to_string(x) + " Y" + std::to_string(*rc::gen::inRange(-200, 200) / 10.0) + "\n";
        if (*rc::gen::inRange(0, 2)) text += "G0 X" + std::to_string(x) + " Y0\n";
        text += "G1 X" + std::to_string(x) + " Y0\n";
    }
  }
  return text;
}

}  // namespace leadscrew::host_tests
