#pragma once
// Diagnostics of the line being read: their places, their number, and an end to them.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/gcode/foreign_language.hpp>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::gcode {

/// A place in a line that has been read, where something may yet be found.
struct KeptPlace {
  base::Line line{};
  std::uint32_t column = 1;  ///< bytes, from 1
  std::string text;          ///< of the line, as much as is shown
};

class Reporter {
 public:
  Reporter(std::string file, DiagnosticSink sink);

  void begin(const TextLine& line) {
    line_ = line;
    failed_ = false;
    muted_ = false;
  }

  /// Reports the line where it is of a language that is not read.
  [[gnu::cold]] void refuse_foreign();

  // Most blocks have no problem: that there may be one costs those nothing.
  /// Reports an error at a column, counted in bytes from 1, and returns false. Where the line is of a language that is
  /// not read, says that instead, and reading stops.
  [[gnu::cold]] bool error(std::string_view code, std::int64_t column, std::string message, std::string hint,
                           base::Subject subject = {});
  [[gnu::cold]] void warning(std::string_view code, std::int64_t column, std::string message, std::string hint);
  [[gnu::cold]] void note(std::string_view code, std::int64_t column, std::string message, std::string hint);
  /// Says something about the text as a whole.
  void report(base::Severity severity, std::string_view code, base::Place place, std::string message, std::string hint);

  /// A column of the line, to come back to.
  KeptPlace place(std::uint32_t column) const;
  /// What is reported from now on is of that place's line, and no line has a problem, until go_back().
  struct Present {
    TextLine line;
    bool failed = false, muted = false;
  };
  Present go_to(const KeptPlace& place);
  void go_back(const Present& present);

  /// Keeps the line and a column of it, where something begins that further lines belong to.
  void keep(std::int64_t column);
  /// Reports an error there.
  [[gnu::cold]] bool error_where_kept(std::string_view code, std::string message, std::string hint,
                                      base::Subject subject = {});
  [[gnu::cold]] void warning_where_kept(std::string_view code, std::string message, std::string hint);

  /// Makes the block fail for a cause that has been reported before, and returns false.
  bool fail() {
    failed_ = true;
    return false;
  }
  /// Keeps what follows from a reported problem from being reported as problems of their own, until the next line.
  void mute() { muted_ = true; }

  /// Nothing more is read, and nothing more reported.
  void stop() { full_ = true; }

  bool muted() const { return muted_; }
  bool failed() const { return failed_; }  ///< the line has an error
  bool full() const { return full_; }      ///< reading stops: most_errors were reported, or the program says so
  std::int64_t errors() const { return errors_; }
  const std::string& file() const { return file_of(line_.id); }  ///< of the line being read
  const std::string& file_of(base::Line line) const { return files_[static_cast<std::size_t>(base::file(line))]; }
  base::Line line() const { return line_.id; }  ///< being read
  std::int64_t column(const char* p) const { return p - line_.begin + 1; }
  /// The byte of the line at a column of its text.
  char byte(std::int64_t column) const { return line_.begin[column - 1]; }
  /// Gives the files of a program their names, by their numbers.
  void set_files(const std::vector<std::string>& files) { files_ = files; }

 private:
  bool refuse_language(const ForeignLanguage& language);
  void send(base::Severity severity, std::string_view code, base::Place place, std::string message, std::string hint,
            std::string source, base::Subject subject = {});
  bool error_at(base::Line line, std::int64_t column, std::string_view text, std::string_view code, std::string message,
                std::string hint, base::Subject subject);
  void warning_at(base::Line line, std::int64_t column, std::string_view text, std::string_view code,
                  std::string message, std::string hint, base::Severity severity = base::Severity::warning);
  base::Place place_of(base::Line line, std::int64_t column) const {
    return {file_of(line), base::number(line), column};
  }
  std::string_view text() const { return {line_.begin, static_cast<std::size_t>(line_.end - line_.begin)}; }

  // One that has been said is not said again when its line is executed again.
  struct Said {
    std::string_view code;
    std::int64_t column = 0;
    base::Line line{};
  };
  bool was_said(std::string_view code, base::Line line, std::int64_t column);

  std::vector<std::string> files_;
  std::vector<Said> said_;
  DiagnosticSink sink_;
  TextLine line_;
  base::Line kept_line_{};
  std::int64_t kept_column_ = 0;
  std::string kept_text_;
  std::int64_t errors_ = 0;
  std::int64_t warnings_ = 0;
  std::int64_t repeats_ = 0;  // errors of further visits, which are not told
  bool failed_ = false;
  bool muted_ = false;
  bool full_ = false;
};

/// While it lives, what is reported is of a line read before.
class AtKeptPlace {
 public:
  AtKeptPlace(Reporter& reporter, const KeptPlace& place) : reporter_(reporter), present_(reporter.go_to(place)) {}
  ~AtKeptPlace() { reporter_.go_back(present_); }
  AtKeptPlace(const AtKeptPlace&) = delete;
  AtKeptPlace& operator=(const AtKeptPlace&) = delete;

 private:
  Reporter& reporter_;
  Reporter::Present present_;
};

/// A character as messages show it: 'X', or its code where it has no shape.
std::string shown(char c);

/// The text with control characters replaced by blanks, and what is not UTF-8 by '?': as many bytes as before.
std::string printable(std::string_view text);

}  // namespace leadscrew::gcode
