#pragma once
// Words from the process that makes them (the maker) to the drives, always with a way to rest behind them, the stop
// path: the maker may be killed, stopped or late at any instant, and leave the drives in the middle of a curve.
//
//   words    ··─┬───┬───┬───┬───┐ ··· pushed, not yet published
//             read        head  │
//   stop paths                  ├───┬──┬─┬● to rest, by the stop tail of the plan: one belongs to the head,
//                                           the other is written for the next one
//
// One number says where the head is, which of the two stop paths belongs to it, and whether the drives have left. The
// maker publishes by changing it from one head to the next; drives that find no word left change the same number to
// "left", and follow the stop path of the head that they saw. The change that comes first decides, and the other side
// sees it: no word is published after drives have left, and no stop path is overwritten that they may be following.
// Without a lock and without pointers: this may lie in memory that two processes share.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/word.hpp>
#include <leadscrew/realtime/untouched_array.hpp>
#include <type_traits>

namespace leadscrew::realtime {

/// Holds at most so many words, and stop paths of so many periods. One thread makes words, another is the drives.
template <std::size_t most_words, std::size_t longest_stop_path>
class WordStream {
  static_assert(std::is_trivially_copyable_v<base::Word> && std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// `room`: of words, 1 … most_words; memory of so many is touched, and of stop paths of `usual_stop` periods, and no other.
  explicit WordStream(std::size_t room = most_words, std::size_t usual_stop = 0) noexcept : room_(room) {
    for (std::size_t k = 0; k < room_; ++k) words_.write(k, {});
    for (StopPath& stop_path : stop_paths_) {
      for (std::size_t k = 0; k < std::min(usual_stop, longest_stop_path); ++k) stop_path.places.write(k, {});
    }
  }

  // The maker's.

  /// How many words wait to be taken, published or not.
  std::size_t waiting() const noexcept {
    return static_cast<std::size_t>(pushed_ - read_.load(std::memory_order_acquire));
  }
  /// Not seen by the drives before it is published. False if there is no room.
  bool push(const base::Word& word) noexcept {
    if (waiting() >= room_) return false;
    words_.write(pushed_++ % room_, word);
    return true;
  }
  /// Appends a place, a period later, to the stop path behind the last word pushed. False if it is too long.
  bool append_stop_position(const base::PathPlace& place) noexcept {
    StopPath& stop_path = stop_paths_[spare_];
    if (stop_path.size == longest_stop_path) return false;
    stop_path.places.write(stop_path.size++, place);
    return true;
  }
  /// All words pushed so far, and the stop path behind them. False if the drives have left: then they never see them.
  bool publish() noexcept {
    std::uint64_t seen = state_.load(std::memory_order_relaxed);
    const std::uint64_t next = pushed_ << 2 | spare_ << 1;
    if (has_left(seen) || !state_.compare_exchange_strong(seen, next, std::memory_order_acq_rel)) return false;
    spare_ = 1 - spare_;
    stop_paths_[spare_].size = 0;
    return true;
  }

  // The drives'.

  /// The next published word. False if there is none.
  bool pop(base::Word& word) noexcept {
    const std::uint64_t number = read_.load(std::memory_order_relaxed);
    if (number == head(state_.load(std::memory_order_acquire))) return false;
    words_.read(number % room_, word);
    read_.store(number + 1, std::memory_order_release);
    return true;
  }
  /// Nothing more is published: what has been can still be taken.
  void leave() noexcept { state_.fetch_or(left, std::memory_order_acq_rel); }
  /// Leaves unless there is a word to take: then false.
  bool leave_if_empty() noexcept {
    std::uint64_t seen = state_.load(std::memory_order_acquire);
    if (head(seen) != read_.load(std::memory_order_relaxed)) return false;
    return has_left(seen) || state_.compare_exchange_strong(seen, seen | left, std::memory_order_acq_rel);
  }
  bool has_left() const noexcept { return has_left(state_.load(std::memory_order_acquire)); }
  /// Having left, and taken all words: the next place on the stop path. False behind its end.
  bool follow_stop_path(base::PathPlace& place) noexcept {
    const StopPath& stop_path = stop_paths_[state_.load(std::memory_order_acquire) >> 1 & 1];
    if (followed_ == stop_path.size) return false;
    stop_path.places.read(followed_++, place);
    return true;
  }

 private:
  static constexpr std::size_t cache_line = 64;
  static constexpr std::uint64_t left = 1;

  struct StopPath {
    std::size_t size = 0;
    UntouchedArray<base::PathPlace, longest_stop_path> places;
  };

  static std::uint64_t head(std::uint64_t state) noexcept { return state >> 2; }
  static bool has_left(std::uint64_t state) noexcept { return (state & left) != 0; }

  alignas(cache_line) std::atomic<std::uint64_t> state_{0};  ///< head · 4 + stop path · 2 + left
  alignas(cache_line) std::atomic<std::uint64_t> read_{0};
  std::size_t followed_ = 0;                      ///< of the stop path; the drives'
  alignas(cache_line) std::uint64_t pushed_ = 0;  ///< the maker's
  std::uint64_t spare_ = 1;                       ///< stop path that is being written; the maker's
  const std::size_t room_;
  alignas(cache_line) UntouchedArray<base::Word, most_words> words_;
  std::array<StopPath, 2> stop_paths_;
};

}  // namespace leadscrew::realtime
