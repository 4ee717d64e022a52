#include <leadscrew/drive/terminal.hpp>
#include <leadscrew/drive/word_side.hpp>

namespace leadscrew::drive {

base::Result<void> WordSide::open_events(const Setup& setup) {
  const auto& path = setup.options.events;
  return path ? event_file_.open(*path, setup.machine.period) : base::Result<void>();
}

std::span<const base::PassedEvent> WordSide::take_events(const base::Word& word) {
  const std::size_t taken = events_.size();
  while (true) {
    if (!next_event_ && !link_.events.pop(next_event_.emplace())) next_event_.reset();
    if (!next_event_ || next_event_->tick > word.tick) break;
    poses_.observe(*next_event_);
    events_.push_back(*next_event_);
    next_event_.reset();
  }
  poses_.advance(word.tick);
  return std::span(events_).subspan(taken);
}

base::Result<void> WordSide::write_events() {
  base::Result<void> written;
  for (const base::PassedEvent& event : events_) {
    if (written) written = event_file_.write(event);
  }
  events_.clear();
  return written;
}

base::Result<void> WordSide::conclude(std::span<files::WordFile* const> files) {
  link_.concluding.store(true, std::memory_order_release);
  for (files::WordFile* file : files) took(file->publish());
  took(event_file_.publish());
  if (is_orphan() && link_.has_terminal.load(std::memory_order_acquire)) Terminal::restore(link_.terminal);
  const bool has_left = link_.words.has_left();
  const bool ended = !has_left && link_.at_end.load(std::memory_order_acquire);
  took(state_writer_.conclude(ended ? State::Kind::ended : State::Kind::stopped));
  if (failed_) return base::failure(*failed_);
  link_.phase.store(has_left ? Link::Phase::tripped : Link::Phase::ended, std::memory_order_release);
  return {};
}

}  // namespace leadscrew::drive
