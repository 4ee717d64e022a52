// Where the tool is inside a surface that the program machines: of a program that was allowed to gouge, block by block, each with a
// mark in the pictures of the path.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

#include <algorithm>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::fixed;
using markup::put;
using markup::readable;
using markup::readable_distance;

void put_gouge(std::string& page, const Report& report, const Gouge& gouge, const std::string& rank) {
  const std::string source = escaped(source_of(report, gouge.line), 120);
  put(page, "<tr id=\"gouge", rank, "\" data-place=\"gouge", rank, "\"><td><a class=\"rank\" href=\"#path\">", rank,
      "</a></td><td>", place_text(report, gouge.line), "</td><td class=\"source\" title=\"", source, "\">", source,
      "</td><td class=\"over-limit\">", gouge.depth_mm ? fixed(*gouge.depth_mm, 4) : std::string("beside contact"),
      "</td><td class=\"text\">", escaped(gouge.motion), "</td><td>", std::to_string(gouge.surface), "</td><td>",
      readable(gouge.u, 6), "</td><td>", readable(gouge.v, 6), "</td><td class=\"text\">");
  if (gouge.depth_mm) {
    put(page, escaped(gouge.part), gouge.count > 1 ? ", the deepest of " + std::to_string(gouge.count) : "");
  } else {
    put(page, "the surface bends by ", readable(gouge.bends_by, 3), " / mm more");
  }
  put(page, "</td></tr>\n");
}

}  // namespace

void put_gouging_section(std::string& page, const PageContent& content) {
  const Report& report = content.report;
  if (!report.gouging) return;
  const Gouging& found = *report.gouging;
  put(page, "<section id=\"gouging\"><h2>Where the tool gouges</h2>\n<p class=\"note\">");
  if (!found.is_known) {
    put(page, "Not looked at: the surfaces are more, or larger, than are looked at for gouging.</p></section>\n");
    return;
  }
  if (found.blocks.empty()) {
    put(page, "Nowhere: no tool is more than ", readable_distance(found.tolerance_mm),
        " inside a surface that the program machines.</p></section>\n");
    return;
  }
  put(page, "Block by block, the deepest place of its passes and that of its links, where tools are more than ",
      readable_distance(found.tolerance_mm),
      " inside a surface that the program machines; depths in mm. The numbers are those of the diamonds in the "
      "pictures "
      "of the path, where each small one is the deepest place of one of them.</p>\n<div class=\"scroll\"><table "
      "class=\"dearest\"><thead><tr><th></th><th>Line</th><th class=\"text\">Block</th><th>Depth</th><th "
      "class=\"text\">On</th><th>Surface</th><th>u</th><th>v</th><th class=\"text\">By</th></tr></thead><tbody>\n");
  const std::size_t shown = std::min(found.blocks.size(), most_gouges);
  for (std::size_t k = 0; k < shown; ++k) put_gouge(page, report, found.blocks[k], std::to_string(k + 1));
  put(page, "</tbody></table></div>\n");
  if (shown < found.blocks.size())
    put(page, "<p class=\"note\">And ", std::to_string(found.blocks.size() - shown), " more.</p>\n");
  put(page, "</section>\n");
}

}  // namespace leadscrew::report
