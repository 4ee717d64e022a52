#include <algorithm>
#include <leadscrew/gouging/machined_surfaces.hpp>
#include <leadscrew/gouging/program_check.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::gouging {

namespace {

using gcode::MachinedMove;
using gcode::Move;

constexpr std::int64_t moves_between_checks = 64;
constexpr double straight = 1 - 1e-12;           // cosine
constexpr double rounding_of_curvature = 1e-10;  // 1/mm

template <typename Key, typename Found, typename IsWorse>
void take_worse(std::map<Key, Found>& all, const Key& key, const Found& found, const IsWorse& is_worse) {
  const auto at = all.find(key);
  if (at != all.end()) {
    if (is_worse(found, at->second)) at->second = found;
  } else if (all.size() < GougeVerdict::most_blocks) {
    all.emplace(key, found);
  }
}

Vector offset_of(const gcode::Frame& frame) {
  return {frame.tool()[0], frame.tool()[1], frame.tool()[2]};
}

bool is_motion_of(const Move& move) {
  return move.kind == Move::Kind::line || move.kind == Move::Kind::arc || move.kind == Move::Kind::nurbs;
}

/// Out of the surface along the tool's axis: what it has cut there is the move's before.
bool is_withdrawal(const Way& way) {
  const Pose begin = way.at(0), end = way.at(1);
  const Vector along = numeric::difference(end.tip, begin.tip);
  return begin.axis == end.axis && numeric::dot(along, begin.axis) >= straight * numeric::norm(along);
}

class ProgramCheck {
 public:
  ProgramCheck(const machine::Machine& machine, const machine::ToolTable& tools, const GougeOptions& options)
      : tools_(tools), options_(options), poses_(machine), surfaces_(poses_) {
    verdict_.tolerance = std::max(options.tolerance, least_tolerance);
  }

  GougeVerdict check(const std::function<gcode::Reader()>& open) {
    gather(open());
    verdict_.surfaces = surfaces_.all().size();
    if (!verdict_.fits || surfaces_.all().empty()) return verdict_;
    const Workpiece workpiece(surfaces_.all(), verdict_.tolerance / 4);
    verdict_.fits = workpiece.fits();
    verdict_.sag = workpiece.sag();
    verdict_.triangles = workpiece.triangles();
    if (verdict_.fits) follow(open(), workpiece);
    return verdict_;
  }

 private:
  bool is_interrupted(std::int64_t count) const {
    return count % moves_between_checks == 0 && options_.is_interrupted && options_.is_interrupted();
  }

  void gather(gcode::Reader reader);
  void judge_contacts(const gcode::Machined& machined, const surfaces::Surface& placed);
  void follow(gcode::Reader reader, const Workpiece& workpiece);
  void hold(const machine::Tool* tool, Sweep& sweep);
  bool begins_clear(const Way& way, const Workpiece& workpiece);
  void judge(const Deepest& deepest, const Move& move, const MachinedMove& machined, const Workpiece& workpiece);

