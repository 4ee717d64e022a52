#include <leadscrew/files/word_file.hpp>

namespace leadscrew::files {

base::Result<void> WordFile::open(const std::string& path, const machine::Machine& machine) {
  const bool is_npy = extension(path) == ".npy";
  auto file = OutputFile::create(path, is_npy ? OutputFile::Access::rewritable : OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  file_.emplace(std::move(*file));
  const base::AxisSet axes = machine.axis_set();
  if (is_npy) {
    writer_.emplace<trace::NpyWriter>(file_->sink(), axes, machine.period);
  } else {
    writer_.emplace<trace::CsvWriter>(file_->sink(), axes, machine.period);
  }
  return {};
}

base::Result<void> WordFile::write(const base::Word& word) {
  if (auto* csv = std::get_if<trace::CsvWriter>(&writer_)) return csv->write(word);
  if (auto* npy = std::get_if<trace::NpyWriter>(&writer_)) return npy->write(word);
  return {};
}

base::Result<void> WordFile::publish() {
  if (!file_) return {};
  if (auto* csv = std::get_if<trace::CsvWriter>(&writer_)) {
    if (auto finished = csv->finish(); !finished) return finished;
  }
  if (auto* npy = std::get_if<trace::NpyWriter>(&writer_)) {
    if (auto finished = npy->finish(); !finished) return finished;
    if (auto written = file_->rewrite_start(npy->header()); !written) return written;
  }
  if (auto closed = file_->close(); !closed) return closed;
  return file_->publish();
}

}  // namespace leadscrew::files
