#pragma once
// Jets: a value and its first N derivatives by one parameter, carried together through arithmetic. What geometry says
// of a curve and kinematics makes of it is said in jets, so that velocity, acceleration and jerk need no finite
// differences. Jet<> has three derivatives in double and names for them; other orders and scalars follow the same
// rules, Leibniz' for products and recursions of it for what is defined by an equation (Griewank and Walther,
// "Evaluating Derivatives", ch. 13).

#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/pair.hpp>

namespace leadscrew::numeric {

/// f, f′, … of order N at one parameter value.
template <std::size_t N = 3, typename T = double>
struct Jet {
  std::array<T, N + 1> derivative{};  ///< of order 0 … N

  constexpr Jet() = default;
  constexpr Jet(T constant) { derivative[0] = constant; }  // NOLINT: a constant is a jet

  /// The parameter itself, at u.
  static constexpr Jet parameter(T u) {
    Jet jet = u;
    if constexpr (N > 0) jet.derivative[1] = T(1);
    return jet;
  }

  constexpr const T& operator[](std::size_t order) const { return derivative[order]; }
  constexpr T& operator[](std::size_t order) { return derivative[order]; }

  // Equal where all derivatives are, ordered by value.
  friend constexpr bool operator==(const Jet&, const Jet&) = default;
  friend constexpr bool operator<(const Jet& a, const Jet& b) { return a[0] < b[0]; }
  friend constexpr bool operator>(const Jet& a, const Jet& b) { return b[0] < a[0]; }
  friend constexpr bool operator<=(const Jet& a, const Jet& b) { return a[0] <= b[0]; }
  friend constexpr bool operator>=(const Jet& a, const Jet& b) { return b[0] <= a[0]; }

  friend constexpr Jet operator-(const Jet& a) {
    Jet result;
    for (std::size_t k = 0; k <= N; ++k) result[k] = -a[k];
    return result;
  }
  friend constexpr Jet operator+(const Jet& a, const Jet& b) {
    Jet result;
    for (std::size_t k = 0; k <= N; ++k) result[k] = a[k] + b[k];
    return result;
  }
  friend constexpr Jet operator-(const Jet& a, const Jet& b) { return a + (-b); }
  friend constexpr Jet operator*(const Jet& a, const Jet& b) {
    Jet result;
    for (std::size_t k = 0; k <= N; ++k) result[k] = product_derivative(a, b, k, 0, k);
    return result;
  }
  /// b's value ≠ 0.
  friend constexpr Jet operator/(const Jet& a, const Jet& b) { return quotient(a, b); }
};

/// The same with names, for the order that motion needs: position, velocity, acceleration, jerk.
template <typename T>
struct Jet<3, T> {
  T value{}, first{}, second{}, third{};

  constexpr Jet() = default;
  constexpr Jet(T constant) : value(constant) {}  // NOLINT: a constant is a jet
  constexpr Jet(T f, T f1, T f2, T f3) : value(f), first(f1), second(f2), third(f3) {}

  /// The parameter itself, at u.
  static constexpr Jet parameter(T u) { return {u, all<T>(1), T{}, T{}}; }

  constexpr const T& operator[](std::size_t order) const {
    return order == 0 ? value : order == 1 ? first : order == 2 ? second : third;
  }
  constexpr T& operator[](std::size_t order) {
    return order == 0 ? value : order == 1 ? first : order == 2 ? second : third;
  }

  // Equal where all derivatives are, ordered by value.
  friend constexpr bool operator==(const Jet&, const Jet&) = default;
  friend constexpr bool operator<(const Jet& a, const Jet& b) { return a.value < b.value; }
  friend constexpr bool operator>(const Jet& a, const Jet& b) { return b.value < a.value; }
  friend constexpr bool operator<=(const Jet& a, const Jet& b) { return a.value <= b.value; }
  friend constexpr bool operator>=(const Jet& a, const Jet& b) { return b.value <= a.value; }

  friend constexpr Jet operator-(const Jet& a) { return {-a.value, -a.first, -a.second, -a.third}; }
  friend constexpr Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second, a.third + b.third};
  }
  friend constexpr Jet operator-(const Jet& a, const Jet& b) { return a + (-b); }
  friend constexpr Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second,
            a.third * b.value + 3 * a.second * b.first + 3 * a.first * b.second + a.value * b.third};
  }
  /// b.value ≠ 0.
  friend constexpr Jet operator/(const Jet& a, const Jet& b) { return a * reciprocal(b); }
};

// ---------------------------------------------------------------------------------------------------------------------

/// Of Leibniz' sum for the derivative of this order of a·b, the terms that have a's derivatives from … to.
template <std::size_t N, typename T>
constexpr T product_derivative(const Jet<N, T>& a, const Jet<N, T>& b, std::size_t order, std::size_t from,
                               std::size_t to) {
  T sum{};
  double binomial = 1;
  for (std::size_t k = 0; k <= to; ++k) {
    if (k >= from) sum = sum + a[k] * b[order - k] * T(binomial);
    binomial = binomial * static_cast<double>(order - k) / static_cast<double>(k + 1);
  }
  return sum;
}

/// a/b, from q·b = a.
template <std::size_t N, typename T>
constexpr Jet<N, T> quotient(const Jet<N, T>& a, const Jet<N, T>& b) {
  Jet<N, T> q;
  for (std::size_t k = 0; k <= N; ++k) {
    const T known = k > 0 ? product_derivative(q, b, k, 0, k - 1) : T{};
    q[k] = (a[k] - known) / b[0];
  }
  return q;
}

