#pragma once
// The text of a program for those calls of leadscrew.h that read it without moving it.

#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/host/program_reading.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "handles.hpp"

namespace leadscrew::capi {

/// Readers of one text, any number of them one after the other.
class ProgramReadings {
 public:
  ProgramReadings(const machine::Machine& machine, std::string text, host::MotionOptions options)
      : machine_(machine),
        options_(std::move(options)),
        texts_(std::make_shared<host::ProgramTexts>(std::move(text), options_.subprogram)) {
    options_.allows_gouging = true;
  }

  /// The next from the beginning.
  gcode::Reader open(gcode::MoveSink programmed = {}) {
    gcode::ReaderOptions reading = host::reading_of(machine_, options_, texts_);
    reading.programmed = std::move(programmed);
    return {host::asking_source(texts_->program(), options_.goes_on, share_), machine_, options_.tools,
            std::move(reading), [this](const base::Diagnostic& diagnostic) {
              if (diagnostic.severity == base::Severity::error && !error_) error_ = diagnostic;
            }};
  }
  /// Asked while work takes long. Once it says to end, that is the error.
  bool is_ended() {
    if (!error_ && options_.goes_on && !options_.goes_on(*share_)) error_ = host::interruption();
    return error_.has_value();
  }
  void take(const gcode::Reader& reader) {
    if (!error_ && reader.source_failure()) error_ = *reader.source_failure();
  }
  /// The first.
  const std::optional<base::Diagnostic>& error() const { return error_; }
  const machine::Machine& machine() const { return machine_; }
  const machine::ToolTable& tools() const { return options_.tools; }

 private:
  const machine::Machine& machine_;
  host::MotionOptions options_;
  std::shared_ptr<host::ProgramTexts> texts_;
  std::shared_ptr<double> share_ = std::make_shared<double>(0);
  std::optional<base::Diagnostic> error_;
};

/// What `use` makes of the readings of a program. The machine and the text are there, as the caller has seen.
template <class Use>
int with_readings(const leadscrew_machine& machine, const char* text, size_t length, const leadscrew_options* given,
                  leadscrew_error* error, const Use& use) {
  return guarded(error, [&] {
    leadscrew_options asked{};
    host::MotionOptions options;
    if (const int code = read_options(given, machine.machine, asked, options, error); code != LEADSCREW_OK) return code;
    ProgramReadings readings(machine.machine, std::string(text, length), std::move(options));
    return use(readings);
  });
}

}  // namespace leadscrew::capi
