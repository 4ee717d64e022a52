#include <leadscrew/study/source.hpp>

namespace leadscrew::study {

Citation citation(Paper paper) {
  switch (paper) {
    case Paper::software_interpolator:
      return {"Koren", "Interpolator for a Computer Numerical Control System"};
    case Paper::real_time_interpolators:
      return {"Lin and Koren", "Real-Time Interpolators for Multi-Axis CNC Machine Tools"};
    case Paper::linear_interpolators:
      return {"Roy Choudhury",
              "Computer Numerical Control of Machine Tools and Processes, Lecture 12, Interpolators Linear"};
    case Paper::fpga_interpolation:
      return {"Gao and others", "FPGA-based implementation of circular interpolation"};
    case Paper::digital_integrals:
      return {"Yang and others", "Design and Implementation of Digital Integral Interpolator Based on LabVIEW"};
  }
  return {};
}

}  // namespace leadscrew::study
