#pragma once
// What a program says in its remarks, where the user sees it: MSG, DEBUG and PRINT on standard error, LOG, and points that are probed, in
// files beside the program, which appear whole when the run is done, or not at all; and the parameters that it leaves.

#include <functional>
#include <leadscrew/base/result.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/gcode/parameter_file.hpp>
#include <leadscrew/gcode/remark.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::results {

/// Writes a parameter file, whole or not at all. Errors: those of files::OutputFile.
base::Result<void> write_parameters(const std::string& path, const std::vector<gcode::NumberedValue>& values);

class RemarkOutput {
 public:
  /// Shows lines of text, by whichever thread reads the program.
  using Say = std::function<void(const std::string&)>;

  /// `program`: path, or "-", whose log files stand in the working folder. `is_taken`: whether a path is
  /// that of a file which logs must not replace.
  RemarkOutput(const std::string& program, std::function<bool(const std::string&)> is_taken, Say say);

  /// Refers to this, which must stay where it is.
  gcode::RemarkSink sink();

  /// Gives the log files their names, and tells them. Errors: `bad-log` of a file outside of the program's folder, or
  /// that is written or read otherwise; those of files::OutputFile.
  base::Result<std::vector<std::string>> publish();

 private:
  void take(const gcode::Remark& remark);
  base::Result<void> open(const gcode::Remark& remark, files::OutputFile*& log);
  base::Result<void> continue_file(files::OutputFile& file, const std::string& path);
  base::Result<std::string> path_of(const gcode::Remark& remark) const;

  std::string folder_;
  std::function<bool(const std::string&)> is_taken_;
  Say say_;
  std::map<std::string, std::unique_ptr<files::OutputFile>> logs_;  // by path
  files::OutputFile* log_ = nullptr;                                // that is open
  files::OutputFile* points_ = nullptr;                             // of those that are probed
  std::optional<base::Diagnostic> failure_;                         // the first
};

}  // namespace leadscrew::results
