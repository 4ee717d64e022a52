#pragma once
// Events that are written while words come, as trace::EventWriter does: whole, or not there at all.

#include <leadscrew/files/output_file.hpp>
#include <leadscrew/trace/event_writer.hpp>
#include <memory>
#include <optional>
#include <string>

namespace leadscrew::files {

class EventFile {
 public:
  /// Errors as those of OutputFile.
  base::Result<void> open(const std::string& path, base::Period period);
  /// Events without a file are passed over, and those that no block asks for. Once one could not be written, finish() says so too.
  base::Result<void> write(const base::PassedEvent& event) {
    return writer_ && base::is_of_program(event.kind) ? writer_->write(event) : base::Result<void>();
  }
  /// Events have ended: all of them are in the file, which has no name yet.
  base::Result<void> finish() { return writer_ ? writer_->finish() : base::Result<void>(); }
  /// The same, and gives the file its name.
  base::Result<void> publish();

  OutputFile* file() { return file_.get(); }  ///< null where none is open

 private:
  std::unique_ptr<OutputFile> file_;  ///< the writer's sink refers to it
  std::optional<trace::EventWriter> writer_;
};

}  // namespace leadscrew::files
