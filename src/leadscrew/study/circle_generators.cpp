#include <array>
#include <cmath>
#include <leadscrew/pulse/free_circle.hpp>
#include <leadscrew/study/chopped.hpp>
#include <leadscrew/study/studies.hpp>
#include <numbers>
#include <optional>

// Koren, "Interpolator for a computer numerical control system": x′ = −y, y′ = x by several methods of integration.

namespace leadscrew::study {

namespace {

constexpr double radius = 10;
constexpr std::array<double, 6> steps = {1, 0.1, 0.01, 0.001, 1e-4, 1e-5};  // T, rad
constexpr Scale blu = {"BLU", 0};

/// A place on the circle that is generated, in numbers of some kind.
template <typename Number>
struct Place {
  Number x = radius, y = 0.0;
};

enum class Method : std::uint8_t { euler, tustin, runge_kutta, state_transition };
constexpr std::array<Method, 4> methods = {Method::euler, Method::tustin, Method::runge_kutta,
                                           Method::state_transition};

std::string name_of(Method method) {
  constexpr std::array<const char*, 4> names = {"Euler", "Tustin", "Runge-Kutta", "state transition"};
  return names[static_cast<std::size_t>(method)];
}

template <typename Number>
Place<Number> euler(const Place<Number>& at, double t) {
  return {at.x - Number(t) * at.y, at.y + Number(t) * at.x};
}

/// The second coordinate by the trapezoid over the new and the old first one, as a program would.
template <typename Number>
Place<Number> tustin(const Place<Number>& at, double t) {
  const Number a = (1 - t * t / 4) / (1 + t * t / 4), b = t / (1 + t * t / 4), half = t / 2;
  const Number x = a * at.x - b * at.y;
  return {x, at.y + half * (at.x + x)};
}

template <typename Number>
Place<Number> state_transition(const Place<Number>& at, double t) {
  const Number a = std::cos(t), b = std::sin(t);
  return {a * at.x - b * at.y, a * at.y + b * at.x};
}

/// The classical rule of fourth order; only its last sum is cut.
template <typename Number>
Place<Number> runge_kutta(double x, double y, double t) {
  const double x1 = -y, y1 = x;
  const double x2 = -(y + t / 2 * y1), y2 = x + t / 2 * x1;
  const double x3 = -(y + t / 2 * y2), y3 = x + t / 2 * x2;
  const double x4 = -(y + t * y3), y4 = x + t * x3;
  return {x + t / 6 * (x1 + 2 * x2 + 2 * x3 + x4), y + t / 6 * (y1 + 2 * y2 + 2 * y3 + y4)};
}

Place<Chopped> step(Method method, const Place<Chopped>& at, double t) {
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
  Place<Chopped> at;
  for (double n = 0; n < count; ++n) at = step(method, at, t);
  return 1000 * (radius + std::abs(at.x.value()) - radius * std::abs(std::cos(count * t)));
}

/// The radius itself after half a turn, in thousandths.
double half_turn_radius(Method method, double t) {
  Place<Chopped> at;
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
constexpr std::array<std::array<double, 6>, 4> published = {{
    {blank, blank, 10160, 10020, 10000, 9982},
    {9460, 9996, 10000, 10000, 9997, 9963},
    {9795, 10000, 10000, 10000, 9998, 9982},
    {10000, 10000, 10000, 10000, 9996, 9945},
}};

Row half_turn_row(Method method, std::size_t column) {
  const double t = steps[column], figure = published[static_cast<std::size_t>(method)][column];
  const double exact = half_turn(method, t);
  const std::string what = "T = " + decimal(t, column < 5 ? static_cast<int>(column) : 5);
  if (figure == blank) {
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

double radius_after(const Place<double>& at) {
  return std::hypot(at.x, at.y);
}

/// Error of the radius after so many steps of t, by R.
template <typename Step>
double radius_error(const Step& step, double t, double count) {
  Place<double> at;
  for (double n = 0; n < count; ++n) at = step(at, t);
  return std::abs(radius_after(at) / radius - 1);
}

Place<double> heun(const Place<double>& at, double t) {
  return {at.x - t * at.y - t * t / 2 * at.x, at.y + t * at.x - t * t / 2 * at.y};
}

/// Exponent of T that an error grows with, between this step and half of it.
template <typename Error>
double slope(const Error& error, double t) {
  return std::log2(error(t) / error(t / 2));
}

template <typename Step>
Rows order_rows(const std::string& name, const Step& step, double t, double a_step) {
  const auto one = [&](double h) { return radius_error(step, h, 1); };
  const auto half = [&](double h) { return radius_error(step, h, std::floor(std::numbers::pi / h)); };
  Row each = exact_row("exponent of T, each step", {"", 0}, a_step, slope(one, t));
  each.why = decimal(slope(one, t), 3) + ", from T = " + decimal(t, 3) + " to half of it";
  Row turn = exact_row("exponent of T, half a turn", {"", 0}, a_step - 1, slope(half, t));
  turn.why = decimal(slope(half, t), 3) + "; the errors of π/T steps add up";
  return under(name, {std::move(each), std::move(turn)});
}

/// The greatest error of the radius along a whole turn of eq. 27, by R: x first, then y by the new x.
double eq27_error(double t) {
  double x = 1, y = 0, worst = 0;
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += t) {
    x -= t * y;
    y += t * x;
    worst = std::max(worst, std::abs(std::hypot(x, y) - 1));
  }
  return worst;
}

/// Error of eq. 27 at half a turn, ⌊π/T⌋ steps, by R T²: the greatest of many T.
double eq27_half_turn_error() {
  double worst = 0;
  for (double t = 0.1; t > 1e-4; t *= 0.97) {
    double x = 1, y = 0;
    for (double angle = t; angle <= std::numbers::pi; angle += t) {
      x -= t * y;
      y += t * x;
    }
    worst = std::max(worst, std::abs(std::hypot(x, y) - 1) / (t * t));
  }
  return worst;
}

/// What stays the same along eq. 27, by R², at its farthest from that.
double eq27_invariant_error(double t) {
  double x = 1, y = 0, worst = 0;
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += t) {
    x -= t * y;
    y += t * x;
    worst = std::max(worst, std::abs(x * x - t * x * y + y * y - 1));
  }
  return worst;
}

Rows eq27_rows() {
  Row order = reproduced_row("exponent of T, greatest of a turn", {"", 2}, 4, slope(eq27_error, 1e-3), 0.05);
  order.why = "published T⁴; but x² − Txy + y² stays what it is: an ellipse, T/4 off the circle, that never grows";
  constexpr double circle = 10000;  // BLU
  Row ellipse = exact_row("greatest error of a turn, T = 1/R", {"BLU", 2}, 0.25, circle * eq27_error(1 / circle));
  ellipse.why = "R T/4; of the method, without rounding to steps";
  Row invariant = limit_row("farthest that x² − Txy + y² is from R²", {"", 0}, 0, eq27_invariant_error(1e-3), 1e-11);
  invariant.why = "by R²; no error grows from turn to turn";
  Row half = limit_row("error at half a turn", {"R T²", 2}, 0.5, eq27_half_turn_error(), 0.005);
  half.why =
      "T = 0.1 … 0.0001; less where a step falls on half a turn: the ellipse is off by R T/4 sin 2θ, θ within T of π";
  return under("the proposed method, eq. 27",
               {std::move(order), std::move(ellipse), std::move(invariant), std::move(half)});
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

Rows orders_rows(const Host&) {
  Rows rows = order_rows("Euler", euler<double>, 0.001, 2);
  append(rows, order_rows("Heun, eq. 23", heun, 0.01, 4));
  const auto classical = [](const Place<double>& at, double t) { return runge_kutta<double>(at.x, at.y, t); };
  append(rows, order_rows("Runge-Kutta", classical, 0.1, 6));
  append(rows, eq27_rows());
  return rows;
}

Rows half_circle_rows(const Host&) {
  constexpr const char* what = "|x| after half a turn";
  Row koren = exact_row(what, blu, 10001, half_circle(Order::x_first, Accumulation::sign_magnitude, 0));
  koren.why = "magnitudes are accumulated, the pulse gets the sign";
  Rows rows = under("eq. 27, remainders empty", {std::move(koren)});
  // r > q overflows where r − 1 ≥ q does.
  append(rows, under("eq. 27, remainders empty, r > q",
                     {exact_row(what, blu, 10001, half_circle(Order::x_first, Accumulation::sign_magnitude, -1))}));
  const auto variant = [&](const char* group, Order order, Accumulation accumulation, std::int64_t preload) {
    append(rows, under(group, {measured_row(what, blu, half_circle(order, accumulation, preload))}));
  };
  variant("eq. 27, remainders half full", Order::x_first, Accumulation::sign_magnitude, 5000);
  variant("eq. 27, two's complement", Order::x_first, Accumulation::floor, 0);
  for (const auto& [group, preload] : {std::pair{"eq. 27, signed remainders, empty", 0},
                                       {"eq. 27, signed remainders, half full", 5000},
                                       {"eq. 27, signed remainders, full", 9999}}) {
    append(rows,
           under(group, {exact_row(what, blu, 10001, half_circle(Order::x_first, Accumulation::symmetric, preload))}));
  }
  variant("as in hardware, remainders empty", Order::parallel, Accumulation::sign_magnitude, 0);
  variant("as in hardware, remainders half full", Order::parallel, Accumulation::sign_magnitude, 5000);
  variant("as in hardware, two's complement, half full", Order::parallel, Accumulation::floor, 5000);
  append(rows, under("Euler's method in real numbers", {euler_drift_row("drift of half a turn", 0.5, 1.57),
                                                        euler_drift_row("drift of a turn", 1, 3.14)}));
  return rows;
}

}  // namespace leadscrew::study
