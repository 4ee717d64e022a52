#include <leadscrew/nc/pulse_signals.hpp>

namespace leadscrew::nc {

namespace {

std::int64_t value_of(const Registers& registers, std::string_view name) {
  for (const Register& each : registers.all()) {
    if (each.name == name) return each.value;
  }
  return 0;
}

/// What a step along the tangent adds to F.
std::int64_t added(std::int64_t coordinate, std::int8_t step) {
  return 2 * coordinate * step + 1;
}

}  // namespace

Registers signals_of(const PulseRun& run, const PulseCurve& curve) {
  Registers signals = run.registers();
  const Candidates candidates = with_row(run.method(), [](auto row) { return row.candidates; });
  if (!curve.is_arc() || candidates == Candidates::none) return signals;
  const pulse::Point at{run.at().x - curve.center.x, run.at().y - curve.center.y};
  const int quadrant = pulse::quadrant(at, curve.direction);
  const auto [step_x, step_y] = pulse::tangent(quadrant, curve.direction).step;
  const std::int64_t f = value_of(signals, "F"), by_x = added(at.x, step_x), by_y = added(at.y, step_y);
  const std::int64_t n1 = f + by_x + by_y, n2 = f + by_y, n3 = f + by_x;
  signals.add("n1", n1);
  signals.add("n2", n2);
  signals.add("n3", n3);
  if (candidates != Candidates::middle) return signals;
  // The longer axis is that of the smaller coordinate; where they are equal, the growing one. In either case, with p
  // the place on the circle beside its next step, 4p² − (2v ∓ 1)² = 1 − 2(n1 + n), n after the longer axis alone.
  const bool x_grows = step_x * at.x > 0 || at.x == 0;
  const std::int64_t x = pulse::absolute(at.x), y = pulse::absolute(at.y);
  const bool x_is_long = x < y || (x == y && x_grows);
  signals.add("d", 1 - 2 * (n1 + (x_is_long ? n3 : n2)));
  return signals;
}

std::vector<std::string_view> names_in_paper(std::string_view symbol, PulseMethod method, PulseCurve::Shape shape) {
  std::vector<std::string_view> papers;
  for (const PaperName& each : with_row(method, [&](auto row) { return row.paper_names(shape); })) {
    if (each.ours == symbol) papers.push_back(each.paper);
  }
  return papers;
}

}  // namespace leadscrew::nc
