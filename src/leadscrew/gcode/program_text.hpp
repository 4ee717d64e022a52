#pragma once
// The texts of a program, line by line: its own and those of its subprograms, and the way back in them.
//
//     text of the program     ├──────────[window]───────────────────────┤      Lines come from one of up to eight
//     text of a subprogram    ├─[window]──────┤                                windows of 128 KiB. Whoever goes back
//                                                                              finds the line in a window, or has the
//                                                                              text opened there anew.
//
// A program without loops and subprograms is read through one window, once, in constant memory.

#include <cstdint>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/retained_text.hpp>
#include <memory>
#include <string>
#include <vector>

namespace leadscrew::gcode {

/// Where a line begins.
struct TextPlace {
  int file = 0;             ///< by number; 0 is the program's own text
  std::int64_t offset = 0;  ///< bytes before it
  std::int64_t line = 1;    ///< its number

  friend bool operator==(const TextPlace&, const TextPlace&) = default;
};

inline TextPlace place_of(const TextLine& line) {
  return {base::file(line.id), line.offset, line.number};
}

class ProgramText {
 public:
  /// Of the source, from its beginning; `opener` may be empty, then what is read once is_kept() is all that can be gone
  /// back to.
  ProgramText(ByteSource source, TextOpener opener, std::string name);

  /// The next line; false at the end of its text, or when the source has failed.
  bool next(TextLine& line) { return current_->next(line); }
  /// Is the next line there, without asking the source?
  bool has_line() const { return current_->has_line(); }
  /// Where the next line begins.
  TextPlace place() const { return {current_->file(), current_->offset(), current_->lines() + 1}; }

  /// From now on, and from this line on, which is the last that was read, the text can be gone back to.
  void keep(const TextLine& line);
  /// From its beginning on, before a line of it has been read.
  void keep_all() {
    if (retained_) retained_->keep({});
  }
  /// What comes next begins there. Errors: those of the opener; `text-not-kept`. Then there is no next line.
  base::Result<void> go_to(const TextPlace& place);
  /// How many windows had to be filled anew to go somewhere.
  std::int64_t reopenings() const { return reopenings_; }

  /// A text of another name: its number; those that have been opened keep theirs. Errors: those of the opener;
  /// `too-many-files`.
  base::Result<int> open(const std::string& name);
  /// The names of the texts by their numbers.
  const std::vector<std::string>& names() const { return names_; }

  /// The visit of lines from now on.
  void set_visit(std::int64_t visit);

  std::int64_t lines() const { return current_->lines(); }
  const std::optional<base::Diagnostic>& failure() const { return current_->failure(); }

 private:
  static constexpr std::size_t most_windows = 8;

  base::Result<ByteSource> source_at(int file, std::int64_t offset);
  LineSource& free_window();

  TextOpener opener_;
  std::shared_ptr<RetainedText> retained_;  // where there is no opener
  std::vector<std::unique_ptr<LineSource>> windows_;
  std::vector<std::int64_t> used_;  // when each was last gone to
  LineSource* current_;
  std::vector<std::string> asked_;  // by which names they were asked for
  std::vector<std::string> names_;  // and what they are called
  std::int64_t visit_ = 0;
  std::int64_t reopenings_ = 0;
  std::int64_t goings_ = 0;
};

}  // namespace leadscrew::gcode
