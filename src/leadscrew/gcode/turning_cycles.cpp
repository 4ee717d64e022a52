#include <leadscrew/gcode/turning_cycles.hpp>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t along_x = base::index(base::Axis::X), along_z = base::index(base::Axis::Z);

}  // namespace

// The first cut says where it ends along X and Z, or ends there where it begins.
bool TurningCycles::plan(const Block& block) {
  const base::AxisVector target = motion_.target_of(block);
  const bool is_first = block.has(Group::motion) || code_ != modal_.to_do;
  if (is_first) {
    code_ = modal_.to_do;
    taper_ = 0;
  }
  if (is_first || block.has('X')) x_ = target[along_x];
  if (is_first || block.has('Z')) z_ = target[along_z];
  if (block.has('R')) taper_ = block['R'];
  const std::string code = name(code_);
  if (!frame_.is_offset_only()) {
    return error("unsupported-rotation", motion_column(block), code + " in turned, scaled or mirrored coordinates",
                 "the turning cycles take offsets only");
  }
  if (modal_.feed_mode == FeedMode::inverse_time) {
    return error("bad-feed-mode", motion_column(block), code + " in G93", "give G98 or G99");
  }
  for (const base::Axis axis : base::all_axes) {
    if (axis == base::Axis::X || axis == base::Axis::Z || !block.has(base::letter(axis))) continue;
    return error("unused-word", block.column_of(base::letter(axis)), code + " does not move axis " + base::letter(axis),
                 "move it in a block before");
  }
  return true;
}

void TurningCycles::cut(const Block& block) {
  if (!plan(block)) return;
  const base::AxisVector start = frame_.position;
  const bool faces = code_ == Code::G94_face;
  const std::size_t in = faces ? along_z : along_x, along = faces ? along_x : along_z;
  base::AxisVector end = start, begin = start, out = start;
  end[along_x] = x_;
  end[along_z] = z_;
  begin[in] = end[in] + taper_ * frame_.length_unit;
  out[along] = end[along];
  Feed feed;
  const bool threads = code_ == Code::G92_thread;
  if (!threads) motion_.feed_of(block, true, block.has('F'), feed);
  motion_.line_to(block, begin, Feed{});
  if (threads) {
    threading_.cut_to(block, end);
  } else {
    motion_.line_to(block, end, feed);
  }
  motion_.line_to(block, out, threads ? Feed{} : feed);
  motion_.line_to(block, start, Feed{});
}

}  // namespace leadscrew::gcode
