// Many words in one call: what lies along a line or an arc goes to a kernel, block by block, all else word by word.

#include <algorithm>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/interpolator/tick_time.hpp>
#include <tuple>

namespace leadscrew::interpolator {

using numeric::DoubleDouble;

namespace {

/// Fewer are made as fast one by one.
constexpr std::size_t fewest_words = 4;

constexpr std::int64_t greatest_whole = std::int64_t{1} << 53;  // up to here every whole number is a double

base::Tick after(base::Tick tick, std::size_t count) {
  return base::Tick{base::count(tick) + static_cast<std::int64_t>(count)};
}

}  // namespace

std::size_t Interpolator::next(std::span<base::Word> words) {
  std::size_t made = 0;
  if (thread_ || passed_ < events_of_part()) {  // each is told with its own word
    if (!words.empty() && !wants_chunk()) words[made++] = next();
    return made;
  }
  while (made < words.size() && !wants_chunk()) {
    const std::size_t together = next_of_piece(words.subspan(made));
    made += together;
    if (together == 0) words[made++] = next();
  }
  return made;
}

/// How many ticks, from the next word's on and at most `most`, lie before `end`, which must lie behind the next word. The
/// floating-point part depends on `end` alone, so that the processor can begin it before the next word's tick is known.
std::size_t Interpolator::ticks_before(DoubleDouble end, std::size_t most) const {
  const double estimate = std::min(end.hi * ticks_per_second_, 0x1p62);
  const double doubtful = 1e-15 * estimate;  // three roundings
  const auto whole = static_cast<std::int64_t>(estimate);
  const double fraction = estimate - static_cast<double>(whole);
  const bool is_clear = doubtful < fraction && fraction < 1 - doubtful;
  const std::int64_t greatest = whole - base::count(tick_) + (is_clear ? 1 : 2);
  std::size_t count = greatest > 1 ? std::min(static_cast<std::size_t>(greatest), most) : 1;
  if (is_clear) return count;
  while (count > 1 && end <= time_of(after(tick_, count - 1), period_)) --count;
  return count;
}

/// The next words of the piece in motion, if a kernel can make them; else none.
std::size_t Interpolator::next_of_piece(std::span<base::Word> words) {
  const std::size_t most = std::min(words.size(), words_in_block);
  if (most < fewest_words || base::count(after(tick_, most)) > greatest_whole / period_.nanoseconds) return 0;
  const planner::Segment& first = segment_at(now_);
  if (first.state == base::MotionState::rest) return 0;
  const toolpath::Piece& piece = chunk_->pieces[first.piece];
  const geometry::Line* const line = piece.axes().line();
  if ((!line && !piece.axes().arc()) || piece.lines) return 0;
  if (!line && piece.feed_axes != toolpath::FeedAxes::none) return 0;
  Block block;
  block.curve = &piece.curve;
  if (!block.is_in_range()) return 0;
  block.tick = tick_;
  block.nanoseconds = static_cast<double>(base::count(tick_) * period_.nanoseconds);
  block.period = static_cast<double>(period_.nanoseconds);
  block.length_before = length_before_;
  // Along a line the same everywhere.
  if (piece.feed_axes != toolpath::FeedAxes::none) block.feed_rate = toolpath::rate(line->jets(0), piece.feed_axes);
  block.line = piece.line;
  const std::tuple begin(tick_, now_, segment_, segment_begin_, segment_end_, length_before_);
  while (block.count < most && !wants_chunk()) {
    const planner::Segment& segment = segment_at(now_);
    if (segment.piece != first.piece || segment.state == base::MotionState::rest) break;
    const std::size_t count = ticks_before(segment_end_ < end_ ? segment_end_ : end_, most - block.count);
    if (!block.add(segment, segment_begin_, count)) break;
    tick_ = after(tick_, count);
    now_ = time_of(tick_, period_);
  }
  if (block.count >= fewest_words && make_words(kernel_, block, words)) return block.count;
  std::tie(tick_, now_, segment_, segment_begin_, segment_end_, length_before_) = begin;
  for (std::size_t k = 0; k < block.count; ++k) words[k] = next();
  return block.count;
}

}  // namespace leadscrew::interpolator
