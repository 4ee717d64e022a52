#pragma once
// The diagnostics of one program: shown as they come, kept for JSON and the report.

#include <cstdint>
#include <leadscrew/console/console.hpp>
#include <leadscrew/console/option_hints.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/options/status.hpp>
#include <vector>

namespace leadscrew::console {

class DiagnosticLog {
 public:
  explicit DiagnosticLog(Console& console) : console_(console) {}

  void add(const base::Diagnostic& problem) {
    const base::Diagnostic diagnostic = with_options(problem);
    // Whoever pressed ^C knows, and whoever has closed the pipe, with `| head`, wants no more.
    const bool is_closed = diagnostic.code == "io-pipe" && files::is_standard_output(diagnostic.place.file);
    if (diagnostic.code != "interrupted" && !is_closed) console_.diagnostic(diagnostic);
    errors_ += diagnostic.severity == base::Severity::error ? 1 : 0;
    warnings_ += diagnostic.severity == base::Severity::warning ? 1 : 0;
    status_ = options::worse(status_, options::status_of(diagnostic));
    all_.push_back(diagnostic);
  }

  std::int64_t errors() const { return errors_; }
  std::int64_t warnings() const { return warnings_; }
  const std::vector<base::Diagnostic>& all() const { return all_; }
  options::Status status() const { return status_; }

 private:
  Console& console_;
  std::vector<base::Diagnostic> all_;  ///< the reader ends a program with too many
  std::int64_t errors_ = 0, warnings_ = 0;
  options::Status status_ = options::Status::done;
};

}  // namespace leadscrew::console
