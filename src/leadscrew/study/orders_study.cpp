#include <cmath>
#include <leadscrew/nc/circle_steps.hpp>
#include <leadscrew/study/studies.hpp>
#include <numbers>

// Koren, "Interpolator for a computer numerical control system": how the errors of its methods of integration fall with
// the step T, and what is left of them in the reference words of a circle.

namespace leadscrew::study {

using nc::CirclePoint, nc::euler, nc::heun, nc::radius_error, nc::runge_kutta, nc::state_transition, nc::tustin;

namespace {

/// Exponent of T that an error grows with, between this step and half of it.
template <typename Error>
double slope(const Error& error, double t) {
  return std::log2(error(t) / error(t / 2));
}

/// Of the radius.
template <typename Step>
Rows order_rows(const std::string& name, const Step& step, double t, Published a_step, Reference half_a_turn) {
  const auto one = [&](double h) { return radius_error(step, h, 1); };
  const auto half = [&](double h) { return radius_error(step, h, std::floor(std::numbers::pi / h)); };
  Row each = exact_row("exponent of T, each step", {"", 0}, a_step, slope(one, t));
  each.why = decimal(slope(one, t), 3) + ", from T = " + decimal(t, 3) + " to half of it";
  Row turn = exact_row("exponent of T, half a turn", {"", 0}, half_a_turn, slope(half, t));
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
  constexpr Published published(4, {Paper::software_interpolator, "below eq. 27"});
  Row order = expecting(
      reproduced_row("exponent of T, greatest of a turn", {"", 2}, published, slope(eq27_error, 1e-3), 0.05), 1);
  order.why = "x² − Txy + y² stays what it is: an ellipse, T/4 off the circle, that never grows";
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

/// Distance from where one exact step leads, by R.
template <typename Step>
double place_error(const Step& step, double t) {
  const CirclePoint<double> from, at = step(from, t);
  return std::hypot(at.x / from.x - std::cos(t), at.y / from.x - std::sin(t));
}

template <typename Step>
Row place_order_row(const Step& step, Reference published) {
  constexpr double t = 0.1;
  const double order = slope([&](double h) { return place_error(step, h); }, t);
  return because(exact_row("exponent of T, place after each step", {"", 0}, published, order),
                 decimal(order, 3) + ", from T = 0.1 to half of it");
}

/// Its radius has no order: |A + iB| = 1 whatever T.
Rows tustin_order_rows() {
  constexpr Published as_heuns(4, {Paper::software_interpolator, "below eq. 25, by the order told of eq. 24"});
  Row order = expecting(place_order_row(tustin<double>, as_heuns), 3);
  order.why +=
      "; told to be of the order of eq. 24, T⁴ of the radius: this radius has no error, and the place has T³ by both";
  const double error = radius_error(tustin<double>, 0.1, 63);
  return under("Tustin, eq. 25",
               {std::move(order), because(limit_row("error of the radius after a turn", {"R", 3}, 0, error, 1e-14),
                                          "T = 0.1; A² + B² = 1")});
}

// ---------------------------------------------------------------------------------------------------------------------

/// The growth of the radius and the angle that a method takes for each step, in closed form: A + iB = growth e^(i angle).
struct ClosedForm {
  double growth = 1, angle = 0;
};

/// A turn of 10 mm at 100 mm/s as reference words, one each T: a word is the one before it turned by a method's step.
template <typename Step>
Rows word_rows(const std::string& equations, const Step& step, double period, const ClosedForm& each) {
  constexpr double feed = 100, micrometres_in_mm = 1000;  // mm/s
  constexpr Scale micrometres = {"µm", 4};
  const CirclePoint<double> from;
  const double radius = from.x, t = feed * period / radius, count = std::floor(2 * std::numbers::pi / t);
  CirclePoint<double> at = from, next = step(from, t);
  const double chord = std::hypot(next.x - from.x, next.y - from.y);
  for (double n = 0; n < count; ++n) at = step(at, t);
  const double turned = std::remainder(std::atan2(at.y, at.x) - count * t, 2 * std::numbers::pi);
  const double growth = std::pow(each.growth, count) - 1;
  const double first_chord = std::sqrt(1 + each.growth * each.growth - 2 * each.growth * std::cos(each.angle));
  constexpr double rounding = 1e-6;
  return under(
      "words of a circle of 10 mm, 100 mm/s, T " + decimal(1000 * period, 0) + " ms, " + equations,
      {exact_row("radius after a turn, off R", micrometres, radius * growth * micrometres_in_mm,
                 (std::hypot(at.x, at.y) - radius) * micrometres_in_mm, rounding),
       exact_row("place after a turn, ahead along the circle", micrometres,
                 radius * count * (each.angle - t) * micrometres_in_mm, radius * turned * micrometres_in_mm, rounding),
       exact_row("feed by the chord, off the programmed", {"%", 5}, 100 * (first_chord / t - 1),
                 100 * (chord / (feed * period) - 1), rounding)});
}

Rows circle_word_rows() {
  Rows rows;
  for (const double period : {0.001, 0.010}) {
    const double t = 10 * period;
    append(rows, word_rows("eq. 22", state_transition<double>, period, {1, t}));
    append(rows,
           word_rows("eqs. 23 and 24", heun, period, {std::sqrt(1 + t * t * t * t / 4), std::atan2(t, 1 - t * t / 2)}));
    append(rows, word_rows("eqs. 24 and 25", tustin<double>, period, {1, 2 * std::atan(t / 2)}));
  }
  return rows;
}

}  // namespace

Rows orders_rows(const Host&) {
  constexpr Paper paper = Paper::software_interpolator;
  Rows rows =
      order_rows("Euler", euler<double>, 0.001, {2, {paper, "below eq. 27"}}, Published(1, {paper, "below eq. 26"}));
  append(rows, order_rows("Heun, eq. 23", heun, 0.01, {4, {paper, "below eq. 24"}}, 3));
  append(rows, under("Heun, eq. 23", {place_order_row(heun, 3)}));
  append(rows, tustin_order_rows());
  const auto classical = [](const CirclePoint<double>& at, double t) { return runge_kutta<double>(at.x, at.y, t); };
  append(rows, order_rows("Runge-Kutta", classical, 0.1, {6, {paper, "below eq. 25"}}, 5));
  append(rows, eq27_rows());
  append(rows, circle_word_rows());
  return rows;
}

}  // namespace leadscrew::study
