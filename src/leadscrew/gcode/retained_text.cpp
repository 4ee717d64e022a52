#include <algorithm>
#include <cstring>
#include <leadscrew/gcode/retained_text.hpp>

namespace leadscrew::gcode {

void RetainedText::keep(std::string_view read) {
  if (is_asked_for_) return;
  is_asked_for_ = is_kept_ = true;
  from_ = arrived_ - static_cast<std::int64_t>(read.size());
  kept_.assign(read.begin(), read.end());
}

base::Result<void> RetainedText::check(std::int64_t offset) const {
  if (offset >= arrived_ || holds(offset)) return {};
  return base::failure(base::problem("text-not-kept",
                                     "the program goes back over more than 16 MiB of a text that comes but once",
                                     "give the program as a file"));
}

base::Result<std::size_t> RetainedText::read(std::int64_t& offset, std::span<char> buffer) {
  if (offset < arrived_) {
    if (auto held = check(offset); !held) return base::failure(held.error());
    const auto begin = static_cast<std::size_t>(offset - from_);
    const std::size_t count = std::min(buffer.size(), kept_.size() - begin);
    std::memcpy(buffer.data(), kept_.data() + begin, count);
    offset += static_cast<std::int64_t>(count);
    return count;
  }
  auto got = live_(buffer);
  if (!got) return got;
  const std::size_t count = std::min(*got, buffer.size());
  if (is_kept_ && kept_.size() + count > most) {
    is_kept_ = false;
    kept_ = {};
  }
  if (is_kept_) kept_.insert(kept_.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
  arrived_ += static_cast<std::int64_t>(count);
  offset = arrived_;
  return count;
}

}  // namespace leadscrew::gcode
