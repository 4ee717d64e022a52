#include <algorithm>
#include <bit>
#include <cstdint>
#include <leadscrew/planner/plan_memory.hpp>
#include <leadscrew/planner/tuning.hpp>

namespace leadscrew::planner {

std::optional<WindowKey> WindowKey::of(const Section& section, const PlannedRange& range, Aim aim,
                                       std::size_t most_intervals) {
  using namespace tuning::look_ahead;
  const bool is_whole = range.begin == 0 && range.end == section.length();
  if (!is_whole || !range.starts_at_rest || !range.ends_at_rest || range.changes_from > 0) return std::nullopt;
  if (section.size() > most_remembered_pieces) return std::nullopt;
  WindowKey key;
  key.numbers = {range.feed_factor, aim == Aim::rest ? 1.0 : 0.0, static_cast<double>(most_intervals)};
  for (const toolpath::Piece& piece : section.pieces()) {
    if (piece.transformation || piece.contact) return std::nullopt;  // these numbers do not tell all of it
    key.numbers.insert(key.numbers.end(), {piece.feed, static_cast<double>(piece.feed_axes), piece.sagitta,
                                           piece.is_of_tip ? 1.0 : 0.0, piece.is_of_least_time ? 1.0 : 0.0});
    geometry::append_shape(piece.curve, key.numbers);
    if (key.numbers.size() > most_remembered_numbers) return std::nullopt;
  }
  return key;
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
