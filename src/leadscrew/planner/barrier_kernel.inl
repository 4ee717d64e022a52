// The kernel itself: included by barrier_kernels.cpp once for each kind of processor. All functions are of this
// namespace, and inline in one: none that is compiled for a processor that not everybody has may be taken for one of
// another source.

#define LEADSCREW_LANEWISE [[gnu::always_inline]] inline

typedef double Vector __attribute__((vector_size(32)));
typedef long long Mask __attribute__((vector_size(32)));

LEADSCREW_LANEWISE Vector all(double value) {
  return Vector{value, value, value, value};
}
LEADSCREW_LANEWISE Vector load(const Lanes& from) {
  Vector vector;
  __builtin_memcpy(&vector, &from, sizeof vector);
  return vector;
}
LEADSCREW_LANEWISE void store(Lanes& to, const Vector& vector) {
  __builtin_memcpy(&to, &vector, sizeof vector);
}
LEADSCREW_LANEWISE double sum_of(const Vector& v) {
  return (v[0] + v[2]) + (v[1] + v[3]);
}
#if defined(LEADSCREW_WIDE)
LEADSCREW_LANEWISE bool any(const Mask& mask) {
  return _mm256_movemask_pd((__m256d)mask) != 0;
}
LEADSCREW_LANEWISE Vector root(const Vector& v) {
  return _mm256_sqrt_pd(v);
}
#else
LEADSCREW_LANEWISE bool any(const Mask& mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
LEADSCREW_LANEWISE Vector root(const Vector& v) {
  return Vector{__builtin_sqrt(v[0]), __builtin_sqrt(v[1]), __builtin_sqrt(v[2]), __builtin_sqrt(v[3])};
}
#endif
LEADSCREW_LANEWISE Vector smaller(const Vector& a, const Vector& b) {
  return a < b ? a : b;
}
LEADSCREW_LANEWISE Vector greater(const Vector& a, const Vector& b) {
  return a > b ? a : b;
}

/// The rows of four coefficients, one for each lane.
LEADSCREW_LANEWISE Vector along(const std::array<Lanes, 4>& by, const std::array<Vector, 4>& c) {
  return (load(by[0]) * c[0] + load(by[1]) * c[1]) + (load(by[2]) * c[2] + load(by[3]) * c[3]);
}

LEADSCREW_LANEWISE std::array<Vector, 4> loaded(const std::array<Lanes, 4>& by) {
  return {load(by[0]), load(by[1]), load(by[2]), load(by[3])};
}

/// What A² and g² are multiplied by at a place.
LEADSCREW_LANEWISE Vector multiples(double x) {
  return Vector{1, x, 1, x};
}

/// −Σ log of factors, lane by lane, by few logarithms of products.
struct Logarithms {
  Vector product = {1, 1, 1, 1};
  double sum = 0;
  WeighedLogarithms weighed;

  LEADSCREW_LANEWISE void take(const Vector& factors) { product *= factors; }
  /// The places of an interval that have caps, if it is inside them.
  LEADSCREW_LANEWISE void take(const Vector& factors, std::uint8_t weight) {
    const double both = factors[SpeedProblem::middle_place] * factors[SpeedProblem::end_place];
    if (both > 0) weighed.take(both, weight);
  }
  /// Before a product may fall below the smallest double.
  LEADSCREW_LANEWISE void settle() {
    const Vector small = all(1e-60);
    if (any(product < small)) flush();
  }
  void flush() {
    for (std::size_t lane = 0; lane < 4; ++lane) sum -= numeric::log(product[lane]);
    product = all(1);
  }
};

bool measure(const BarrierTerms& terms, std::span<const double> c, BarrierValues& values) {
  Logarithms logarithms;
  Vector time = {};
  const Vector none = {}, one = all(1), time_weights = load(terms.time_weights);
  std::size_t next = 0;
  for (std::size_t k = 0; k < terms.places.size(); ++k) {
    const std::array<Vector, 4> at = {all(c[k]), all(c[k + 1]), all(c[k + 2]), all(c[k + 3])};
    const Vector x = along(terms.places[k], at), free = one - x * load(terms.inverse_caps[k]);
    store(values.places[k], x);
    Mask inside = (x > none) & (free > none);
    time += all(terms.basis[k].h) * time_weights / root(x);
    const std::uint8_t weight = terms.weight(k);
    if (weight == 0) {
      logarithms.take(free);
    } else {
      logarithms.take(free, weight);
    }
    for (; next < terms.sites.size() && terms.sites[next].interval == k; ++next) {
      const SpeedProblem::Site& site = terms.sites[next];
      const double square = site.place >= 0 ? x[site.place] : dot(site.x, &c[k]);
      const Vector scale = all(terms.factors[next]) * multiples(square);
      values.squares[next] = square;
      inside &= all(square) > none;
      for (std::size_t block = site.first_block; block < site.end_block; ++block) {
        const Vector y = along(terms.blocks[block].by, at), free_of = one - scale * y * y;
        store(values.rows[block], y);
        inside &= free_of > none;
        logarithms.take(free_of);
        logarithms.settle();
      }
    }
    if (any(~inside)) {
      values.outside = k;
      return false;
    }
    logarithms.settle();
  }
  logarithms.flush();
  values.time = sum_of(time);
  values.barrier = logarithms.sum + logarithms.weighed.sum();
  return true;
}

/// Of one interval, lane by lane: Σ over the lanes is the gradient and the lower triangle of the Hessian by rows.
struct Local {
  std::array<Vector, 4> gradient{};
  std::array<Vector, 10> hessian{};

  LEADSCREW_LANEWISE void slope(const std::array<Vector, 4>& by, const Vector& weight) {
    gradient[0] += weight * by[0];
    gradient[1] += weight * by[1];
    gradient[2] += weight * by[2];
    gradient[3] += weight * by[3];
  }
  LEADSCREW_LANEWISE void bend(const std::array<Vector, 4>& by, const Vector& weight) {
    const Vector first = weight * by[0], second = weight * by[1], third = weight * by[2], fourth = weight * by[3];
    hessian[0] += first * by[0];
    hessian[1] += second * by[0];
    hessian[2] += second * by[1];
    hessian[3] += third * by[0];
    hessian[4] += third * by[1];
    hessian[5] += third * by[2];
    hessian[6] += fourth * by[0];
    hessian[7] += fourth * by[1];
    hessian[8] += fourth * by[2];
    hessian[9] += fourth * by[3];
  }
};

void assemble(const BarrierTerms& terms, double t, const BarrierValues& values, const BarrierDuals& duals,
              std::span<LocalModel> models) {
  const Vector one = all(1), of_jerk = {0, 1, 0, 1}, time_weights = load(terms.time_weights);
  const Vector middle = {0, 1, 0, 0}, end = {0, 0, 0, 1};  // SpeedProblem::middle_place, end_place
  std::size_t next = 0;
  for (std::size_t k = 0; k < terms.places.size(); ++k) {
    Local local;
    const Vector x = load(values.places[k]), inverse = one / x, cap = load(terms.inverse_caps[k]);
    const Vector part = all(t * terms.basis[k].h) * time_weights * (inverse / root(x));
    const Vector kept = all(planner::cap_weights[terms.weight(k)]) * cap / (one - x * cap);
    Vector slope = kept - all(0.5) * part;
    Vector bend = all(terms.time_curvature) * part * inverse + load(duals.places[k]) * cap * kept;
    if (!terms.excess.empty()) {
      slope += load(terms.excess[k].slope);
      bend += load(terms.excess[k].curvature);
    }
    for (; next < terms.sites.size() && terms.sites[next].interval == k; ++next) {
      const SpeedProblem::Site& site = terms.sites[next];
      const double square = values.squares[next], ff = terms.factors[next];
      const Vector w = multiples(square), inverse_w = multiples(1 / square);
      const std::array<Vector, 4> e = {all(site.x[0]), all(site.x[1]), all(site.x[2]), all(site.x[3])};
      Vector slope_by_x = {}, bend_by_x = {};
      for (std::size_t block = site.first_block; block < site.end_block; ++block) {
        const std::array<Vector, 4> by = loaded(terms.blocks[block].by);
        const Vector y = load(values.rows[block]), dual = load(duals.rows[block]);
        const Vector fw = all(ff) * w, u = fw * y * y, more = one + u, both = one / ((one - u) * more);
        const Vector inverse_free = more * both, inverse_more = (one - u) * both;
        const Vector of_place = of_jerk * (y * inverse_w * inverse_more);
        const Vector curvature = all(2) * fw * dual * (more * inverse_free);
        local.slope(by, all(2) * fw * y * inverse_free);
        slope_by_x += of_jerk * (u * inverse_w * inverse_free);
        bend_by_x += of_jerk * (dual * u * u * inverse_w * inverse_w * inverse_more);
        local.bend({by[0] + of_place * e[0], by[1] + of_place * e[1], by[2] + of_place * e[2], by[3] + of_place * e[3]},
                   curvature);
      }
      if (site.place >= 0) {
        const Vector lane = site.place == SpeedProblem::middle_place ? middle : end;
        slope += lane * all(sum_of(slope_by_x));
        bend += lane * all(sum_of(bend_by_x));
      } else {
        local.slope(e, slope_by_x);
        local.bend(e, bend_by_x);
      }
    }
    const std::array<Vector, 4> by = loaded(terms.places[k]);
    local.slope(by, slope);
    local.bend(by, bend);
    for (std::size_t i = 0; i < 4; ++i) models[k].gradient[i] = sum_of(local.gradient[i]);
    for (std::size_t i = 0; i < 10; ++i) models[k].hessian[i] = sum_of(local.hessian[i]);
  }
}

/// Newton's step of λ·free = 1, `change` what the whole step changes u by; kept near what it is at a centre there.
LEADSCREW_LANEWISE Vector stepped(const Vector& dual, const Vector& free_before, const Vector& change,
                                  const Vector& free_after) {
  const Vector wanted = (all(1) + dual * change) / free_before, middle = all(1) / free_after;
  return smaller(greater(wanted, all(least_dual) * middle), all(greatest_dual) * middle);
}

void step_duals(const BarrierTerms& terms, const BarrierValues& before, const BarrierValues& after, double share,
                BarrierDuals& duals) {
  const Vector one = all(1), of_jerk = {0, 1, 0, 1}, longer = all(1 / share);
  for (std::size_t k = 0; k < terms.places.size(); ++k) {
    const Vector x = load(before.places[k]), there = load(after.places[k]), cap = load(terms.inverse_caps[k]);
    store(duals.places[k],
          stepped(load(duals.places[k]), one - x * cap, cap * (there - x) * longer, one - there * cap));
  }
  for (std::size_t i = 0; i < terms.sites.size(); ++i) {
    const SpeedProblem::Site& site = terms.sites[i];
    const Vector ff = all(terms.factors[i]), w = ff * multiples(before.squares[i]);
    const Vector w_there = ff * multiples(after.squares[i]);
    const Vector of_place = ff * of_jerk * all(after.squares[i] - before.squares[i]);
    for (std::size_t block = site.first_block; block < site.end_block; ++block) {
      const Vector y = load(before.rows[block]), there = load(after.rows[block]);
      const Vector change = y * (all(2) * w * (there - y) + of_place * y) * longer;
      store(duals.rows[block],
            stepped(load(duals.rows[block]), one - w * y * y, change, one - w_there * there * there));
    }
  }
}

void center_duals(const BarrierTerms& terms, const BarrierValues& at, BarrierDuals& duals) {
  const Vector one = all(1);
  for (std::size_t k = 0; k < terms.places.size(); ++k)
    store(duals.places[k], one / (one - load(at.places[k]) * load(terms.inverse_caps[k])));
  for (std::size_t i = 0; i < terms.sites.size(); ++i) {
    const SpeedProblem::Site& site = terms.sites[i];
    const Vector w = all(terms.factors[i]) * multiples(at.squares[i]);
    for (std::size_t block = site.first_block; block < site.end_block; ++block) {
      const Vector y = load(at.rows[block]);
      store(duals.rows[block], one / (one - w * y * y));
    }
  }
}

#undef LEADSCREW_LANEWISE
