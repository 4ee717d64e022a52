#include <leadscrew/nc/pulse_signals.hpp>
#include <utility>

namespace leadscrew::nc {

namespace {

/// One of a register, ours and that of the paper; there may be several.
using Names = std::pair<std::string_view, std::string_view>;

constexpr std::array<Names, 10> of_fpga = {{{"x", "Val_x"},
                                            {"y", "Val_y"},
                                            {"y", "Val_z"},
                                            {"F", "Val_f"},
                                            {"n1", "Val_n1"},
                                            {"n2", "Val_n2"},
                                            {"n3", "Val_n3"},
                                            {"rx", "Sum_X"},
                                            {"ry", "Sum_Y"},
                                            {"ry", "Sum_Z"}}};
constexpr std::array<Names, 6> of_koren_lines = {
    {{"Jx", "y1"}, {"Jy", "y2"}, {"rx", "r1"}, {"ry", "r2"}, {"dx", "dz1"}, {"dy", "dz2"}}};
constexpr std::array<Names, 6> of_koren_arcs = {
    {{"x", "y1"}, {"y", "y2"}, {"ry", "r1"}, {"rx", "r2"}, {"dy", "dz1"}, {"dx", "dz2"}}};

std::vector<std::string_view> found(std::string_view symbol, std::span<const Names> names) {
  std::vector<std::string_view> papers;
  for (const auto& [ours, paper] : names) {
    if (ours == symbol) papers.push_back(paper);
  }
  return papers;
}

/// On a circle Bresenham's is the method of least error.
bool compares_candidates(PulseMethod method) {
  return method == PulseMethod::min_error || method == PulseMethod::improved_min_error ||
         method == PulseMethod::bresenham;
}

std::int64_t value_of(const Registers& registers, std::string_view name) {
  for (const Register& each : registers.all()) {
    if (each.name == name) return each.value;
  }
  return 0;
}

/// What a step along the tangent adds to F.
std::int64_t added(std::int64_t coordinate, std::int8_t step) {
  return 2 * step * coordinate + 1;
}

}  // namespace

Registers signals_of(const PulseRun& run, const PulseCurve& curve) {
  Registers signals = run.registers();
  if (!curve.is_arc() || !compares_candidates(run.method())) return signals;
  const pulse::Point at{run.at().x - curve.center.x, run.at().y - curve.center.y};
  const int quadrant = pulse::quadrant(at, curve.direction);
  const auto [step_x, step_y] = pulse::tangent(quadrant, curve.direction).step;
  const std::int64_t f = value_of(signals, "F"), by_x = added(at.x, step_x), by_y = added(at.y, step_y);
  const std::int64_t n1 = f + by_x + by_y, n2 = f + by_y, n3 = f + by_x;
  signals.add("n1", n1);
  signals.add("n2", n2);
  signals.add("n3", n3);
  if (run.method() != PulseMethod::improved_min_error) return signals;
  // The longer axis is that of the smaller coordinate; where they are equal, the growing one. In either case, with p
  // the place on the circle beside its next step, 4p² − (2v ∓ 1)² = 1 − 2(n1 + n), n after the longer axis alone.
  const bool x_grows = step_x * at.x > 0 || at.x == 0;
  const std::int64_t x = pulse::absolute(at.x), y = pulse::absolute(at.y);
  const bool x_is_long = x < y || (x == y && x_grows);
  signals.add("d", 1 - 2 * (n1 + (x_is_long ? n3 : n2)));
  return signals;
}

std::vector<std::string_view> names_in_paper(std::string_view symbol, PulseMethod method, PulseCurve::Shape shape) {
  if (method != PulseMethod::koren) return found(symbol, of_fpga);
  return shape == PulseCurve::Shape::arc ? found(symbol, of_koren_arcs) : found(symbol, of_koren_lines);
}

}  // namespace leadscrew::nc
