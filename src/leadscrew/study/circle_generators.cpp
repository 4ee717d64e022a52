#include <array>
#include <cmath>
#include <leadscrew/nc/circle_steps.hpp>
#include <leadscrew/pulse/free_circle.hpp>
#include <leadscrew/study/chopped.hpp>
#include <leadscrew/study/studies.hpp>
#include <numbers>
#include <utility>

// Koren, "Interpolator for a computer numerical control system": x′ = −y, y′ = x by several methods of integration.

namespace leadscrew::study {

using nc::CirclePoint, nc::euler, nc::radius_error, nc::runge_kutta, nc::state_transition, nc::tustin;

namespace {

constexpr double radius = 10;
constexpr std::array<double, 6> steps = {1, 0.1, 0.01, 0.001, 1e-4, 1e-5};  // T, rad
constexpr Scale blu = {"BLU", 0};

enum class Method : std::uint8_t { euler, tustin, runge_kutta, state_transition };
constexpr std::array<Method, 4> methods = {Method::euler, Method::tustin, Method::runge_kutta,
                                           Method::state_transition};

std::string name_of(Method method) {
  constexpr std::array<const char*, 4> names = {"Euler", "Tustin", "Runge-Kutta", "state transition"};
  return names[static_cast<std::size_t>(method)];
}

CirclePoint<Chopped> step(Method method, const CirclePoint<Chopped>& at, double t) {
  switch (method) {
    case Method::euler:
      return euler(at, t);
    case Method::tustin:
      return tustin(at, t);
    case Method::runge_kutta:
      return runge_kutta<Chopped>(at.x.value(), at.y.value(), t);
    case Method::state_transition:
      break;
  }
  return state_transition(at, t);
}

/// What the table calls radius: the error of the cosine after half a turn, on top of R; in thousandths.
double half_turn(Method method, double t) {
  const double count = std::floor(std::numbers::pi / t);
  CirclePoint<Chopped> at;
  for (double n = 0; n < count; ++n) at = step(method, at, t);
  return 1000 * (radius + std::abs(at.x.value()) - radius * std::abs(std::cos(count * t)));
}

/// The radius itself after half a turn, in thousandths.
double half_turn_radius(Method method, double t) {
  CirclePoint<Chopped> at;
  for (double n = 0; n < std::floor(std::numbers::pi / t); ++n) at = step(method, at, t);
  return 1000 * std::hypot(at.x.value(), at.y.value());
}

Rows radius_rows() {
  Rows rows;
  for (const Method method : {Method::tustin, Method::runge_kutta}) {
    rows.push_back(measured_row(name_of(method) + ", T = 1", blu, half_turn_radius(method, 1)));
    rows.back().why = "what the table calls radius is the error of the cosine, added to R";
  }
  return under("the radius itself", std::move(rows));
}

double four_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::round(value / unit) * unit;
}

constexpr double blank = 0;
constexpr std::array<std::array<double, 6>, 4> table_1 = {{
    {blank, blank, 10160, 10020, 10000, 9982},
    {9460, 9996, 10000, 10000, 9997, 9963},
    {9795, 10000, 10000, 10000, 9998, 9982},
    {10000, 10000, 10000, 10000, 9996, 9945},
}};

Row half_turn_row(Method method, std::size_t column) {
  const double t = steps[column], exact = half_turn(method, t);
  const Published figure(table_1[static_cast<std::size_t>(method)][column], {Paper::software_interpolator, "Table I"});
  const std::string what = "T = " + decimal(t, column < 5 ? static_cast<int>(column) : 5);
  if (figure.value == blank) {
    Row row = measured_row(what, blu, exact);
    row.why = "left blank";
    return row;
  }
  if (method == Method::runge_kutta && t == 1) {
    Row row = reproduced_row(what, blu, figure, exact, 1);
    row.why = decimal(exact, 2) + "; the sum of figures that were rounded to four digits before";
    return row;
  }
  Row row = exact_row(what, blu, figure, four_digits(exact));
  row.why = decimal(exact, 2) + " before rounding to four digits";
  if (method == Method::tustin && t == 0.1)
    row.why += "; at nT = 3.0 it is 9996.4, so it was read there, or is a misprint";
  if (method == Method::state_transition && t == 0.001) row.why += "; one off in the last digit";
  return row;
}

// ---------------------------------------------------------------------------------------------------------------------

using pulse::Accumulation;
using pulse::Order;

/// x after half a turn of R = 10 000 BLU: ⌊πR⌋ commands.
double half_circle(Order order, Accumulation accumulation, std::int64_t preload) {
  constexpr std::int64_t r = 10000, commands = 31415;
  pulse::FreeCircle circle({r, 0}, r, preload, order, accumulation);
  for (std::int64_t k = 0; k < commands; ++k) circle.step();
  return static_cast<double>(pulse::absolute(circle.at().x));
}

/// What Euler's method adds to the radius in so much of a turn, with the step 1/R that a DDA has.
Row euler_drift_row(const std::string& what, double turns, double expected) {
  constexpr double blu_radius = 10000;
  const double count = std::floor(2 * std::numbers::pi * turns * blu_radius);
  Row row = exact_row(what, {"BLU", 2}, expected, blu_radius * radius_error(euler<double>, 1 / blu_radius, count));
  row.why = "R(e^2πT − 1), of every radius";
  return row;
}

}  // namespace

