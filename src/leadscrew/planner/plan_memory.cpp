#include <algorithm>
#include <bit>
#include <cstdint>
#include <leadscrew/planner/plan_memory.hpp>
#include <leadscrew/planner/tuning.hpp>

namespace leadscrew::planner {

namespace {

class KeyWriter {
 public:
  explicit KeyWriter(std::vector<double>& numbers) : numbers_(numbers) {}

  void add(double number) { numbers_.push_back(number); }
  void add_count(std::size_t count) { add(static_cast<double>(count)); }
  template <class Numbers>
  void add_list(const Numbers& list) {
    add_count(list.size());
    numbers_.insert(numbers_.end(), list.begin(), list.end());
  }
  void add_piece(const toolpath::Piece& piece) {
    add(piece.feed);
    add_count(static_cast<std::size_t>(piece.feed_axes));
    add(piece.sagitta);
    geometry::append_shape(piece.curve, numbers_);
  }

 private:
  std::vector<double>& numbers_;
};

}  // namespace

WindowKey::WindowKey(const Section& section, const PlannedRange& range, const std::optional<Continuation>& continuation,
                     Aim aim, std::size_t most_intervals) {
  KeyWriter key(numbers);
  for (const double number : {range.begin, range.end, range.feed_factor, range.kept_end_ramp, range.changes_from})
    key.add(number);
  key.add_count(range.starts_at_rest + 2 * range.ends_at_rest + 4 * (aim == Aim::rest));
  key.add_count(most_intervals);
  key.add_list(range.kept);
  key.add_list(range.kept_breaks);
  key.add_count(continuation.has_value());
  if (continuation) {
    key.add_list(continuation->s);
    key.add_list(continuation->breaks);
    key.add_list(continuation->c);
    key.add_list(continuation->tightened);
    key.add(continuation->end_ramp);
    key.add(continuation->share);
    key.add_count(continuation->creeping);
    key.add_count(continuation->loose);
  }
  const std::size_t first = section.piece_at(range.begin, Side::left);
  const std::size_t last = section.piece_at(range.end, Side::right);
  key.add_count(section.size() == last + 1);  // does the section go on?
  for (std::size_t index = first; index <= last; ++index) {
    key.add(section.offset(index));
    key.add_piece(section.piece(index));
  }
}

bool WindowKey::operator==(const WindowKey& other) const {
  return std::equal(numbers.begin(), numbers.end(), other.numbers.begin(), other.numbers.end(), [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  });
}

const PlanMemory::Plan* PlanMemory::find(const WindowKey& key) {
  const auto found = std::find_if(plans_.begin(), plans_.end(), [&](const Plan& plan) { return plan.key == key; });
  if (found == plans_.end()) return nullptr;
  plans_.splice(plans_.begin(), plans_, found);
  return &plans_.front();
}

void PlanMemory::keep(WindowKey key, const Window& window, double effort) {
  plans_.push_front({std::move(key), window, effort});
  bytes_ += bytes(plans_.front());
  while (bytes_ > tuning::look_ahead::remembered_bytes) {
    bytes_ -= bytes(plans_.back());
    plans_.pop_back();
  }
}

std::size_t PlanMemory::bytes(const Plan& plan) {
  const Window& window = plan.window;
  const std::size_t a_segment = sizeof(Segment) + sizeof(std::size_t) + sizeof(double);
  return sizeof(double) * plan.key.numbers.size() + window.profile.bytes() + a_segment * window.segments.size() +
         sizeof(Ratios) * window.factors.size();
}

}  // namespace leadscrew::planner