  const machine::ToolTable& tools_;
  const GougeOptions& options_;
  MovePoses poses_;
  MachinedSurfaces surfaces_;
  GougeVerdict verdict_;
  std::optional<machine::Tool> held_;
  std::optional<Tool> tool_;  // where the shape of that is told
  Vector offset_{};           // of the length of the one in the block
  bool is_clear_ = false;
};

void ProgramCheck::gather(gcode::Reader reader) {
  std::shared_ptr<const gcode::Machined> last;
  Move move;
  for (std::int64_t count = 1; reader.next(move) && !is_interrupted(count); ++count) {
    const auto& machined = reader.machined().surface;
    if (!machined || machined == last) continue;
    last = machined;
    const auto placed = surfaces_.add(*machined, reader.frame());
    if (!placed) {
      verdict_.fits = false;
      return;
    }
    offset_ = offset_of(reader.frame());
    judge_contacts(*machined, *placed);
  }
  verdict_.files = reader.files();
}

void ProgramCheck::judge_contacts(const gcode::Machined& machined, const surfaces::Surface& placed) {
  surfaces::Machining machining = machined.machining;
  machining.allows_gouging = true;
  surfaces::Passes passes(machining);
  while (passes.next()) {
  }
  if (!passes.least_clearance()) return;
  const auto& least = *passes.least_clearance();
  const Vector place = placed.at(least.u, least.v);
  const LocalClearance found{machined.line, machined.number, least.number, least.u,
                             least.v,       least.clearance, place,        offset_};
  if (!verdict_.least || found.clearance < verdict_.least->clearance) verdict_.least = found;
  if (found.clearance >= -rounding_of_curvature) return;
  take_worse(verdict_.local, base::place_of(found.line), found,
             [](const LocalClearance& a, const LocalClearance& b) { return a.clearance < b.clearance; });
}

void ProgramCheck::hold(const machine::Tool* tool, Sweep& sweep) {
  if (tool == nullptr) {
    held_.reset();
    tool_.reset();
    return;
  }
  if (held_ == *tool) return;
  held_ = *tool;
  tool_ = tool_of(*tool);
  if (tool_) sweep.hold(*tool_);
}

void ProgramCheck::follow(gcode::Reader reader, const Workpiece& workpiece) {
  Sweep sweep(workpiece, verdict_.tolerance);
  Move move;
  for (std::int64_t count = 1; reader.next(move) && !is_interrupted(count); ++count) {
    if (move.kind == Move::Kind::event && base::changes_tool(move.event.kind))
      hold(tools_.find(static_cast<int>(move.event.value)), sweep);
    if (!is_motion_of(move)) continue;
    const MachinedMove& machined = reader.machined();
    if (machined.surface) hold(&machined.surface->tool, sweep);
    if (!tool_) {
      ++verdict_.moves_unknown;
      continue;
    }
    ++verdict_.moves;
    offset_ = offset_of(reader.frame());
    const Way way = way_of(move, poses_, offset_);
    if (move.feed.mode != gcode::Feed::Mode::rapid || machined.surface) is_clear_ = true;
    if (!is_clear_ && !begins_clear(way, workpiece)) continue;
    const double before = sweep.distance_at_end();
    const auto deepest = sweep.follow(way);
    if (!deepest || (is_withdrawal(way) && deepest->hit.distance >= before)) continue;
    judge(*deepest, move, machined, workpiece);
  }
}

/// Once the tool is clear of all surfaces, where a rapid begins.
bool ProgramCheck::begins_clear(const Way& way, const Workpiece& workpiece) {
  const Pose begin = way.at(0);
  is_clear_ = true;
  for (const Part& part : *tool_) is_clear_ = is_clear_ && workpiece.nearest(part, begin, 0).cell == Hit::no_cell;
  return is_clear_;
}

/// Triangles may be nearer than the surface, or farther, by the sag.
void ProgramCheck::judge(const Deepest& deepest, const Move& move, const MachinedMove& machined,
                         const Workpiece& workpiece) {
  if (deepest.hit.cell == Hit::no_cell) return;
  const double at_most = workpiece.sag() - deepest.hit.distance;
  if (at_most <= verdict_.tolerance && verdict_.worst && at_most <= verdict_.worst->depth) return;
  const SurfacePlace place = workpiece.refined(deepest.part, deepest.pose, deepest.hit);
  Gouge found{move.line, {},      machined.part, deepest.part.kind, -place.distance, surfaces_.number(place.surface),
              place.u,   place.v, place.place,   deepest.pose,      offset_};
  if (machined.surface) found.pass = machined.pass;
  const auto is_deeper = [](const Gouge& a, const Gouge& b) { return a.depth > b.depth; };
  if (!verdict_.worst || is_deeper(found, *verdict_.worst)) verdict_.worst = found;
  if (!(found.depth > verdict_.tolerance)) return;
  const base::Line block = base::place_of(move.line);
  take_worse(verdict_.gouges, block, found, is_deeper);
  take_worse(verdict_.gouges_of_passes, {block, found.of, found.pass.value_or(0)}, found, is_deeper);
}

}  // namespace

GougeVerdict check_gouging(const std::function<gcode::Reader()>& open, const machine::Machine& machine,
                           const machine::ToolTable& tools, const GougeOptions& options) {
  return ProgramCheck(machine, tools, options).check(open);
}

std::optional<Tool> tool_of(const machine::Tool& tool) {
  if (!tool.corner_radius || !(tool.diameter > 0)) return std::nullopt;
  ToolForm form;
  form.cutter = {tool.diameter / 2, *tool.corner_radius};
  form.length = tool.length;
  form.holder_radius = tool.holder_diameter / 2;
  form.holder_length = tool.holder_length;
  return Tool(form);
}

}  // namespace leadscrew::gouging