Rows table_1_rows(const Host&) {
  Rows rows;
  for (const Method method : methods) {
    Rows of_method;
    for (std::size_t column = 0; column < steps.size(); ++column) of_method.push_back(half_turn_row(method, column));
    append(rows, under(name_of(method), std::move(of_method)));
  }
  append(rows, radius_rows());
  return rows;
}

Rows half_circle_rows(const Host&) {
  constexpr const char* what = "|x| after half a turn";
  constexpr Published published(10001, {Paper::software_interpolator, "comparison with other methods, below Table I"});
  // r > q overflows where r − 1 ≥ q does.
  Rows rows =
      under("eq. 27, remainders empty, r > q",
            {because(exact_row(what, blu, published, half_circle(Order::x_first, Accumulation::sign_magnitude, -1)),
                     "overflow as eq. 3 has it; magnitudes are accumulated, the pulse gets the sign")});
  const auto variant = [&](const char* group, Order order, Accumulation accumulation, std::int64_t preload) {
    append(rows, under(group, {measured_row(what, blu, half_circle(order, accumulation, preload))}));
  };
  variant("eq. 27, remainders empty", Order::x_first, Accumulation::sign_magnitude, 0);
  variant("eq. 27, remainders half full", Order::x_first, Accumulation::sign_magnitude, 5000);
  variant("eq. 27, two's complement", Order::x_first, Accumulation::floor, 0);
  append(rows, under("eq. 27, signed remainders, empty",
                     {because(fitted_row(what, blu, published, half_circle(Order::x_first, Accumulation::symmetric, 0)),
                              "the paper does not say that remainders are signed: chosen for this figure")}));
  variant("eq. 27, signed remainders, half full", Order::x_first, Accumulation::symmetric, 5000);
  variant("eq. 27, signed remainders, full", Order::x_first, Accumulation::symmetric, 9999);
  variant("as in hardware, remainders empty", Order::parallel, Accumulation::sign_magnitude, 0);
  variant("as in hardware, remainders half full", Order::parallel, Accumulation::sign_magnitude, 5000);
  variant("as in hardware, two's complement, half full", Order::parallel, Accumulation::floor, 5000);
  append(rows, under("Euler's method in real numbers", {euler_drift_row("drift of half a turn", 0.5, 1.57),
                                                        euler_drift_row("drift of a turn", 1, 3.14)}));
  return rows;
}

}  // namespace leadscrew::study
