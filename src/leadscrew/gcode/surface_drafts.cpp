#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gcode/surface_drafts.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

/// Its points, once as they were told and once by their weights, and its knots with their polynomials, about.
std::size_t bytes_of_surface(const surfaces::SurfaceForm& form) {
  constexpr std::size_t of_knot = 400, of_all = 4096;
  return 2 * form.net.size() * sizeof(surfaces::NetPoint) + of_knot * (form.knots[0].size() + form.knots[1].size()) +
         of_all;
}

}  // namespace

std::shared_ptr<SurfaceDrafts> new_surface_drafts() {
  return std::make_shared<SurfaceDrafts>();
}

bool operator==(const SurfaceDraftKey& a, const SurfaceDraftKey& b) {
  return a.before == b.before && a.limits == b.limits && a.chain == b.chain &&
         surfaces::has_same_lines(a.machining, b.machining);
}

const SurfaceDrafts::Kept* SurfaceDrafts::of(const SurfaceDraftKey& key) const {
  for (const Kept& kept : kept_) {
    if (kept.key == key) return &kept;
  }
  return nullptr;
}

std::optional<SurfaceDraft> SurfaceDrafts::find(const SurfaceDraftKey& key) const {
  const std::lock_guard lock(mutex_);
  const Kept* const kept = of(key);
  if (kept == nullptr) return std::nullopt;
  ++found_;
  return kept->draft;
}

void SurfaceDrafts::keep(SurfaceDraftKey key, SurfaceDraft draft) {
  const std::size_t bytes =
      bytes_of_surface(key.machining.surface->form()) + (draft.lines ? surfaces::bytes_of(*draft.lines) : 0);
  const std::lock_guard lock(mutex_);
  if (kept_.size() == most_drafts || bytes > most_bytes - bytes_ || of(key) != nullptr) return;
  bytes_ += bytes;
  kept_.push_back({std::move(key), std::move(draft)});
}

std::size_t SurfaceDrafts::count() const {
  const std::lock_guard lock(mutex_);
  return kept_.size();
}

std::size_t SurfaceDrafts::found() const {
  const std::lock_guard lock(mutex_);
  return found_;
}

}  // namespace leadscrew::gcode
