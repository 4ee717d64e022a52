#include <leadscrew/drive/state_writer.hpp>
#include <leadscrew/realtime/schedule.hpp>

namespace leadscrew::drive {

namespace {

constexpr std::int64_t interval = 100'000'000;  // ns between two states on disk

}  // namespace

StateWriter::StateWriter(std::optional<std::string> path, const State& state) : path_(std::move(path)), state_(state) {
  if (path_) thread_ = std::thread([this] { write_states(); });
}

base::Result<void> StateWriter::conclude(State::Kind kind) {
  end();
  static_cast<void>(take_seen());
  state_.kind = kind;
  if (!path_) return {};
  return write_state(*path_, state_);
}

void StateWriter::write_states() {
  while (!ended_.load()) {
    // The last state says whether this can be done.
    if (take_seen()) static_cast<void>(write_state(*path_, state_));
    realtime::sleep_until(realtime::now() + interval);
  }
}

bool StateWriter::take_seen() {
  Seen seen;
  if (!seen_.take(seen)) return false;
  state_.kind = State::Kind::moving;
  state_.word = seen.word;
  state_.axes = seen.axes;
  state_.tool = seen.tool;
  return true;
}

void StateWriter::end() {
  ended_.store(true);
  if (thread_.joinable()) thread_.join();
}

}  // namespace leadscrew::drive
