#include <algorithm>
#include <leadscrew/serve/channel.hpp>

namespace leadscrew::serve {

void Channel::publish(std::string event) {
  auto shared = std::make_shared<const std::string>(std::move(event));
  {
    const std::lock_guard lock(mutex_);
    if (is_over_) return;
    events_.push_back(std::move(shared));
    if (events_.size() > kept_) {
      events_.pop_front();
      ++first_;
    }
  }
  changed_.notify_all();
}

void Channel::close() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
}

Channel::Place Channel::latest() const {
  const std::lock_guard lock(mutex_);
  return {std::max(first_, end() - 1)};
}

Channel::Taken Channel::take(Place& place, std::chrono::milliseconds longest_wait) {
  Taken taken;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest_wait, [&] { return is_over_ || place.next < end(); });
  taken.missed = std::max<std::int64_t>(0, first_ - place.next);
  place.next = std::max(place.next, first_);
  taken.events.assign(events_.begin() + (place.next - first_), events_.end());
  place.next = end();
  taken.is_over = is_over_;
  return taken;
}

}  // namespace leadscrew::serve
