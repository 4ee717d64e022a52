#pragma once
// The report: one self-contained page that shows what a program really does on a machine.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/report/followed_recording.hpp>
#include <leadscrew/report/recording.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace leadscrew::report {

/// Value over limit of one axis, as the referee found it and as the plan promises it.
struct AxisRatios {
  base::Axis axis{};
  double velocity = 0, acceleration = 0, jerk = 0;                          ///< by the referee, from words
  double planned_velocity = 0, planned_acceleration = 0, planned_jerk = 0;  ///< analytically, from the plan
};

/// Time that motion takes beyond its feed words, by what holds it.
struct Loss {
  std::string cause;  ///< "acceleration Z", "stop"
  double seconds = 0;
};

/// What the referee objects to in one block.
struct Violation {
  base::Line line{};
  std::string what;            ///< "X jerk", "deviation", "feed"
  std::int64_t count = 0;      ///< of words
  double first = 0, last = 0;  ///< s
  double value = 0;            ///< the worst; mm, degrees and seconds
  double limit = 0;            ///< at the worst
};
inline constexpr std::size_t most_violations = 100;  ///< that a page shows

/// What only whoever planned the motion knows.
struct Plan {
  /// The least time on this path within velocity, acceleration and feed, without a limit of jerk.
  double bound_s = 0;
  std::int64_t blocks = 0;  ///< read
};

/// Under tool centre point control, of words from the places of the path that they are matched to.
struct TipDeviation {
  double tip_mm = 0;                     ///< the greatest of the tip
  double orientation_deg = 0;            ///< and of the tool's direction
  double orientation_tolerance_deg = 0;  ///< the largest that applied
};

/// Where the tool is deepest inside a surface that the program machines, on the passes of one block, or on its links, or where it
/// bends less than the surface beside its contact.
struct Gouge {
  base::Line line{};
  std::optional<double> depth_mm;  ///< none: beside its contact, where
  double bends_by = 0;             ///< the surface bends by so much more than the tool, 1/mm
  std::string part;                ///< of the tool: "cutter", "shank", "holder"
  std::string motion;              ///< of the block: "pass 3"
  std::int64_t count = 0;          ///< of the block's passes, or links, that are too deep
  int surface = 0;                 ///< its number
  double u = 0, v = 0;             ///< the place on it
  base::AxisVector place{};        ///< in the pictures of the path, mm
};

/// What was found where a program may gouge.
struct Gouging {
  bool is_known = true;                  ///< false: the surfaces are more than are looked at
  double tolerance_mm = 0;               ///< what tools may be inside surfaces
  std::vector<Gouge> blocks;             ///< by block, the deepest first; behind them those beside contacts
  std::vector<base::AxisVector> places;  ///< where each pass, link or way is deepest, in the pictures of the path, mm
};
inline constexpr std::size_t most_gouges = 20;  ///< that a page lists

struct Report {
  std::string title;    ///< the program's name; the trace's, where it was judged
  std::string program;  ///< that a trace was judged by; empty otherwise
  std::string version;  ///< of Leadscrew
  std::string command;  ///< the command line that makes this report again
  double time_s = 0, dwell_s = 0;
  double length_mm = 0;
  std::int64_t moves = 0, words = 0;
  std::optional<Plan> plan;  ///< none of a trace
  double deviation_mm = 0, tolerance_mm = 0;
  std::optional<TipDeviation> tip;  ///< none without tool centre point control
  double feed_programmed_max = 0;   ///< mm/s
  double feed_max_ratio = 0;
  std::vector<AxisRatios> limits;     ///< without a plan, what is planned is 0
  std::vector<Violation> violations;  ///< the first of them, in the order of time
  std::int64_t violation_count = 0;   ///< of words, all
  std::vector<Loss> losses;           ///< the dearest first; empty where they were not looked for
  std::optional<Gouging> gouging;     ///< none where it was not looked for
  std::vector<base::Diagnostic> diagnostics;
  std::vector<std::pair<base::Line, std::string>> source;  ///< text of the lines that the tables of blocks name
  std::vector<std::string> texts;                          ///< names of the program's texts, by base::file() of lines
};

/// Writes the page; below 5 MB for any recording. followed: where slides followed the words that were recorded, or
/// null.
base::Result<void> write_report(const Report& report, const Recording& recording, const machine::Machine& machine,
                                base::Period period, const base::ByteSink& sink, FollowedRecording* followed = nullptr);

/// Writes position, velocity, acceleration and jerk of the axes over time as an SVG picture, against their limits.
base::Result<void> write_motion_charts(const std::string& title, const Recording& recording,
                                       const machine::Machine& machine, const base::ByteSink& sink);

/// Writes the path alone as an SVG picture (isometric view, coloured by speed), for light and dark pages.
base::Result<void> write_path_svg(const std::string& title, const Recording& recording, const base::ByteSink& sink);

}  // namespace leadscrew::report
