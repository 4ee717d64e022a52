#include <leadscrew/study/butterfly.hpp>
#include <leadscrew/study/optima.hpp>

namespace leadscrew::study {

namespace {

constexpr LimitSet quick = {200, 1000, 20000};
constexpr LimitSet gentle = {200, 200, 5000};

PartProgram cubic_program(double feed) {
  return program_of(plane_cubic(), feed);
}
PartProgram butterfly_program(double feed) {
  return program_of(butterfly(), feed);
}
PartProgram circle_of_ten(double feed) {
  return circle_program(10, feed);
}

/// What the bound's own discretisation may be off, relative (planner::TimeBound).
constexpr double bound_accuracy = 1e-4;

}  // namespace

const OptimumPath& cubic_optima() {
  static const OptimumPath path = {"plane cubic",
                                   cubic_program,
                                   {{{10, quick, 2.994, 3.0277, 3, 4},
                                     {100, quick, 0.4085, 0.469, 4, 3},
                                     {10, gentle, 3.032, 3.0715, 3, 4},
                                     {100, gentle, 0.819, 0.861, 3, 3}}}};
  return path;
}

const OptimumPath& circle_optima() {
  static const OptimumPath path = {"circle R 10 mm",
                                   circle_of_ten,
                                   {{{10, quick, 6.293, 6.328, 3, 3},
                                     {100, quick, 0.727, 0.783, 3, 3},
                                     {10, gentle, 6.333, 6.373, 3, 3},
                                     {100, gentle, 1.597, 1.637, 3, 3}}}};
  return path;
}

const OptimumPath& butterfly_optima() {
  static const OptimumPath path = {"butterfly",
                                   butterfly_program,
                                   {{{10, quick, 38.31, 38.38, 2, 2},
                                     {100, quick, 5.026, 5.359, 3, 3, "; on ever finer knots it falls to 5.0231 s"},
                                     {10, gentle, 38.50, 38.56, 2, 2},
                                     {100, gentle, 9.907, 10.03, 3, 2, "; on ever finer knots it falls to 9.8990 s"}}}};
  return path;
}

std::string circumstances(const OptimumPath& path, const Optimum& optimum) {
  return std::string(path.name) + ", F " + decimal(optimum.feed, 0) + " mm/s, a " +
         decimal(optimum.limits.acceleration, 0) + " mm/s², j " + decimal(optimum.limits.jerk, 0) + " mm/s³";
}

Rows time_rows(const Optimum& optimum, double seconds, double bound_seconds) {
  Row time = at_most_row("time", {"s", optimum.optimum_decimals}, optimum.optimum, seconds,
                         optimum_accuracy * optimum.optimum);
  time.why = "expected: numerical optimum T3*, good to 0.2 %";
  const Row ratio = at_most_row("time over optimum", {"", 4}, 1, seconds / optimum.optimum, optimum_accuracy);
  Row bound = exact_row("least time without a limit of jerk", {"s", optimum.bound_decimals}, optimum.bound,
                        bound_seconds, bound_accuracy * optimum.bound);
  bound.why = "expected: T2" + std::string(optimum.bound_note);
  return {time, ratio, bound};
}

}  // namespace leadscrew::study
