#include <algorithm>
#include <cmath>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <limits>

namespace leadscrew::pipeline {

namespace {

double feed_asked(const gcode::Move& move, double length) {
  switch (move.feed.mode) {
    case gcode::Feed::Mode::units_per_second:
      return move.feed.value;
    case gcode::Feed::Mode::per_second:
      return move.feed.value * length;
    case gcode::Feed::Mode::rapid:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<std::pair<Cause, double>> ranked(const LostByCause& lost) {
  std::vector<std::pair<Cause, double>> list(lost.begin(), lost.end());
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return list;
}

LostTime::LostTime(const machine::Machine& machine, Sink block) : machine_(machine), sink_(std::move(block)) {}

std::optional<double> block_length(const gcode::Move& move) {
  if (move.kind == gcode::Move::Kind::event) return std::nullopt;
  if (move.kind == gcode::Move::Kind::dwell) return 0;
  const double length = toolpath::feed_length(move);
  return length == 0 ? std::nullopt : std::optional(length);
}

bool LostTime::observe(const gcode::Move& move) {
  const std::optional<double> length = block_length(move);
  if (!length) return false;
  Asked asked;
  asked.is_dwell = move.kind == gcode::Move::Kind::dwell;
  asked.length = *length;
  asked.block.line = move.line;
  asked.block.from = move.start;
  asked.block.to = move.end;
  asked.block.middle = move.end;
  asked.block.feed_asked = asked.is_dwell ? 0 : feed_asked(move, asked.length);
  moves_.push_back(asked);
  return true;
}

void LostTime::observe(const base::Word& word) {
  if (count_ == 0) {
    words_.fill(word);
    least_ = greatest_ = word.position;
  }
  std::rotate(words_.begin(), words_.begin() + 1, words_.end());
  words_.back() = word;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    least_[i] = std::min(least_[i], word.position[i]);
    greatest_[i] = std::max(greatest_[i], word.position[i]);
  }
  // The period in the middle of four words, the first of which is that before t = 0, at rest too.
  if (++count_ >= 3) account();
}

void LostTime::finish() {
  if (count_ > 1) observe(base::Word(words_.back()));  // at rest it stays where it is
  while (!moves_.empty()) close_block();
}

/// Of the four words.
NearLimits LostTime::near_limits() const {
  const double period = machine_.period.seconds();
  NearLimits near;
  double bend = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!machine_.has(axis)) continue;
    const machine::AxisLimits& limits = machine_.limits(axis);
    const std::size_t i = base::index(axis);
    const double first = words_[1].position[i] - words_[0].position[i];
    const double middle = words_[2].position[i] - words_[1].position[i];
    const double last = words_[3].position[i] - words_[2].position[i];
    near.velocity.raise(std::abs(middle) / period / limits.velocity, axis);
    const double second = std::max(std::abs(middle - first), std::abs(last - middle)) / (period * period);
    near.acceleration.raise(second / limits.acceleration, axis);
    near.jerk.raise(std::abs(last - 2 * middle + first) / (period * period * period) / limits.jerk, axis);
    if (!base::is_rotary(axis)) bend += (last - middle) * (last - middle);
  }
  near.chord = std::sqrt(bend) / 8 / machine_.chord_error;
  return near;
}

/// Of the period between the second and the third word.
void LostTime::account() {
  const base::Word &before = words_[1], &word = words_[2];
  go_to(word);
  const double period = machine_.period.seconds(), length = word.path_length - before.path_length;
  const base::Word& faster = word.speed > before.speed ? word : before;
  const double feed_length = faster.speed > 0 ? length * (faster.feed / faster.speed) : length;
  Asked* const asked = moves_.empty() ? nullptr : &moves_.front();
  const NearLimits near = near_limits();
  Cause cause = near.nearest();
  double least = 0;
  if (length == 0) {
    cause = {asked != nullptr && asked->is_dwell ? Cause::Kind::dwell : Cause::Kind::stop, base::Axis::X};
  } else if (asked != nullptr && std::isfinite(asked->block.feed_asked) && asked->block.feed_asked > 0) {
    least = feed_length / asked->block.feed_asked;
  } else {
    least = period * std::min(1.0, near.velocity.value);
  }
  lost_[cause] += period - least;
  if (asked == nullptr) return;
  if (travelled_ <= asked->length / 2) asked->block.middle = before.position;
  if (asked->block.seconds == 0) asked->block.begin = base::seconds(before.tick, machine_.period);
  travelled_ += feed_length;
  asked->block.length += feed_length;
  asked->block.feed_reached = std::max(asked->block.feed_reached, word.feed);
  asked->block.seconds += period;
  asked->block.least_seconds += least;
  lost_in_block_[cause] += period - least;
}

/// To the move that the word is of: by its line, and where several have one, by how far it is along them.
void LostTime::go_to(const base::Word& word) {
  while (moves_.size() > 1) {
    const Asked& now = moves_.front();
    const Asked& next = moves_[1];
    const bool has_passed = now.block.line == word.line
                                ? next.block.line == word.line &&
                                      (now.is_dwell ? word.speed > 0 : travelled_ >= now.length * (1 - 1e-6) - 1e-6)
                                : !base::is_before(word.line, next.block.line);
    if (!has_passed) return;
    close_block();
  }
}

void LostTime::close_block() {
  BlockTime& block = moves_.front().block;
  const auto most = std::max_element(lost_in_block_.begin(), lost_in_block_.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != lost_in_block_.end()) block.cause = most->first;
  if (sink_) sink_(block);
  lost_in_block_.clear();
  travelled_ = 0;
  moves_.pop_front();
}

}  // namespace leadscrew::pipeline
