#pragma once
// What a drive is asked for: the machine, how its program is read, and the files that are written while it moves.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::drive {

/// Words that are handed over at a time, s, and motion that is planned at a time, at most.
inline constexpr double slice_duration = 0.01, longest_chunk = 0.02;

struct Options {
  std::optional<std::string> trace, axes;    ///< files of the simulated drives: words taken, where the axes went
  std::optional<std::string> events;         ///< file of the events of the words that were taken
  std::optional<std::string> state, resume;  ///< files: kept while it moves, and where it goes on from
  std::optional<std::string> sink;           ///< file or pipe that gets the words in the place of drives
  /// s planned ahead of the words, 0.01 … 60; none: 0.3, or as little as 0.02 where planner and words are in time.
  std::optional<double> look_ahead;
  double lead = 0.1;  ///< s that words are made ahead of their time, 0 … 2
  /// Is the program read while it moves, block by block as they come, and not before?
  bool live = false;
};

struct Setup {
  machine::Machine machine;
  machine::ToolTable tools;
  gcode::ReaderOptions reading;  ///< but for the file's name; `start` is where the axes stand
  std::string text;              ///< of the machine file and the tool table: a state names them by its hash
  Options options;
  std::string live_program = {};  ///< of Options::live: its path; "-" is standard input

  std::vector<std::string> subprograms = {};  ///< folders of subprograms

  // For whoever looks on; texts.
  std::string machine_file = {};  ///< empty of the built-in mill
  std::string tool_table = {};    ///< empty where there is none

  // Of the reading that words are made of, by a thread of its own: as in gcode::ReaderOptions.
  gcode::RemarkSink remarks = {};
  std::function<void(const std::vector<gcode::NumberedValue>&)> parameters_at_end = {};

  /// Periods of a time, s.
  std::int64_t words_in(double seconds) const { return std::llround(seconds / machine.period.seconds()); }
  std::int64_t words_of_slice() const { return std::max<std::int64_t>(1, words_in(slice_duration)); }
  /// Words that wait to be taken by the drives, at most.
  std::size_t most_waiting() const {
    return static_cast<std::size_t>(2 * (words_in(options.lead) + words_of_slice()) + 4);
  }

  /// That a stop takes, at the most as a rule. Along a line it takes max v/a + max a/J. Where no early stop is known, stop paths go on
  /// to the end of a window of the planner's, some such stops long.
  double periods_to_stop() const {
    constexpr double on_curves = 4;
    double brake = 0, release = 0;
    for (const auto& limits : machine.axes) {
      if (!limits) continue;
      brake = std::max(brake, limits->velocity / limits->acceleration);
      release = std::max(release, limits->acceleration / limits->jerk);
    }
    return (on_curves * (brake + release) + slice_duration + longest_chunk) / machine.period.seconds();
  }

  /// Of a program that comes while it moves.
  gcode::ReaderOptions reader_options(const std::string& file) const {
    gcode::ReaderOptions options_of_file = reading;
    options_of_file.file = file;
    return options_of_file;
  }
  /// Of a file, which must outlive them and stay where it is.
  gcode::ReaderOptions reader_options(const files::InputFile& file) const {
    gcode::ReaderOptions options_of_file = reader_options(file.name());
    options_of_file.opener = file.opener(subprograms);
    return options_of_file;
  }
  /// The same, with what the program says on its way.
  gcode::ReaderOptions speaking(gcode::ReaderOptions quiet) const {
    quiet.remarks = remarks;
    quiet.parameters_at_end = parameters_at_end;
    return quiet;
  }
};

}  // namespace leadscrew::drive
