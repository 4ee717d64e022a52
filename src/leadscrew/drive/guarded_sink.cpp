#include <fmt/format.h>

#include <array>
#include <leadscrew/drive/guarded_sink.hpp>
#include <string_view>

namespace leadscrew::drive {

realtime::WordSink GuardedSink::sink() {
  return {.take = [this](const base::Word& word) { return take(word); },
          .append_stop_position =
              [this](const base::PathPlace& place) {
                stop_path_guard_.observe(place.position);
                return link_.words.append_stop_position(place);
              },
          .publish = [this] { return publish(); },
          .event = [this](const base::PassedEvent& event) { return link_.events.push(event); }};
}

bool GuardedSink::take(const base::Word& word) noexcept {
  if (link_.words.waiting() >= most_waiting_ || !link_.words.push(word)) return false;
  guard_.observe(word.position);
  stop_path_guard_ = guard_;
  return true;
}

bool GuardedSink::publish() noexcept {
  if (!stop_path_guard_.refused()) return link_.words.publish();
  has_refused_.store(true, std::memory_order_release);
  return false;
}

std::optional<base::Diagnostic> GuardedSink::problem() const {
  constexpr std::array<std::string_view, 3> limits = {"travel", "velocity", "acceleration"};
  const std::optional<RefusedWord>& refused = stop_path_guard_.refused();
  if (!refused) return std::nullopt;
  return base::problem(
      "word-refused",
      fmt::format("a word would lead {} to {:.6g}, beyond its {}: no drive got it", base::letter(refused->axis),
                  refused->position, limits[static_cast<std::size_t>(refused->reason)]),
      "this is a defect of leadscrew: please report it, with the program and the machine file");
}

}  // namespace leadscrew::drive
