// Derivatives are backward differences of words. Before the first word the axes are taken to stand where it is, so that
// a start from rest is judged as well.

#include <leadscrew/report/bounded_path.hpp>
#include <leadscrew/report/envelope.hpp>
#include <leadscrew/report/recording.hpp>
#include <leadscrew/report/worst_blocks.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace leadscrew::report {
namespace {

constexpr int orders = 4;  // position, velocity, acceleration, jerk

/// One axis: its differences, and what they are measured by.
struct AxisDifferences {
  base::Axis axis{};
  std::array<double, orders> last{};       ///< 0th to 3rd difference at the word before
  std::array<double, orders> limit{};      ///< of each order; [0] is not used
  std::array<double, orders> allowance{};  ///< what rounding of positions can make of a difference
  double allowance_holds_below = 0;        ///< mm or degrees
};

}  // namespace

class Recording::Implementation {
 public:
  Implementation(const machine::Machine& machine, base::Period period)
      : period_(period),
        axes_(differences_of(machine)),
        envelope_(1 + orders * axes_.size()),
        path_(machine.axis_set()) {
    for (std::size_t k = 1; k < orders; ++k) per_period_[k] = per_period_[k - 1] / period.seconds();
  }

  void observe(const base::Word& word, const base::AxisVector* tip) {
    if (envelope_.samples() == 0) begin(word);
    if (word.line != block_.line) begin_block(word.line);
    for (; !feeds_.empty() && feeds_.front().tick <= word.tick; feeds_.pop_front())
      is_rapid_ = feeds_.front().value == 0;
    double& greatest = is_rapid_ ? greatest_rapid_ : greatest_feed_;
    if (std::isfinite(word.feed)) greatest = std::max(greatest, word.feed);
    double* values = envelope_.sample();
    *values++ = word.feed;
    for (AxisDifferences& axis : axes_) {
      take_differences(axis, word.position[base::index(axis.axis)], values);
      judge(axis, values);
      values += orders;
    }
    envelope_.take();
    shows_tip_ = tip != nullptr;
    path_.observe({tip != nullptr ? *tip : word.position, is_rapid_ ? 0 : word.feed, is_rapid_});
    last_tick_ = word.tick;
    block_.duration = base::seconds(base::Tick{base::count(word.tick) - base::count(block_begins_)}, period_);
    block_.length = word.path_length - block_begins_at_;
    path_length_ = word.path_length;
  }

  std::int64_t words() const { return envelope_.samples(); }
  double time() const { return base::seconds(last_tick_, period_); }
  double bin_seconds() const { return static_cast<double>(envelope_.samples_per_bin()) * period_.seconds(); }
  std::span<const Extent> feed() { return envelope_.channel(0); }

