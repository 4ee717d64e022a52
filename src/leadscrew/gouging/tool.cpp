#include <algorithm>
#include <leadscrew/gouging/tool.hpp>

namespace leadscrew::gouging {

Tool::Tool(const ToolForm& form) {
  const double endless = std::numeric_limits<double>::infinity();
  const double R = form.cutter.radius, r = std::min(form.cutter.corner_radius, R);
  const double length = form.length > 0 ? form.length : endless;
  const bool has_shank = form.edge_length > 0 && form.edge_length < length && form.shank_radius > 0;
  parts_[count_++] = {Part::Kind::cutter, R, r, 0, has_shank ? form.edge_length : length};
  if (has_shank) {
    // One that is no wider than the cutter begins inside it, so that it has no lower edge of its own.
    const double bottom = form.shank_radius > R ? form.edge_length : std::min(r, form.edge_length / 2);
    parts_[count_++] = {Part::Kind::shank, form.shank_radius, 0, bottom, length};
  }
  if (form.length > 0 && form.holder_radius > 0) {
    const double top = form.holder_length > 0 ? length + form.holder_length : endless;
    parts_[count_++] = {Part::Kind::holder, form.holder_radius, 0, length, top};
  }
}

}  // namespace leadscrew::gouging
