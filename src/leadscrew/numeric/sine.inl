// Sine and cosine by sums and products alone, for whatever `Vector` is where this is included: double, or a vector of
// doubles; `Mask` is the whole number of the same size, or a vector of those. Each lane does the same operations in the
// same order, none of them fused, so that every number has the same bits alone and in a vector, and on every processor.
//
// Reduction: r = θ − k π/2 with the whole number k nearest to θ · 2/π, after Cody and Waite ("Software Manual for the
// Elementary Functions", 1980, ch. 8). π/2 is taken in four parts, the first three of at most 33 bits: k ≤ 2²⁰ times each
// is exact, and so are the differences wherever θ lies so close to k π/2 that they cancel. What remains has an error
// below 2⁻⁶⁰ of itself for every θ up to 2²⁰.
//
// With z = r² and the polynomials p and q, of least greatest relative error for |r| ≤ π/4 (Remez; each coefficient
// rounded before the next are sought; 2⁻⁵⁷·⁹ and 2⁻⁶³·⁹):
//
//     sin(r + l) = r + (r z p(z) + l (1 − z/2))        cos(r + l) = 1 − z/2 + (z² q(z) − r l)
//
// The rounding error of 1 − z/2 is added to the rest, as in fdlibm's kernel_cos (Sun Microsystems, 1993).

/// θ less a multiple of π/2: angle + low, |angle| ≤ π/4 but for rounding; the quadrant counts modulo 4.
struct ReducedAngle {
  Vector angle, low;
  Mask quadrant;
};

struct VectorSines {
  Vector sine, cosine;
  Vector cosine_less_one;  ///< with a relative error of two roundings, where |θ| ≤ π/4; elsewhere without meaning
};

/// Of angle + low, |angle| ≤ 2²⁰, |low| far below 1: what it adds is right to low².
[[gnu::always_inline]] inline ReducedAngle reduce(Vector angle, Vector low) {
  constexpr double quadrants_of_radian = 0x1.45f306dc9c883p-1;
  constexpr double whole = 0x1.8p52;  // added to a small number, leaves it rounded to a whole one in the last bits
  constexpr double part_1 = 0x1.921fb544p+0, part_2 = 0x1.0b4611a6p-34, part_3 = 0x1.3198a2ep-69,
                   part_4 = 0x1.b839a252049c1p-104;
  const Vector shifted = angle * quadrants_of_radian + whole;
  const Vector k = shifted - whole;
  const Vector first = angle - k * part_1;
  const Vector second_part = k * part_2;
  const Vector second = first - second_part;
  const Vector third_part = k * part_3 - ((first - second) - second_part);
  const Vector third = second - third_part;
  return {third, (((second - third) - third_part) - k * part_4) + low, __builtin_bit_cast(Mask, shifted)};
}

/// Its first 26 bits.
[[gnu::always_inline]] inline Vector high_half(Vector value) {
  constexpr long long low_bits = (1LL << 27) - 1;
  return __builtin_bit_cast(Vector, __builtin_bit_cast(Mask, value) & ~low_bits);
}

/// Negated where the sign's first bit is set.
[[gnu::always_inline]] inline Vector with_sign(Vector value, Mask sign) {
  return __builtin_bit_cast(Vector, __builtin_bit_cast(Mask, value) ^ sign);
}

[[gnu::always_inline]] inline VectorSines sines_of(const ReducedAngle& reduced) {
  constexpr double p0 = -0x1.5555555555549p-3, p1 = 0x1.111111110f87cp-7, p2 = -0x1.a01a019c0e99ep-13,
                   p3 = 0x1.71de3573aedd4p-19, p4 = -0x1.ae5e627603ef6p-26, p5 = 0x1.5d91d003fe691p-33;
  constexpr double q0 = 0x1.555555555554bp-5, q1 = -0x1.6c16c16c15013p-10, q2 = 0x1.a01a019c8ed3cp-16,
                   q3 = -0x1.27e4f7f146775p-22, q4 = 0x1.1ee9db93f2548p-29, q5 = -0x1.8fa6629417704p-37;
  const Vector r = high_half(reduced.angle), l = (reduced.angle - r) + reduced.low, half_l = 0.5 * l;
  const Vector z = r * r, z_z = z * z, half_z = 0.5 * z, near_cosine = 1.0 - half_z;
  const Vector p = p0 + (z * p1 + z_z * ((p2 + z * p3) + z_z * (p4 + z * p5)));
  const Vector q = q0 + (z * q1 + z_z * ((q2 + z * q3) + z_z * (q4 + z * q5)));
  const Vector sine_rest = (z * r) * p, cosine_rest = z_z * q;
  const Vector sine_of_r = r + sine_rest, cosine_of_r = near_cosine + cosine_rest;
  const Vector sine = r + (sine_rest + l * (cosine_of_r - half_l * sine_of_r));
  const Vector rest = cosine_rest - l * (sine_of_r + half_l * cosine_of_r);
  const Vector cosine = near_cosine + (((1.0 - near_cosine) - half_z) + rest);
  const auto is_odd = (reduced.quadrant & 1) != 0;
  const Mask sine_sign = (reduced.quadrant & 2) << 62, cosine_sign = ((reduced.quadrant + 1) & 2) << 62;
  return {with_sign(is_odd ? cosine : sine, sine_sign), with_sign(is_odd ? sine : cosine, cosine_sign), rest - half_z};
}