/// h(f), given h and its derivatives at f.value (Faà di Bruno's formula).
template <typename T>
constexpr Jet<3, T> compose(const Jet<3, T>& h, const Jet<3, T>& f) {
  return {h.value, h.first * f.first, h.second * f.first * f.first + h.first * f.second,
          h.third * f.first * f.first * f.first + 3 * h.second * f.first * f.second + h.first * f.third};
}

/// f.value ≠ 0.
template <typename T>
constexpr Jet<3, T> reciprocal(const Jet<3, T>& f) {
  const T r = 1 / f.value;
  return compose<T>({r, -r * r, 2 * r * r * r, -6 * r * r * r * r}, f);
}

/// The derivative of f, the highest order of which is not known and left at 0.
template <std::size_t N, typename T>
constexpr Jet<N, T> differentiated(const Jet<N, T>& f) {
  Jet<N, T> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = f[k + 1];
  return result;
}
/// What has this value and this derivative.
template <std::size_t N, typename T>
constexpr Jet<N, T> integrated(T value, const Jet<N, T>& derivative) {
  Jet<N, T> result = value;
  for (std::size_t k = 0; k < N; ++k) result[k + 1] = derivative[k];
  return result;
}

template <typename T>
Jet<3, T> sin(const Jet<3, T>& f) {
  const T s = sin(f.value), c = cos(f.value);
  return compose<T>({s, c, -s, -c}, f);
}
template <typename T>
Jet<3, T> cos(const Jet<3, T>& f) {
  const T s = sin(f.value), c = cos(f.value);
  return compose<T>({c, -s, -c, s}, f);
}

/// f.value > 0.
template <typename T>
Jet<3, T> sqrt(const Jet<3, T>& f) {
  using std::sqrt;
  const T root = sqrt(f.value);
  return compose<T>({root, 0.5 / root, -0.25 / (root * f.value), 0.375 / (root * f.value * f.value)}, f);
}

/// Sine and cosine of any order, from s′ = c f′ and c′ = −s f′.
template <std::size_t N, typename T>
struct SineCosine {
  Jet<N, T> sine, cosine;
};
/// Given both of f's value.
template <std::size_t N, typename T>
SineCosine<N, T> sine_cosine_from(T sine_of_value, T cosine_of_value, const Jet<N, T>& f) {
  SineCosine<N, T> result{sine_of_value, cosine_of_value};
  const Jet<N, T> rate = differentiated(f);
  for (std::size_t k = 0; k < N; ++k) {
    const T sine = product_derivative(result.cosine, rate, k, 0, k);
    const T cosine = -product_derivative(result.sine, rate, k, 0, k);
    result.sine[k + 1] = sine;
    result.cosine[k + 1] = cosine;
  }
  return result;
}
template <std::size_t N, typename T>
SineCosine<N, T> sine_cosine(const Jet<N, T>& f) {
  return sine_cosine_from<N, T>(sin(f[0]), cos(f[0]), f);
}
template <std::size_t N, typename T>
Jet<N, T> sin(const Jet<N, T>& f) {
  return sine_cosine(f).sine;
}
template <std::size_t N, typename T>
Jet<N, T> cos(const Jet<N, T>& f) {
  return sine_cosine(f).cosine;
}

/// The root of a square of which one root's value is known: from r·r = square. root ≠ 0.
template <std::size_t N, typename T>
constexpr Jet<N, T> root_of(const Jet<N, T>& square, T root) {
  Jet<N, T> r = root;
  for (std::size_t k = 1; k <= N; ++k) {
    const T known = k > 1 ? product_derivative(r, r, k, 1, k - 1) : T{};
    r[k] = (square[k] - known) / (root + root);
  }
  return r;
}
/// f's value > 0.
template <std::size_t N, typename T>
Jet<N, T> sqrt(const Jet<N, T>& f) {
  using std::sqrt;
  return root_of<N, T>(f, sqrt(f[0]));
}

/// √(x² + y²) and √(x² + y² + z²); not both or all 0.
template <std::size_t N, typename T>
Jet<N, T> hypot(const Jet<N, T>& x, const Jet<N, T>& y) {
  return root_of<N, T>(x * x + y * y, hypot(x[0], y[0]));
}
template <std::size_t N, typename T>
Jet<N, T> hypot(const Jet<N, T>& x, const Jet<N, T>& y, const Jet<N, T>& z) {
  return root_of<N, T>(x * x + y * y + z * z, hypot(x[0], y[0], z[0]));
}

/// The angle of (x, y), radians, −π … π: θ′ = (x y′ − y x′)/(x² + y²). Not both 0.
template <std::size_t N, typename T>
Jet<N, T> atan2(const Jet<N, T>& y, const Jet<N, T>& x) {
  const Jet<N, T> turning = x * differentiated(y) - y * differentiated(x);
  return integrated<N, T>(atan2(y[0], x[0]), quotient(turning, x * x + y * y));
}

/// Radians, 0 … π: −f′/√((1 − f)(1 + f)). |f's value| < 1.
template <std::size_t N, typename T>
Jet<N, T> acos(const Jet<N, T>& f) {
  using std::sqrt;
  const Jet<N, T> one = T(1), square = (one - f) * (one + f);
  return integrated<N, T>(acos(f[0]), quotient(-differentiated(f), root_of<N, T>(square, sqrt(square[0]))));
}

}  // namespace leadscrew::numeric
