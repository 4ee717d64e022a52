#pragma once
// Where a published figure stands: the paper, and the table, equation or section in it.

#include <cstdint>
#include <string_view>

namespace leadscrew::study {

enum class Paper : std::uint8_t {
  software_interpolator,    ///< Koren, "Interpolator for a Computer Numerical Control System"
  real_time_interpolators,  ///< Lin and Koren, "Real-Time Interpolators for Multi-Axis CNC Machine Tools"
  linear_interpolators,     ///< Roy Choudhury, "Interpolators Linear", lecture 12
  fpga_interpolation,       ///< Gao, Lou, Ye and Wu, "FPGA-based implementation of circular interpolation"
  digital_integrals,  ///< Yang and others, "Design and Implementation of Digital Integral Interpolator Based on LabVIEW"
};

struct Citation {
  std::string_view authors;  ///< such as "Lin and Koren"
  std::string_view title;
};
Citation citation(Paper paper);

/// Not constant: no source without its place compiles.
void source_without_its_place();

struct Source {
  Paper paper;
  std::string_view where;  ///< such as "Table I", "eq. 21"; not empty; static storage

  consteval Source(Paper of, std::string_view place) : paper(of), where(place) {
    if (place.empty()) source_without_its_place();
  }
};

/// A figure that the source prints, or that follows by arithmetic from what it prints.
struct Published {
  double value;
  Source source;

  constexpr Published(double figure, Source printed) : value(figure), source(printed) {}
};

}  // namespace leadscrew::study
