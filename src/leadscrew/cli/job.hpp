#pragma once
// What every program of one command line has in common: the machine, the tools, and how programs are read.

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/console/diagnostic_log.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gouging/program_check.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::cli {

/// So many words are made between two looks for an interruption.
inline constexpr std::int64_t words_between_checks = 1024;

struct Job {
  Arguments arguments;
  machine::Machine machine;  ///< with the period of the command line
  machine::ToolTable tools;
  base::AxisVector start{};                    ///< machine coordinates, mm or degrees
  std::string text;                            ///< of the machine file, the tool table and the parameter file
  std::size_t machine_end = 0, tools_end = 0;  ///< where the first two end in it
  std::string machine_text() const { return text.substr(0, machine_end); }  ///< empty of the built-in mill
  std::string tools_text() const { return text.substr(machine_end, tools_end - machine_end); }
  std::vector<gcode::NumberedValue> parameters{};  ///< where a program begins
  /// Of its surfaces, by all readings of a program.
  std::shared_ptr<gcode::SurfaceDrafts> surface_drafts = gcode::new_surface_drafts();

  /// Of any program.
  gcode::ReaderOptions reader_options() const;
  /// Of this one, which must outlive them and stay where it is.
  gcode::ReaderOptions reader_options(const files::InputFile& file) const;
};

/// Opens the machine file and the tool table. Empty if the log now has errors.
std::optional<Job> prepare_job(const Arguments& arguments, DiagnosticLog& log);

/// The job for one of its programs: a curve begins where it begins.
Job job_of(const Job& job, const std::string& program);

/// A program of the command line: a file, standard input or a curve of the studies. Errors: `usage` of a curve, those
/// of files::InputFile::open().
base::Result<files::InputFile> open_program(const std::string& program);

/// What reading a whole program tells before anything moves.
struct Reading : pipeline::ReadProgram {
  double seconds = 0;  ///< that reading took
};

/// Reads the program whole; its problems, and those of its file, go to the log, and feeds beyond the machine with a
/// survey, which gets all moves up to the first error.
Reading read_program(const files::InputFile& file, const Job& job, Console& console, DiagnosticLog& log,
                     pipeline::Survey* survey = nullptr, gcode::RemarkSink remarks = {});

/// Where a program gouges that has been read whole: off-line, and slow.
gouging::GougeVerdict gouging_of(const files::InputFile& file, const Job& job);

/// A reader over the file that says nothing: for programs that have been read whole.
gcode::Reader silent_reader(const files::InputFile& file, const Job& job);

}  // namespace leadscrew::cli
