#pragma once
// Logic cells of our hardware for the four interpolators of the FPGA paper, one quadrant, 16 bits, Cyclone IV by yosys before placing:
// hdl/syn/table_1.txt, which hdl/syn/check makes again.

namespace leadscrew::study {

struct FpgaCells {
  const char* module;  ///< of hdl/rtl/paper
  int logic;           ///< cycloneiv_lcell_comb
  int flip_flops;      ///< dffeas
};
inline constexpr FpgaCells point_comparison_cells{"by_point_comparison", 516, 91}, dda_cells{"dda", 440, 121},
    least_error_cells{"minimum_error", 835, 91}, improved_least_error_cells{"improved_minimum_error", 691, 91};

}  // namespace leadscrew::study
