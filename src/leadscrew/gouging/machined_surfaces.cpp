#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/machined_surfaces.hpp>
#include <leadscrew/gouging/program_check.hpp>
#include <utility>

namespace leadscrew::gouging {

namespace {

using surfaces::SurfaceForm;

constexpr double same_net = 1e-7;  // mm

bool is_same(const SurfaceForm& a, const SurfaceForm& b) {
  if (a.degree != b.degree || a.count != b.count || a.knots != b.knots) return false;
  for (std::size_t i = 0; i < a.net.size(); ++i) {
    if (a.net[i].weight != b.net[i].weight) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(a.net[i].position[k] - b.net[i].position[k]) > same_net) return false;
    }
  }
  return true;
}

}  // namespace

/// In coordinates of the machine its points are where the tip is while X, Y and Z are there: a rigid motion, as long as the rotary
/// axes stand, as they do without tool centre point control.
std::shared_ptr<const surfaces::Surface> MachinedSurfaces::add(const gcode::Machined& machined,
                                                               const gcode::Frame& frame) {
  std::shared_ptr<const surfaces::Surface> surface = machined.machining.surface;
  if (!machined.is_of_tip) {
    SurfaceForm form = surface->form();
    const Vector tool = {frame.tool()[0], frame.tool()[1], frame.tool()[2]};
    const gcode::Move move;
    base::AxisVector place = frame.position;
    for (surfaces::NetPoint& point : form.net) {
      for (std::size_t k = 0; k < 3; ++k) place[k] = point.position[k];
      point.position = poses_.at(move, place, tool).tip;
    }
    surface = std::make_shared<const surfaces::Surface>(std::move(form));
  }
  for (const auto& other : surfaces_) {
    if (is_same(other->form(), surface->form())) return other;
  }
  if (surfaces_.size() >= most_surfaces) return nullptr;
  surfaces_.push_back(surface);
  numbers_.push_back(machined.number);
  return surface;
}

}  // namespace leadscrew::gouging
