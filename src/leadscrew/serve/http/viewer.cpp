#include <fmt/format.h>

#include <chrono>
#include <leadscrew/serve/http/viewer.hpp>
#include <thread>

namespace leadscrew::serve {

namespace {

constexpr std::chrono::milliseconds longest_pause(100);
constexpr int pauses_until_heartbeat = 10, pauses_until_given_up = 600;
constexpr std::size_t most_written = 8192;  // bytes that a writable connection takes without waiting

}  // namespace

Viewer::Viewer(Channel& channel, const std::string& greeting, const std::atomic<bool>& stops)
    : channel_(channel), stops_(stops), place_(channel.latest()) {
  unwritten_.push_back(std::make_shared<const std::string>(greeting));
}

bool Viewer::feed(httplib::DataSink& sink) {
  if (!sink.is_writable()) {
    std::this_thread::sleep_for(longest_pause);
    return !stops_ && ++stalled_ < pauses_until_given_up;
  }
  stalled_ = 0;
  if (unwritten_.empty()) {
    if (is_over_) return rest(sink);
    Channel::Taken taken = channel_.take(place_, longest_pause);
    is_over_ = taken.is_over;
    if (taken.missed > 0)
      unwritten_.push_back(std::make_shared<const std::string>(
          fmt::format("event: missed\ndata: {{\"missed\": {}}}\n\n", taken.missed)));
    unwritten_.insert(unwritten_.end(), taken.events.begin(), taken.events.end());
  }
  if (unwritten_.empty()) {
    if (is_over_) return rest(sink);
    if (stops_) return false;
    // What nobody reads is told by the system when it is written.
    constexpr std::string_view heartbeat = ":\n\n";
    if (++idle_ % pauses_until_heartbeat == 0) return sink.write(heartbeat.data(), heartbeat.size());
    return true;
  }
  std::string text;
  do {
    text += *unwritten_.front();
    unwritten_.pop_front();
  } while (!unwritten_.empty() && text.size() + unwritten_.front()->size() <= most_written);
  return sink.write(text.data(), text.size());
}

bool Viewer::rest(httplib::DataSink& sink) {
  sink.done();
  return true;
}

}  // namespace leadscrew::serve
