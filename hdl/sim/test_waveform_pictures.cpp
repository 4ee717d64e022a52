#include <Vby_point_comparison_6.h>
#include <Vdda_6.h>
#include <Vimproved_minimum_error_6.h>
#include <Vminimum_error_6.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <utility>

#include "arc_bench.hpp"
#include "waveform_picture.hpp"

// Figs. 5 to 8 as pictures, by the models: the quarter of radius 5 from (5, 0) to (0, 5), from Syn to the clock behind the last pulse.
// They are those in docs/waveforms; script/hardware-pictures makes them anew.

namespace leadscrew::hardware {
namespace test_waveform_pictures {

template <typename Model>
using Look = std::function<std::int64_t(const Model&)>;
/// What a core shows of itself besides.
template <typename Model>
using Looks = std::vector<std::pair<std::string, Look<Model>>>;

template <typename Model, typename Reference>
std::string picture_of(const std::string& title, const Looks<Model>& registers) {
  ArcBench<Model, Reference> bench(6);
  std::vector<Signal> signals = {{"Syn", true},       {"Busy", true},  {"X_Pwm_Out", true}, {"X_Dir", true},
                                 {"Z_Pwm_Out", true}, {"Z_Dir", true}, {"Val_x", false},    {"Val_z", false}};
  for (const auto& [name, look] : registers) signals.push_back({name, false});
  const auto record = [&](bool is_syn) {
    const Model& core = *bench.core().operator->();
    std::vector<std::optional<std::int64_t>> now = {is_syn,         core.Busy,  core.X_Pwm_Out, core.X_Dir,
                                                    core.Z_Pwm_Out, core.Z_Dir, bench.at().x,   bench.at().y};
    for (const auto& [name, look] : registers) now.emplace_back(look(core));
    // Before Syn the registers mean nothing.
    for (std::size_t k = 0; k < now.size(); ++k)
      signals[k].values.push_back(is_syn && !signals[k].is_bit ? std::nullopt : now[k]);
  };
  record(true);
  bench.start({{5, 0}, {0, 5}, pulse::Direction::counterclockwise});
  record(false);
  while (bench.core()->Busy && signals.front().values.size() < 100) {
    bench.core().clock();
    record(false);
  }
  return waveform_svg(title, signals);
}

/// LEADSCREW_RECORD=1 in the environment writes what is compared otherwise.
void expect_pictured(const std::string& name, const std::string& picture) {
  const std::string file = LEADSCREW_SOURCE_DIR "/docs/waveforms/" + name;
  if (std::getenv("LEADSCREW_RECORD") != nullptr) std::ofstream(file, std::ios::binary) << picture;
  std::ifstream kept(file, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), picture)
      << name << ": script/hardware-pictures draws it anew";
}

constexpr int width_of_f = 9, width_of_d = 11;

TEST(WaveformPictures, OfPointComparison) {
  using Model = Vby_point_comparison_6;
  expect_pictured("fig-5.svg", picture_of<Model, PointComparisonReference>(
                                   "Point comparison (Fig. 5), a quarter of R 5",
                                   {{"Val_f", [](const Model& core) { return signed_of(core.Val_f, width_of_f); }}}));
}

TEST(WaveformPictures, OfTheDda) {
  using Model = Vdda_6;
  expect_pictured("fig-6.svg", picture_of<Model, DdaReference>(
                                   "DDA (Fig. 6), a quarter of R 5",
                                   {{"Sum_X", [](const Model& core) { return std::int64_t{core.Sum_X}; }},
                                    {"Sum_Z", [](const Model& core) { return std::int64_t{core.Sum_Z}; }}}));
}

TEST(WaveformPictures, OfMinimumError) {
  using Model = Vminimum_error_6;
  expect_pictured("fig-7.svg", picture_of<Model, LeastErrorReference>(
                                   "Minimum error (Fig. 7), a quarter of R 5",
                                   {{"Val_f", [](const Model& core) { return signed_of(core.Val_f, width_of_f); }},
                                    {"Val_n1", [](const Model& core) { return signed_of(core.Val_n1, width_of_f); }},
                                    {"Val_n2", [](const Model& core) { return signed_of(core.Val_n2, width_of_f); }},
                                    {"Val_n3", [](const Model& core) { return signed_of(core.Val_n3, width_of_f); }}}));
}

TEST(WaveformPictures, OfImprovedMinimumError) {
  using Model = Vimproved_minimum_error_6;
  expect_pictured("fig-8.svg", picture_of<Model, ImprovedLeastErrorReference>(
                                   "Improved minimum error (Fig. 8), a quarter of R 5",
                                   {{"Val_f", [](const Model& core) { return signed_of(core.Val_f, width_of_f); }},
                                    {"Val_d", [](const Model& core) { return signed_of(core.Val_d, width_of_d); }}}));
}

}  // namespace test_waveform_pictures
}  // namespace leadscrew::hardware
