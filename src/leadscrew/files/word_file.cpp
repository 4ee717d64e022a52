#include <leadscrew/files/word_file.hpp>

namespace leadscrew::files {

base::Result<void> WordFile::open(const std::string& path, const machine::Machine& machine,
                                  trace::MoreColumns columns) {
  const std::string ending = extension(path);
  const auto access = trace::has_header_last(ending) ? OutputFile::Access::rewritable : OutputFile::Access::sequential;
  auto file = OutputFile::create(path, access);
  if (!file) return base::failure(file.error());
  file_ = std::make_unique<OutputFile>(std::move(*file));
  writer_.emplace(ending, file_->sink(), machine.axis_set(), machine.period, columns);
  if (columns.power) laser_.emplace(*machine.laser);
  return {};
}

base::Result<void> WordFile::write(const base::Word& word, trace::BesideWord beside) {
  if (!writer_) return {};
  for (; !events_.empty() && events_.front().tick <= word.tick; events_.pop_front()) laser_->observe(events_.front());
  beside.power = laser_ ? laser_->at(word) : 0;
  return writer_->write(word, beside);
}

base::Result<void> WordFile::finish() {
  if (!writer_) return {};
  if (auto finished = writer_->finish(); !finished) return finished;
  const auto header = writer_->header();
  return header ? file_->rewrite_start(*header) : base::Result<void>();
}

base::Result<void> WordFile::publish() {
  if (auto finished = finish(); !finished) return finished;
  return publish_together({file_.get()});
}

}  // namespace leadscrew::files
