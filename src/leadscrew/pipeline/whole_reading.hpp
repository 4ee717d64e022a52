#pragma once
// A program read to its end before anything moves: what it holds, with a survey of its path beside.

#include <cstdint>
#include <functional>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/pipeline/path_survey.hpp>

namespace leadscrew::pipeline {

/// Who is asked and told while a program is read whole. Any may be absent, but for `is_sound` where there is a survey.
struct ReadingWatch {
  Survey* survey = nullptr;                     ///< gets the moves as long as the program is sound
  std::function<bool()> is_sound;               ///< has the program no error until now?
  std::function<void(const gcode::Move&)> see;  ///< each move, behind the survey
  std::int64_t moves_between_questions = 4096;  ///< ≥ 1
  std::function<bool()> goes_on;                ///< false ends the reading
};

struct ReadProgram {
  std::int64_t blocks = 0;       ///< lines that hold at least one word
  std::int64_t moves = 0;        ///< lines, arcs and curves
  std::int64_t pauses = 0;       ///< M0, M1 and M60
  bool was_interrupted = false;  ///< by ReadingWatch::goes_on; what is counted is what was read until then
};

/// Feeds that the survey finds beyond the machine are warnings of the reader. What is wrong with the program goes to the
/// reader's own sink, and a source that fails is Reader::source_failure().
ReadProgram read_whole(gcode::Reader& reader, const ReadingWatch& watch);

}  // namespace leadscrew::pipeline
