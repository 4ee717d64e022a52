#pragma once
// The least times known for three paths, from rest to rest, each axis within v = 200 mm/s and its acceleration and
// jerk: a hard lower bound without a limit of jerk (T2), and a numerical optimum with it (T3*), good to 0.2 %.

#include <array>
#include <leadscrew/study/curves.hpp>
#include <leadscrew/study/motion.hpp>
#include <leadscrew/study/row.hpp>
#include <string>
#include <string_view>

namespace leadscrew::study {

struct Optimum {
  double feed = 0;  ///< mm/s
  LimitSet limits;
  double bound = 0;                              ///< T2, s
  double optimum = 0;                            ///< T3*, s
  int bound_decimals = 0, optimum_decimals = 0;  ///< that are known
  std::string_view bound_note = {};              ///< what else is known of T2
};

inline constexpr double optimum_accuracy = 0.002;  ///< of T3*, relative

struct OptimumPath {
  std::string_view name;
  PartProgram (*program)(double feed);  ///< mm/s
  std::array<Optimum, 4> optima;
};

const OptimumPath& cubic_optima();
const OptimumPath& circle_optima();  ///< R = 10 mm
const OptimumPath& butterfly_optima();

/// "plane cubic, F 10 mm/s, a 1000 mm/s², j 20000 mm/s³"
std::string circumstances(const OptimumPath& path, const Optimum& optimum);

/// Our time beside T3*, its ratio, and our bound beside T2.
Rows time_rows(const Optimum& optimum, double seconds, double bound_seconds);

}  // namespace leadscrew::study
