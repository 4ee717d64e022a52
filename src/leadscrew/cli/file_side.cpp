#include <array>
#include <leadscrew/cli/file_side.hpp>
#include <leadscrew/realtime/schedule.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t nap = 1'000'000;  // ns between two looks for words

}  // namespace

base::Result<void> FileSide::run() {
  link_.phase.store(DriveLink::Phase::ready, std::memory_order_release);
  for (DriveLink::Order wanted = DriveLink::Order::follow; wanted == DriveLink::Order::follow;) {
    realtime::sleep_until(realtime::now() + nap);
    link_.beats.fetch_add(1, std::memory_order_relaxed);
    wanted = is_orphan() ? DriveLink::Order::abandon : order();
    if (wanted == DriveLink::Order::abandon) link_.words.leave();
    take_words();
  }
  return conclude(std::array{&file_});
}

void FileSide::take_words() {
  bool has_come = false;
  for (base::Word word; !failed_ && link_.words.pop(word); has_come = true) {
    took(file_.write(word));
    if (failed_) return;
    last_ = word;
    link_.taken.fetch_add(1, std::memory_order_release);
    link_.feedback.push({.word = word, .actual = word.position});
  }
  if (!has_come) return;
  took(file_.flush());
  keeper_.observe(last_, {last_.position, last_.path_length});
}

}  // namespace leadscrew::cli
