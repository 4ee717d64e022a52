#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/modal_state.hpp>
#include <leadscrew/measuring/program_tools.hpp>

namespace leadscrew::measuring {

namespace {

std::optional<ToolBody> body_of(const machine::Tool* tool) {
  if (tool == nullptr || !tool->corner_radius || tool->diameter <= 0) return std::nullopt;
  ToolBody body{tool->diameter / 2, *tool->corner_radius};
  if (tool->length > 0) body.length = tool->length;
  return body;
}

bool is_same(const ProgramSurface& surface, const gcode::Machined& other, const std::array<double, 3>& offset) {
  constexpr double rounding = 1e-9;  // mm
  const surfaces::Machining &a = surface.machined->machining, &b = other.machining;
  if (surface.machined->is_of_tip != other.is_of_tip || a.side != b.side || !(a.u == b.u) || !(a.v == b.v))
    return false;
  const surfaces::SurfaceForm &form = a.surface->form(), &other_form = b.surface->form();
  if (form.degree != other_form.degree || form.knots != other_form.knots || form.net.size() != other_form.net.size())
    return false;
  for (std::size_t k = 0; k < form.net.size(); ++k) {
    if (form.net[k].weight != other_form.net[k].weight) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const double apart = form.net[k].position[i] - surface.offset[i] - other_form.net[k].position[i] + offset[i];
      if (std::abs(apart) > rounding) return false;
    }
  }
  return true;
}

/// How many mm there are to be between passes, by what they leave, roughly.
double step_of(const surfaces::Machining& machining) {
  if (machining.step > 0) return machining.step;
  return std::sqrt(8 * machining.cutter.radius * machining.scallop);
}

}  // namespace

void ProgramTools::see(const gcode::Move& move, const gcode::Reader& reader) {
  const gcode::MachinedMove& machined = reader.machined();
  const base::AxisVector& offset = reader.frame().tool();
  const std::array<double, 3> of_tip = {offset[0], offset[1], offset[2]};
  const machine::Tool* const tool =
      machined.surface ? &machined.surface->tool : tools_->find(reader.modal().loaded_tool);
  const BlockTool here{body_of(tool), of_tip};
  const std::int64_t line = base::number(move.line);
  if (runs_.empty() || !(runs_.back().tool == here)) {
    runs_.push_back({line, line, here});
  } else {
    runs_.back().first = std::min(runs_.back().first, line);
    runs_.back().last = std::max(runs_.back().last, line);
  }
  if (machined.surface) see_surface(machined, of_tip);
}

void ProgramTools::see_surface(const gcode::MachinedMove& move, const std::array<double, 3>& offset) {
  const std::size_t passes = move.pass + 1;
  if (last_.lock() == move.surface) {
    if (last_index_ == surfaces_.size()) return;
    ProgramSurface& surface = surfaces_[last_index_];
    if (surface.machined == move.surface) surface.passes = std::max(surface.passes, passes);
    return;
  }
  last_ = move.surface;
  const std::array<double, 3> by = move.surface->is_of_tip ? std::array<double, 3>{} : offset;
  const auto same = std::find_if(surfaces_.begin(), surfaces_.end(),
                                 [&](const ProgramSurface& surface) { return is_same(surface, *move.surface, by); });
  last_index_ = static_cast<std::size_t>(same - surfaces_.begin());
  if (same != surfaces_.end()) {
    if (step_of(move.surface->machining) <= step_of(same->machined->machining)) *same = {move.surface, passes, by};
  } else if (surfaces_.size() < most_surfaces) {
    surfaces_.push_back({move.surface, passes, by});
  } else {
    ++left_out_;
  }
}

const BlockTool* ProgramTools::tool_of(std::optional<std::int64_t> line) {
  if (runs_.empty()) return nullptr;
  if (!line) {
    const bool differ = std::any_of(runs_.begin(), runs_.end(),
                                    [&](const Run& run) { return run.tool.body && !(run.tool == runs_.back().tool); });
    return differ ? nullptr : &runs_.back().tool;
  }
  // From the run of the word before on, round to those before it.
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    const std::size_t at = (at_ + k) % runs_.size();
    if (*line < runs_[at].first || *line > runs_[at].last) continue;
    at_ = at;
    break;
  }
  return &runs_[at_].tool;
}

Target target_of(const ProgramSurface& surface, std::optional<double> reach, std::size_t most_places) {
  const surfaces::Machining& machining = surface.machined->machining;
  Target target{machining.surface->form(), machining.u, machining.v, machining.side};
  for (surfaces::NetPoint& point : target.form.net) {
    for (std::size_t k = 0; k < 3; ++k) point.position[k] -= surface.offset[k];
  }
  const bool along_u = machining.along == surfaces::Direction::u;
  target.across = along_u ? Target::Across::v : Target::Across::u;
  target.step = step_of(machining);
  if (machining.pattern == surfaces::Pattern::spiral_in || machining.pattern == surfaces::Pattern::planar) {
    target.across = Target::Across::both;
  } else if (machining.step == 0 && surface.passes > 1) {
    const double length = length_along(target, along_u ? surfaces::Direction::v : surfaces::Direction::u);
    target.step = length / static_cast<double>(surface.passes - 1);
  }
  target.expected =
      machining.scallop > 0 ? machining.scallop : target.step * target.step / (8 * machining.cutter.radius);
  target.reach = reach.value_or(std::max(1.0, 4 * target.expected));
  target.most_places = most_places;
  return target;
}

}  // namespace leadscrew::measuring
