#include <leadscrew/cli/terminal.hpp>
#include <leadscrew/cli/word_side.hpp>

namespace leadscrew::cli {

base::Result<void> WordSide::conclude(std::span<WordFile* const> files) {
  link_.concluding.store(true, std::memory_order_release);
  for (WordFile* file : files) took(file->publish());
  if (is_orphan() && link_.has_terminal.load(std::memory_order_acquire)) Terminal::restore(link_.terminal);
  const bool has_left = link_.words.has_left();
  const bool ended = !has_left && link_.at_end.load(std::memory_order_acquire);
  took(keeper_.conclude(ended ? DriveState::Kind::ended : DriveState::Kind::stopped));
  if (failed_) return base::failure(*failed_);
  link_.phase.store(has_left ? DriveLink::Phase::tripped : DriveLink::Phase::ended, std::memory_order_release);
  return {};
}

}  // namespace leadscrew::cli
