#pragma once
// Words as comma-separated rows in a file, as `leadscrew verify` reads and draws them; nothing where no file is named.
#include <cstdio>
#include <leadscrew/motion.hpp>
#include <string>
#include <utility>

class TraceFile {
 public:
  /// The file's name is the program's argument; axes: "XYZ".
  TraceFile(int argc, char** argv, std::string axes, leadscrew::base::Period period)
      : file_(argc == 2 ? std::fopen(argv[1], "wb") : nullptr), axes_(std::move(axes)), period_(period) {
    if (file_ == nullptr) return;
    std::fputs("t", file_);
    for (const char axis : axes_) std::fprintf(file_, ",%c", axis);
    std::fputs("\n", file_);
  }
  ~TraceFile() {
    if (file_ != nullptr) std::fclose(file_);
  }
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  void write(const leadscrew::base::Word& word) {
    if (file_ == nullptr) return;
    std::fprintf(file_, "%.17g", leadscrew::base::seconds(word.tick, period_));
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) std::fprintf(file_, ",%.17g", word.position[axis]);
    std::fputs("\n", file_);
  }

 private:
  std::FILE* file_;
  std::string axes_;
  leadscrew::base::Period period_;
};
