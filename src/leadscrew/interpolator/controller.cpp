#include <algorithm>
#include <leadscrew/interpolator/controller.hpp>
#include <utility>

namespace leadscrew::interpolator {

Controller::Controller(base::Period period, const base::AxisVector& position, std::size_t capacity, double path_length,
                       base::Line line)
    : capacity_(std::max<std::size_t>(capacity, 2)),
      links_(std::make_unique<Link[]>(capacity_)),
      interpolator_(period, position, path_length, line) {}

base::Word Controller::next() noexcept {
  // Bounded: a turn begins one of the accepted chunks or one's tail, and as the position is told only afterwards, the
  // planner cannot put more than capacity − 1 in front of one call. Chunks far shorter than a period pass in a row.
  event_link_ = current_;
  event_ = interpolator_.events_passed();
  while (interpolator_.wants_chunk() && go_on()) {
  }
  const bool stands = interpolator_.at_rest();
  const base::Word word = interpolator_.next();
  while (event_link_ < current_ && event_ == events_passed(event_link_)) {
    ++event_link_;
    event_ = 0;
  }
  // Before the position, so that who sees the last chunk begun sees no older rest.
  stands_.store(stands, std::memory_order_relaxed);
  in_step_.store(interpolator_.is_in_step(), std::memory_order_relaxed);
  spindle_speed_.store(interpolator_.spindle_speed(), std::memory_order_relaxed);
  tell_threads();
  position_.store(current_, std::memory_order_release);
  left_.store(event_link_, std::memory_order_release);
  return word;
}

void Controller::tell_threads() noexcept {
  const ThreadFigures& threads = interpolator_.threads();
  thread_lines_.store(threads.lines, std::memory_order_relaxed);
  run_in_.store(threads.run_in, std::memory_order_relaxed);
  run_in_line_.store(threads.run_in_line, std::memory_order_relaxed);
  out_of_step_.store(threads.out_of_step, std::memory_order_relaxed);
  out_of_step_line_.store(threads.out_of_step_line, std::memory_order_relaxed);
}

ThreadFigures Controller::threads() const {
  return {.lines = thread_lines_.load(std::memory_order_relaxed),
          .run_in = run_in_.load(std::memory_order_relaxed),
          .run_in_line = run_in_line_.load(std::memory_order_relaxed),
          .out_of_step = out_of_step_.load(std::memory_order_relaxed),
          .out_of_step_line = out_of_step_line_.load(std::memory_order_relaxed)};
}

const planner::PlacedEvent* Controller::next_event() noexcept {
  while (event_ == events_passed(event_link_)) {
    if (event_link_ == current_) return nullptr;
    ++event_link_;
    event_ = 0;
  }
  return &link(event_link_).chunk.event(event_++);
}

/// Of a chunk, by the last word.
std::size_t Controller::events_passed(std::int64_t number) const noexcept {
  return number == current_ ? interpolator_.events_passed() : link(number).events_passed;
}

/// The chunk in motion, or its tail, has ended: goes on with its successor or its tail. False if there is neither.
bool Controller::go_on() noexcept {
  if (interpolator_.has_left_step()) return false;
  const bool is_followed = link(current_).succession.claim();
  if (interpolator_.has_stop_tail_left() && !(is_followed && !link(current_ + 1).chunk.begins_at_rest())) {
    interpolator_.run_stop_tail();
    if (!is_followed) starvations_.store(starvations_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    return true;
  }
  if (!is_followed) return false;
  link(current_).events_passed = interpolator_.events_of_part();
  interpolator_.leave_chunk();
  interpolator_.load(link(++current_).chunk);
  return true;
}

Controller::Offer Controller::offer(std::span<planner::Chunk> chunks) {
  const auto is_checked = [](const planner::Chunk& chunk) {
    return std::all_of(chunk.pieces.begin(), chunk.pieces.end(),
                       [](const toolpath::Piece& piece) { return piece.travel.is_inside(); });
  };
  if (!std::all_of(chunks.begin(), chunks.end(), is_checked)) return Offer::unchecked;
  const auto count = static_cast<std::int64_t>(chunks.size());
  if (accepted_ + count - left_.load(std::memory_order_acquire) >= static_cast<std::int64_t>(capacity_))
    return Offer::full;
  Link& last = link(accepted_);
  const bool begins_at_rest = chunks.front().begins_at_rest();
  // Looked at first, so that a late chunk is not moved from.
  const bool is_late = last.chunk.stop_tail.empty() || last.succession.is_closed();
  if (!begins_at_rest && is_late) return Offer::late;
  for (std::int64_t k = 0; k < count; ++k) {
    Link& fresh = link(accepted_ + 1 + k);
    fresh.chunk = std::move(chunks[static_cast<std::size_t>(k)]);
    fresh.committed_seconds = link(accepted_ + k).committed_seconds + fresh.chunk.duration.value();
    fresh.succession.reset(k + 1 < count);
  }
  if (!append(last, begins_at_rest)) {
    for (std::int64_t k = 0; k < count; ++k)
      chunks[static_cast<std::size_t>(k)] = std::move(link(accepted_ + 1 + k).chunk);
    return Offer::late;
  }
  accepted_ += count;
  return Offer::accepted;
}

/// Releases the link after `last` to the cycle; false if it begins in motion and the cycle has closed `last`.
bool Controller::append(Link& last, bool begins_at_rest) {
  if (!begins_at_rest) return last.succession.follow();
  last.succession.follow_at_rest();
  return true;
}

double Controller::seconds_ahead() const {
  return link(accepted_).committed_seconds - link(begun()).committed_seconds;
}

bool Controller::idle() const {
  return begun() == accepted_ && stands_.load(std::memory_order_relaxed);
}

}  // namespace leadscrew::interpolator
