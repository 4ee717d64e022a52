#include <leadscrew/files/event_file.hpp>
#include <utility>

namespace leadscrew::files {

base::Result<void> EventFile::open(const std::string& path, base::Period period) {
  auto file = OutputFile::create(path, OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  file_ = std::make_unique<OutputFile>(std::move(*file));
  writer_.emplace(file_->sink(), period);
  return {};
}

base::Result<void> EventFile::publish() {
  if (auto finished = finish(); !finished) return finished;
  return publish_together({file_.get()});
}

}  // namespace leadscrew::files
