#include <leadscrew/drive/terminal.hpp>
#include <leadscrew/drive/word_side.hpp>

namespace leadscrew::drive {

base::Result<void> WordSide::conclude(std::span<files::WordFile* const> files) {
  link_.concluding.store(true, std::memory_order_release);
  for (files::WordFile* file : files) took(file->publish());
  if (is_orphan() && link_.has_terminal.load(std::memory_order_acquire)) Terminal::restore(link_.terminal);
  const bool has_left = link_.words.has_left();
  const bool ended = !has_left && link_.at_end.load(std::memory_order_acquire);
  took(state_writer_.conclude(ended ? State::Kind::ended : State::Kind::stopped));
  if (failed_) return base::failure(*failed_);
  link_.phase.store(has_left ? Link::Phase::tripped : Link::Phase::ended, std::memory_order_release);
  return {};
}

}  // namespace leadscrew::drive
