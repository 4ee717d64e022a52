#pragma once
// A trace that is written while words come, in the format that its name ends in: whole, or not there at all.
//
// Where the format does not say what its columns are (NPY), a file beside it does: words.npy.json beside words.npy, an
// object {schema, trace, program, machine, period_s, columns: [{name, unit}]}.

#include <deque>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/trace/word_writer.hpp>
#include <memory>
#include <optional>
#include <string>

namespace leadscrew::files {

inline constexpr std::string_view trace_schema = "leadscrew.trace/1";

/// Of the file beside a trace, where there is one.
std::optional<std::string> side_of(const std::optional<std::string>& trace);

class WordFile {
 public:
  /// `program`: its name, for the file beside it. A column of power: of a machine with a laser only. Errors as those of
  /// OutputFile.
  base::Result<void> open(const std::string& path, const std::string& program, const machine::Machine& machine,
                          trace::MoreColumns columns = {});
  /// Of a word that will be written, in order: what a laser goes by.
  void observe(const base::PassedEvent& event) {
    if (laser_) events_.push_back(event);
  }
  /// `beside`: but the power. Words without a file are passed over.
  base::Result<void> write(const base::Word& word, trace::BesideWord beside = {});
  /// Words have ended: all of them are in the file, which has no name yet.
  base::Result<void> finish();
  /// The same, and gives the file its name.
  base::Result<void> publish();

  OutputFile* file() { return file_.get(); }  ///< null where none is open
  OutputFile* side() { return side_.get(); }  ///< null where none is open, or the format needs none

 private:
  base::Result<void> write_side(const std::string& path, const std::string& program, const machine::Machine& machine,
                                const trace::MoreColumns& columns);

  std::unique_ptr<OutputFile> file_, side_;  ///< the writer's sink refers to the first
  std::optional<trace::WordWriter> writer_;
  std::optional<machine::LaserPower> laser_;
  std::deque<base::PassedEvent> events_;  ///< of words that have not been written
};

}  // namespace leadscrew::files
