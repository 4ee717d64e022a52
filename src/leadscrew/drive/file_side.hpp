#pragma once
// A file or a pipe in the place of drives: it gets every word on time, and nothing moves by it. A word is accepted when
// its whole row is in the file, under its own name: whatever is killed, all words that the state knows are there.

#include <leadscrew/drive/word_side.hpp>
#include <leadscrew/machine/laser.hpp>
#include <leadscrew/trace/csv_writer.hpp>

namespace leadscrew::drive {

class FileSide : public WordSide {
 public:
  /// `begin`: what is known before the first word.
  FileSide(Link& link, const Setup& setup, const State& begin);

  /// The file of Options::sink, as CSV; what was in it is gone, but for standard output. Waits for the reader of
  /// a pipe. Error: `io-open`.
  base::Result<void> open(const Setup& setup);
  /// Until words end, nobody sends any, or none can be written. Errors: `io-write`, `io-pipe`.
  base::Result<void> run();

 private:
  base::Result<void> write(std::string_view bytes);
  bool waits();
  void take_words();

  const std::string path_;
  files::Descriptor file_;
  bool is_regular_ = false;
  std::int64_t accepted_bytes_ = 0, written_bytes_ = 0;
  trace::CsvWriter writer_;
  std::optional<machine::LaserPower> laser_;
  std::int64_t progress_ = 0;  ///< ns: when something was last written
  bool gave_up_ = false;       ///< on a reader that does not read
};

}  // namespace leadscrew::drive
