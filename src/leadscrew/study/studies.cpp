#include <array>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

namespace {

constexpr std::array<Study, 17> all_studies = {{
    {"butterfly", "The butterfly by arc length, and the times of travelling it", butterfly_rows},
    {"feed-fluctuation", "Feed and chord errors of the rules that step a curve's parameter", feed_fluctuation_rows},
    {"limits", "Time, limits and effort along curves beside the optimum, and along blended lines and corners",
     limits_rows},
    {"tube", "The least time inside the tolerance, path and time law found at once, and ours beside it", tube_rows,
     nullptr, tube_words},
    {"table-1", "Koren's comparison of integration methods after half a turn, in numbers of 27 bits", table_1_rows},
    {"orders", "How the error of each integration method falls with its step", orders_rows},
    {"10001", "Koren's half circle of 10 000 BLU, which comes out at 10 001", half_circle_rows},
    {"fpga-table-1", "Steps and errors of four circular interpolators", fpga_rows},
    {"lecture", "The worked problems of a lecture on DDA interpolators", lecture_rows},
    {"closed-loop-pulses", "A pulse-driven axis as it runs, and the contours of two of unlike gains", closed_loop_rows},
    {"real-time-vs-offline", "A curve as one block and as 92 lines with a stop at each, through servo loops",
     real_time_rows, real_time_picture},
    {"five-axes", "A pass over a patch by five axes, as lines of axes and as a path of the tip", five_axes_rows,
     five_axes_picture},
    {"surface", "A surface as one block, and as thousands of lines", surface_rows, surface_picture},
    {"adaptive-force", "Force held and time saved by adaptive control, by planner and by NC program", adaptive_rows},
    {"koren-feed", "Koren's feed words and clocks, by formula and by registers", feed_code_rows},
    {"digital-integrals", "Lines and arcs of a teaching interpolator in n-bit registers", digital_integrals_rows},
    {"bounds", "Greatest errors of every pulse interpolator, on all circles, arcs and lines to some size", bounds_rows},
}};

}  // namespace

std::span<const Study> studies() {
  return all_studies;
}

}  // namespace leadscrew::study