  std::span<const Extent> axis(base::Axis axis, int order) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (axes_[i].axis == axis && 0 <= order && order < orders) {
        return envelope_.channel(1 + orders * i + static_cast<std::size_t>(order));
      }
    }
    return {};
  }

  std::span<const PathPoint> path() { return path_.points(); }
  void observe(const base::PassedEvent& event) {
    if (event.kind == base::Event::Kind::programmed_feed) return feeds_.push_back(event);
    if (!base::is_of_program(event.kind)) return;
    ++event_count_;
    if (events_.size() < most_events) events_.push_back(event);
  }
  std::int64_t event_count() const { return event_count_; }
  std::span<const base::PassedEvent> events() const { return events_; }
  void observe(const LostBlock& block) { dearest_.offer(block); }
  bool shows_tip() const { return shows_tip_; }
  double greatest_feed() const { return greatest_feed_; }
  double greatest_rapid() const { return greatest_rapid_; }
  std::vector<LostBlock> dearest() const { return dearest_.list(); }
  std::vector<BlockFigures> slowest() const { return slowest_.with(block_); }
  std::vector<BlockFigures> nearest() const { return nearest_.with(block_); }

 private:
  static std::vector<AxisDifferences> differences_of(const machine::Machine& machine) {
    std::vector<AxisDifferences> axes;
    for (const base::Axis axis : base::all_axes) {
      if (!machine.has(axis)) continue;
      const machine::AxisLimits& limits = machine.limits(axis);
      axes.push_back({axis, {}, {0, limits.velocity, limits.acceleration, limits.jerk}, {}, 0});
    }
    return axes;
  }

  void begin(const base::Word& word) {
    for (AxisDifferences& axis : axes_) axis.last[0] = word.position[base::index(axis.axis)];
    last_tick_ = word.tick;
    path_length_ = word.path_length;
    block_.line = word.line;
    block_.t_begin = time();
    block_begins_ = word.tick;
    block_begins_at_ = word.path_length;
  }

  void begin_block(base::Line line) {
    slowest_.offer(block_);
    nearest_.offer(block_);
    block_ = {};
    block_.line = line;
    block_.t_begin = time();
    block_begins_ = last_tick_;
    block_begins_at_ = path_length_;
  }

  /// Position, velocity, acceleration and jerk into values[0 … 3].
  void take_differences(AxisDifferences& axis, double position, double* values) {
    double difference = position;
    for (std::size_t k = 0; k < orders; ++k) {
      const double next = difference - axis.last[k];
      axis.last[k] = difference;
      values[k] = difference * per_period_[k];
      difference = next;
    }
    if (!(std::fabs(position) < axis.allowance_holds_below)) widen_allowance(axis, position);
  }

  /// The k-th difference of positions that are rounded to half an ulp is off by no more than 8·ulp(max |q|) for k ≤ 3.
  void widen_allowance(AxisDifferences& axis, double position) {
    axis.allowance_holds_below = std::exp2(std::floor(std::log2(std::max(std::fabs(position), 1e-6))) + 1);
    const double ulp = axis.allowance_holds_below / 2 * std::numeric_limits<double>::epsilon();
    for (std::size_t k = 1; k < orders; ++k) axis.allowance[k] = 8 * ulp * per_period_[k];
  }

  void judge(const AxisDifferences& axis, const double* values) {
    for (std::size_t k = 1; k < orders; ++k) {
      const double excess = std::fabs(values[k]) - axis.allowance[k];
      if (!(excess > block_.worst_ratio * axis.limit[k])) continue;
      block_.worst_ratio = excess / axis.limit[k];
      block_.worst_axis = axis.axis;
      block_.worst_order = static_cast<int>(k);
    }
  }

  base::Period period_;
  std::array<double, orders> per_period_{1, 0, 0, 0};  ///< 1/Tᵏ
  std::vector<AxisDifferences> axes_;
  Envelope envelope_;
  BoundedPath path_;
  BlockFigures block_;         ///< in motion
  base::Tick block_begins_{};  ///< with the last word of the block before
  double block_begins_at_ = 0;
  double path_length_ = 0;
  base::Tick last_tick_{};
  static constexpr std::size_t most_events = 200;
  std::int64_t event_count_ = 0;
  std::vector<base::PassedEvent> events_;
  std::deque<base::PassedEvent> feeds_;  ///< of words that have not come
  bool is_rapid_ = false, shows_tip_ = false;
  double greatest_feed_ = 0, greatest_rapid_ = 0;
  WorstBlocks<BlockFigures, &BlockFigures::duration> slowest_;
  WorstBlocks<BlockFigures, &BlockFigures::worst_ratio> nearest_;
  WorstBlocks<LostBlock, &LostBlock::lost> dearest_;
};

Recording::Recording(const machine::Machine& machine, base::Period period)
    : implementation_(std::make_unique<Implementation>(machine, period)) {}
Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;
Recording& Recording::operator=(Recording&&) noexcept = default;

void Recording::observe(const base::Word& word, const base::AxisVector* tip) {
  implementation_->observe(word, tip);
}
bool Recording::shows_tip() const {
  return implementation_->shows_tip();
}
void Recording::observe(const base::PassedEvent& event) {
  implementation_->observe(event);
}
void Recording::observe(const LostBlock& block) {
  implementation_->observe(block);
}
std::int64_t Recording::words() const {
  return implementation_->words();
}
double Recording::seconds() const {
  return implementation_->time();
}
double Recording::bin_seconds() const {
  return implementation_->bin_seconds();
}
std::span<const Extent> Recording::feed() const {
  return implementation_->feed();
}
double Recording::greatest_feed() const {
  return implementation_->greatest_feed();
}
double Recording::greatest_rapid() const {
  return implementation_->greatest_rapid();
}
std::span<const Extent> Recording::axis(base::Axis axis, int order) const {
  return implementation_->axis(axis, order);
}
std::span<const PathPoint> Recording::path() const {
  return implementation_->path();
}
std::vector<BlockFigures> Recording::slowest_blocks() const {
  return implementation_->slowest();
}
std::vector<BlockFigures> Recording::nearest_to_limit() const {
  return implementation_->nearest();
}
std::vector<LostBlock> Recording::dearest_blocks() const {
  return implementation_->dearest();
}
std::int64_t Recording::event_count() const {
  return implementation_->event_count();
}
std::span<const base::PassedEvent> Recording::events() const {
  return implementation_->events();
}

}  // namespace leadscrew::report
