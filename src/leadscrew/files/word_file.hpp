#pragma once
// A trace that is written while words come: .csv or .npy, whole or not there at all.

#include <leadscrew/base/word.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/trace/words.hpp>
#include <string>
#include <variant>

namespace leadscrew::files {

class WordFile {
 public:
  /// Must stay where it is once it is open. Errors as those of OutputFile.
  base::Result<void> open(const std::string& path, const machine::Machine& machine);
  base::Result<void> write(const base::Word& word);
  /// Gives the file its name.
  base::Result<void> publish();

 private:
  std::optional<OutputFile> file_;
  std::variant<std::monostate, trace::CsvWriter, trace::NpyWriter> writer_;
};

}  // namespace leadscrew::files
