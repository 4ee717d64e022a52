#pragma once
// Chains that tests go through, and random poses on them.

#include <array>
#include <cmath>
#include <cstdint>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace leadscrew::kinematics::testing {

struct NamedChain {
  std::string name;
  machine::RotaryChain data;
  Chain chain;
};

inline NamedChain named(std::string name, const machine::RotaryChain& data) {
  return {std::move(name), data, Chain::of(data).value()};
}

/// A preset with points off the origin and off one another.
inline machine::RotaryChain displaced(std::string_view preset) {
  machine::RotaryChain data = *machine::preset_chain(preset);
  data.axes[0].point = {12.5, -7.25, 31};
  data.axes[1].point = {-3, 44.5, 160.75};
  data.tool_zero = {1.5, -2, 10};
  return data;
}

/// The presets, displaced; the same with signs of ISO 841; nutating heads and tables at 45°; directions that lie along no
/// coordinate and meet at no right angle.
inline std::vector<NamedChain> all_chains() {
  std::vector<NamedChain> chains;
  for (const machine::KinematicsPreset& preset : machine::kinematics_presets) {
    const std::string name(preset.name);
    chains.push_back(named(name, displaced(name)));
    machine::RotaryChain turned = displaced(name);
    turned.axes[0].sign = -1;
    turned.axes[1].direction = {-turned.axes[1].direction[0], -turned.axes[1].direction[1],
                                -turned.axes[1].direction[2]};
    chains.push_back(named(name + " the other way", turned));
  }
  const double half = std::sqrt(0.5);
  machine::RotaryChain head = displaced("head-head-bc");
  head.axes[1].direction = {0, half, half};
  chains.push_back(named("nutating head", head));
  machine::RotaryChain table = displaced("table-table-bc");
  table.axes[0].direction = {0, half, -half};
  chains.push_back(named("nutating table", table));
  machine::RotaryChain mixed = displaced("head-b-table-c");
  mixed.axes[0].direction = {0, 0.6, 0.8};
  mixed.axes[1].direction = {0, 0.6, -0.8};
  chains.push_back(named("oblique mixed", mixed));
  machine::RotaryChain oblique = displaced("head-head-ac");
  oblique.axes[0].direction = {2.0 / 7, 3.0 / 7, 6.0 / 7};
  oblique.axes[1].direction = {6.0 / 7, 2.0 / 7, -3.0 / 7};
  chains.push_back(named("oblique head", oblique));
  return chains;
}

/// Evenly in a range.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double operator()(double least, double greatest) {
    return least + (greatest - least) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

inline constexpr double degree = std::numbers::pi / 180;

inline double length(const Vector3<double>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

/// Radians; exact however small.
inline double angle_between(const Vector3<double>& a, const Vector3<double>& b) {
  const Vector3<double> cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::atan2(length(cross), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// X Y Z of the tip and both angles, in the places of their axes.
inline Coordinates<double> coordinates(const Chain& chain, const Vector3<double>& tip, const Angles<double>& angles) {
  Coordinates<double> all{};
  for (std::size_t i = 0; i < 3; ++i) all[i] = tip[i];
  for (std::size_t i = 0; i < 2; ++i) all[base::index(chain.turns()[i].axis)] = angles[i];
  return all;
}

}  // namespace leadscrew::kinematics::testing
