#include <algorithm>
#include <leadscrew/nc/pulse_reason.hpp>

namespace leadscrew::nc {

namespace {

using pulse::absolute;

template <typename Axis>
Addition addition_of(const Axis& axis, std::int64_t capacity) {
  return {axis.integrand, axis.beyond - axis.integrand + capacity, capacity, axis.left};
}

std::vector<Addition> additions_of(const pulse::CircularDda& state) {
  const auto now = state.stretch();
  Addition first = addition_of(now.first, now.capacity), second = addition_of(now.second, now.capacity);
  if (now.goes_on()) {
    if (now.sees_new != 0 && first.overflows()) second.integrand += now.second.change;
  } else {
    first.drains = first.is_clocked() && first.integrand <= 0;
    second.drains = second.is_clocked() && second.integrand <= 0;
  }
  if (now.x_is_first) return {first, second};
  return {second, first};
}

/// Of what has an integrator and a place for each axis: `first` is clocked first, and the place seen by the second one
/// is that behind its step, where it sees that.
std::vector<Addition> additions_of(const pulse::EllipticDda& state) {
  const bool x_is_first = state.x_comes_first();
  const auto& one = x_is_first ? state.x() : state.y();
  const auto& other = x_is_first ? state.y() : state.x();
  const bool is_alone = one.left == 0 || other.left == 0;
  const auto of = [&](const pulse::EllipticDda::Axis& axis, std::int64_t seen) {
    const std::int64_t integrand = axis.integrand(seen);
    return Addition{integrand, axis.integrator.remainder(), axis.integrator.capacity(), axis.left,
                    is_alone && axis.left > 0 && integrand == 0};
  };
  const Addition first = of(one, other.at);
  const bool is_seen = state.sees_new() && first.overflows();
  const Addition second = of(other, one.at + (is_seen ? one.sign : 0));
  if (x_is_first) return {first, second};
  return {second, first};
}

std::vector<Addition> additions_of(const pulse::FreeArc& state) {
  const bool x_is_first = state.x_comes_first();
  const bool by_magnitude = state.accumulation() == pulse::Accumulation::sign_magnitude;
  const auto of = [&](const pulse::FreeArc::Axis& axis, std::int64_t integrand) {
    return Addition{by_magnitude ? absolute(integrand) : integrand,
                    axis.integrator.remainder(),
                    axis.integrator.capacity(),
                    state.left(),
                    false,
                    state.accumulation()};
  };
  // By magnitudes the pulse has the sign of the integrand, else that of the carry.
  const auto step_of = [&](const Addition& made, std::int64_t integrand) {
    return by_magnitude ? made.carry() * pulse::sign(integrand) : made.carry();
  };
  pulse::Point at = state.at();
  if (x_is_first) {
    const Addition first = of(state.x(), state.of_x(at));
    if (state.sees_new()) at.x += step_of(first, state.of_x(at));
    return {first, of(state.y(), state.of_y(at))};
  }
  const Addition first = of(state.y(), state.of_y(at));
  at.y += step_of(first, state.of_y(at));
  return {of(state.x(), state.of_x(at)), first};
}

std::vector<Addition> additions_of(const pulse::LinearDda<2>& state) {
  std::vector<Addition> additions;
  for (const std::size_t axis : {0U, 1U}) {
    const auto& integrator = state.integrator(axis);
    additions.push_back({state.integrand(axis), integrator.remainder(), integrator.capacity(), state.left(axis)});
  }
  return additions;
}

template <typename Search>
std::vector<Addition> additions_of(const Search&) {
  return {};
}

std::int64_t value_in(const Registers& registers, std::string_view name) {
  for (const Register& each : registers.all()) {
    if (each.name == name) return each.value;
  }
  return 0;
}

std::string number(std::int64_t value) {
  return value < 0 ? "−" + std::to_string(-value) : std::to_string(value);
}

std::string step_text(const char* axis, std::int8_t step) {
  return std::string(axis) + (step < 0 ? " −1" : " +1");
}

/// "X −1 and Y +1"
std::string pulse_text(pulse::Pulse<2> pulse) {
  const auto [x, y] = pulse.step;
  if (x != 0 && y != 0) return step_text("X", x) + " and " + step_text("Y", y);
  return x != 0 ? step_text("X", x) : step_text("Y", y);
}

std::string addition_text(const Addition& made, const char* capital, const char* letter, std::int8_t step) {
  const std::string axis = letter;
  if (!made.is_clocked()) return std::string(capital) + " has arrived: its integrator is not clocked";
  if (made.drains) {
    return "J" + axis + " is 0 and can never overflow, " + number(made.left) +
           " left and the other axis has arrived: " + step_text(capital, step) + " all the same";
  }
  const std::string sum = "J" + axis + " " + number(made.integrand) + " + r" + axis + " " + number(made.remainder) +
                          " = " + number(made.sum());
  if (!made.overflows())
    return sum + " < " + number(made.capacity) + ": no overflow, r" + axis + " " + number(made.sum());
  if (made.carry() < 0) {
    const std::int64_t least = made.accumulation == pulse::Accumulation::symmetric ? 1 - made.capacity : 0;
    return sum + " < " + number(least) + ": borrow, " + step_text(capital, step) + ", r" + axis + " " +
           number(made.sum() + made.capacity);
  }
  return sum + " ≥ " + number(made.capacity) + ": overflow, " + step_text(capital, step) + ", r" + axis + " " +
         number(made.sum() - made.capacity);
}

/// Of the quadrant that an integrator of arcs is in; −1 of what has none.
int quadrant_in(const PulseRun& run) {
  return run.look_at([](const auto& state) {
    if constexpr (requires { state.in_quadrant(); }) return state.in_quadrant();
    return -1;
  });
}

std::string of_integrators(const std::vector<Addition>& made, const PulseRun& before, const PulseRun& run) {
  const auto [x, y] = run.last().step;
  std::string text = addition_text(made[0], "X", "x", x) + "\n" + addition_text(made[1], "Y", "y", y);
  if (quadrant_in(before) != quadrant_in(run)) text += "\nThe quadrant ends here: both integrators are loaded anew";
  return text;
}

/// A search steps as its rule says until its faster axis has come to the end; what is left then is made up for.
std::string to_the_end(pulse::Pulse<2> pulse) {
  return "The path has come out beside the end: " + pulse_text(pulse) + " to reach it";
}

/// "F = −3 < 0"
std::string with_sign(const char* name, std::int64_t value) {
  return std::string(name) + " = " + number(value) + (value < 0 ? " < 0" : value > 0 ? " > 0" : "");
}

std::string of_point_comparison(const Registers& before, const PulseCurve& curve, pulse::Pulse<2> pulse) {
  const auto [x, y] = pulse.step;
  const std::int64_t f = value_in(before, "F"), at_x = value_in(before, "x"), at_y = value_in(before, "y");
  const std::string found = with_sign("F", f);
  if (curve.is_arc()) {
    const bool is_inward = x * at_x + y * at_y < 0;
    if ((x != 0 && y != 0) || (f > 0 && !is_inward) || (f < 0 && is_inward)) return to_the_end(pulse);
    return found +
           (f < 0   ? ", inside"
            : f > 0 ? ", outside"
                    : ", on") +
           " the circle: " + (is_inward ? "inward, " : "outward, ") + pulse_text(pulse);
  }
  if (x == 0 && f >= 0) return found + ", and x does not move: " + pulse_text(pulse);
  return found + (f < 0 ? ", x is ahead: " : f > 0 ? ", y is ahead: " : ", on the line: x first, ") + pulse_text(pulse);
}

std::string of_least_error(const Registers& before, pulse::Pulse<2> pulse) {
  std::array<std::int64_t, 3> n = {value_in(before, "n1"), value_in(before, "n2"), value_in(before, "n3")};
  const std::size_t taken = pulse.step[0] != 0 && pulse.step[1] != 0 ? 0 : pulse.step[0] == 0 ? 1 : 2;
  for (std::int64_t& each : n) each = absolute(each);
  if (n[taken] > n[0] || n[taken] > n[1] || n[taken] > n[2]) return to_the_end(pulse);
  return "|n1| " + number(n[0]) + ", |n2| " + number(n[1]) + ", |n3| " + number(n[2]) + ": the least is |n" +
         std::to_string(taken + 1) + "|, " + pulse_text(pulse);
}

std::string of_middle(const Registers& before, const PulseCurve& curve, pulse::Pulse<2> pulse) {
  const std::int64_t d = value_in(before, "d"), x = value_in(before, "x"), y = value_in(before, "y");
  const auto [step_x, step_y] =
      pulse::tangent(pulse::quadrant(pulse::Point{x, y}, curve.direction), curve.direction).step;
  const bool x_grows = step_x * x > 0 || x == 0;
  const bool x_is_long = absolute(x) < absolute(y) || (absolute(x) == absolute(y) && x_grows);
  const bool short_grows = x_is_long != x_grows;
  const bool both = short_grows ? d >= 0 : d <= 0;
  const pulse::Pulse<2> asked{
      {both || x_is_long ? step_x : std::int8_t{0}, both || !x_is_long ? step_y : std::int8_t{0}}};
  if (asked != pulse) return to_the_end(pulse);
  return std::string(x_is_long ? "X" : "Y") + " is the faster axis here and steps; " + with_sign("4(d1 − d2)", d) +
         ": the circle is nearer to the step " + (both ? "of both, " : "of it alone, ") + pulse_text(pulse);
}

std::string of_bresenham(const Registers& before, const Registers& after, const PulseCurve& curve,
                         pulse::Pulse<2> pulse) {
  const pulse::Point delta = curve.delta();
  const std::int64_t shorter = std::min(absolute(delta.x), absolute(delta.y)), f = value_in(before, "F");
  const std::int64_t sum = f + 2 * shorter;
  return "F " + number(f) + " + 2 · " + number(shorter) + " = " + number(sum) +
         (sum > 0 ? " > 0: the line is nearer to the step of both axes, "
                  : " ≤ 0: the line is nearer to the step of the longer axis alone, ") +
         pulse_text(pulse) + ", F " + number(value_in(after, "F"));
}

}  // namespace

std::vector<Addition> next_additions(const PulseRun& run) {
  return run.look_at([](const auto& state) { return additions_of(state); });
}

Registers flow_of(const PulseRun& before, const PulseRun& run, const PulseCurve& curve) {
  Registers flow;
  if (curve.is_arc()) {
    const pulse::Point at{run.at().x - curve.center.x, run.at().y - curve.center.y};
    flow.add("quadrant", pulse::quadrant(at, curve.direction));
  }
  const std::vector<Addition> made = next_additions(before);
  if (made.empty()) return flow;
  const bool is_first = run.clock() == before.clock();
  const auto sum = [&](const Addition& each) { return !is_first && each.is_clocked() ? each.sum() : each.remainder; };
  if (curve.is_arc()) {
    flow.add("Jx", made[0].integrand);
    flow.add("Jy", made[1].integrand);
  }
  flow.add("Sx", sum(made[0]));
  flow.add("Sy", sum(made[1]));
  flow.add("ox", !is_first && made[0].overflows() ? 1 : 0);
  flow.add("oy", !is_first && made[1].overflows() ? 1 : 0);
  return flow;
}

std::string reason_of(const PulseRun& before, const PulseRun& run, const PulseCurve& curve) {
  if (run.clock() == before.clock()) return {};
  if (const auto made = next_additions(before); !made.empty()) return of_integrators(made, before, run);
  const Registers was = signals_of(before, curve);
  if (run.method() == PulseMethod::point_comparison) return of_point_comparison(was, curve, run.last());
  if (!curve.is_arc()) return of_bresenham(was, run.registers(), curve, run.last());
  switch (with_row(run.method(), [](auto row) { return row.candidates; })) {
    case Candidates::three:
      return of_least_error(was, run.last());
    case Candidates::middle:
      return of_middle(was, curve, run.last());
    default:
      return pulse_text(run.last());
  }
}

}  // namespace leadscrew::nc
