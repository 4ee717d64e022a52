// Lines that have been found once, kept in bounded memory.

#include <leadscrew/surfaces/pass_lines.hpp>
#include <utility>

namespace leadscrew::surfaces {

namespace {

/// Parts of one pass share a function.
std::size_t bytes_of(const std::vector<Line>& lines) {
  std::size_t bytes = sizeof(std::vector<Line>) + lines.size() * sizeof(Line);
  const AcrossFunction* last = nullptr;
  for (const Line& line : lines) {
    if (line.function != nullptr && line.function.get() != last) bytes += line.function->bytes();
    last = line.function.get();
  }
  return bytes;
}

class RecordedLines : public PassLines {
 public:
  RecordedLines(std::unique_ptr<PassLines> lines, std::shared_ptr<LineRecord> record)
      : lines_(std::move(lines)), record_(std::move(record)) {}

  std::vector<Line> next(PassLog& log) override {
    std::vector<Line> lines = lines_->next(log);
    record_->bytes += bytes_of(lines);
    if (record_->bytes > LineRecord::most_bytes) {
      record_->passes = {};
    } else if (lines.empty()) {
      record_->is_complete = !log.failure;
    } else {
      record_->passes.push_back(lines);
    }
    return lines;
  }

 private:
  std::unique_ptr<PassLines> lines_;
  std::shared_ptr<LineRecord> record_;
};

class KnownLines : public PassLines {
 public:
  explicit KnownLines(std::shared_ptr<const LineRecord> record) : record_(std::move(record)) {}

  std::vector<Line> next(PassLog& log) override {
    if (log.failure || told_ == record_->passes.size()) return {};
    return record_->passes[told_++];
  }

 private:
  std::shared_ptr<const LineRecord> record_;
  std::size_t told_ = 0;
};

}  // namespace

std::unique_ptr<PassLines> recorded_lines(std::unique_ptr<PassLines> lines, std::shared_ptr<LineRecord> record) {
  return std::make_unique<RecordedLines>(std::move(lines), std::move(record));
}

std::unique_ptr<PassLines> known_lines(std::shared_ptr<const LineRecord> record) {
  return std::make_unique<KnownLines>(std::move(record));
}

}  // namespace leadscrew::surfaces
