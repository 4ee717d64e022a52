#include <condition_variable>
#include <deque>
#include <leadscrew/realtime/passes_ahead.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace leadscrew::realtime {

namespace {

class PassesAhead : public surfaces::PassSource {
 public:
  PassesAhead(surfaces::Passes& passes, std::atomic<double>& seconds)
      : passes_(passes), seconds_(seconds), maker_([this](const std::stop_token& stop) { make(stop); }) {}

  std::optional<surfaces::Pass> next() override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !made_.empty() || is_done_; });
    if (made_.empty()) return std::nullopt;
    surfaces::Pass pass = std::move(made_.front());
    made_.pop_front();
    lock.unlock();
    changed_.notify_all();
    return pass;
  }

 private:
  static constexpr std::size_t most_made = 8;

  void make(const std::stop_token& stop) {
    bool goes_on = true;
    while (goes_on) {
      std::optional<surfaces::Pass> pass = passes_.next();
      std::unique_lock lock(mutex_);
      goes_on = pass.has_value() && changed_.wait(lock, stop, [this] { return made_.size() < most_made; }) &&
                !stop.stop_requested();
      if (goes_on) made_.push_back(std::move(*pass));
      if (!goes_on) seconds_ += SystemClocks::processor_seconds();  // of a thread that has made nothing else
      is_done_ = !goes_on;
      lock.unlock();
      changed_.notify_all();
    }
  }

  surfaces::Passes& passes_;
  std::atomic<double>& seconds_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<surfaces::Pass> made_;
  bool is_done_ = false;
  std::jthread maker_;  // the last: it uses all of the above
};

}  // namespace

std::unique_ptr<surfaces::PassSource> passes_ahead(surfaces::Passes& passes, std::atomic<double>& seconds) {
  try {
    return std::make_unique<PassesAhead>(passes, seconds);
  } catch (const std::system_error&) {
    return nullptr;
  }
}

}  // namespace leadscrew::realtime
