#pragma once
// Programs × machines × parameters as tasks.

#include <array>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/sweep/parameters.hpp>
#include <leadscrew/sweep/work.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::sweep {

/// A machine as its file says, and the file's text.
struct NamedMachine {
  std::string path;  ///< or "mill3"
  machine::Machine machine;
  std::string text;
};

/// What is known of a program before its tasks are begun: by reading it once, on the first machine.
struct SurveyedProgram {
  std::string path;
  Key content{};             ///< of its bytes and those of its subprograms; of the path where it cannot be read
  double bound_s = 0;        ///< pipeline::QuickSurvey, as far as it could be read
  std::int64_t moves = 0;    ///< the same
  bool is_readable = false;  ///< the file can be opened and read
};

struct ArchiveSetup {
  std::vector<std::string> programs;  ///< files
  std::vector<NamedMachine> machines;
  machine::ToolTable tools;
  std::string tools_text;
  std::vector<Parameters> parameters;
  std::vector<std::string> subprograms;  ///< folders
  std::optional<machine::Dialect> dialect;
};

/// The part programs in files and folders: of a folder all files with the endings of part programs, in folders inside it too,
/// in the order of their names. Errors: `io-open`; `no-programs` where a folder has none.
base::Result<std::vector<std::string>> programs_in(const std::vector<std::string>& paths);

/// Reads the program of this number. Error: interruption alone.
base::Result<SurveyedProgram> survey(const ArchiveSetup& setup, std::size_t program);

class Archive final : public Work {
 public:
  /// `programs`: in the order of setup.programs. The setup must outlive this.
  Archive(const ArchiveSetup& setup, std::vector<SurveyedProgram> programs);

  /// Task = (program · machines + machine) · parameters + parameter.
  std::int64_t count() const override;
  Key key(std::int64_t task) const override;
  double cost(std::int64_t task) const override;
  /// Task, program, machine, and its parameters.
  std::vector<json::Json::Member> place(std::int64_t task) const override;
  base::Result<json::Json> result(std::int64_t task) override;

 private:
  struct Place {
    std::size_t program, machine, parameters;
  };
  Place place_of(std::int64_t task) const;

  const ArchiveSetup& setup_;
  std::vector<SurveyedProgram> programs_;
  std::vector<std::string> of_machines_;  ///< what their keys are made of
};

}  // namespace leadscrew::sweep
