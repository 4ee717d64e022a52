#pragma once
// A file in the place of drives: it gets every word on time, and nothing moves by it.

#include <leadscrew/cli/word_side.hpp>

namespace leadscrew::cli {

class FileSide : public WordSide {
 public:
  /// `begin`: what is known before the first word.
  FileSide(DriveLink& link, const Job& job, const DriveState& begin) : WordSide(link, job, begin) {}

  /// The file of DriveArguments::sink, which must be there. Errors as those of WordFile.
  base::Result<void> open(const Job& job) { return file_.open(*job.arguments.drive.sink, job.machine); }
  /// Until words end, or nobody sends any: those that have come are written.
  base::Result<void> run();

 private:
  void take_words();

  WordFile file_;
};

}  // namespace leadscrew::cli
