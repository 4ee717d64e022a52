// Where motion takes longer than its feed words ask: what holds it, the dearest first, and the blocks that lose most, each
// with a mark in the pictures of the path.

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

#include <algorithm>
#include <cmath>

namespace leadscrew::report {
namespace {

using markup::escaped;
using markup::fixed;
using markup::percent;
using markup::put;
using markup::readable;
using markup::readable_time;

constexpr double least_share = 1e-4;  // of the time, that a cause is shown for

/// "velocity X" as "velocity of X", "chord" as what it stands for.
std::string cause_text(const std::string& cause) {
  if (cause == "chord") return "chord error between two words";
  if (cause == "stop") return "standing still";
  const std::size_t space = cause.find(' ');
  return space == std::string::npos ? cause : cause.substr(0, space) + " of " + cause.substr(space + 1);
}

void put_causes(std::string& page, const Report& report) {
  const double greatest = report.losses.front().seconds;
  put(page,
      "<div class=\"scroll\"><table class=\"causes\"><thead><tr><th class=\"text\">Held by</th><th></th><th>Lost</th>"
      "<th>Of the time</th></tr></thead><tbody>\n");
  for (const Loss& loss : report.losses) {
    if (!(loss.seconds > least_share * report.time_s)) break;
    put(page, "<tr><td>", escaped(cause_text(loss.cause)),
        "</td><td class=\"share\"><i style=\"width:", fixed(100 * loss.seconds / greatest, 1), "%\"></i></td><td>",
        readable_time(loss.seconds), "</td><td>", fixed(100 * loss.seconds / report.time_s, 1), " %</td></tr>\n");
  }
  put(page, "</tbody></table></div>\n");
}

std::string feed_text(double feed) {
  if (std::isinf(feed)) return "rapid";
  return feed > 0 ? readable(feed * 60) : "";
}

void put_dearest(std::string& page, const PageContent& content) {
  const std::vector<LostBlock> blocks = content.recording.dearest_blocks();
  if (blocks.empty()) return;
  put(page,
      "<h3>The blocks that lose most</h3>\n<p class=\"note\">Feeds in mm/min. The numbers are those in the pictures of "
      "the path.</p>\n<div class=\"scroll\"><table class=\"dearest\"><thead><tr><th></th><th>Line</th><th "
      "class=\"text\">Block</th><th>Feed</th><th>Reached</th><th>Takes</th><th>Lost</th><th class=\"text\">Held by</th>"
      "</tr></thead><tbody>\n");
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const LostBlock& block = blocks[i];
    const std::string rank = std::to_string(i + 1), source = escaped(source_of(content.report, block.line), 120);
    put(page, "<tr id=\"lost", rank, "\" data-place=\"", rank, "\"><td><a class=\"rank\" href=\"#path\">", rank,
        "</a></td><td>", place_text(content.report, block.line), "</td><td class=\"source\" title=\"", source, "\">",
        source, "</td><td>", feed_text(block.feed_asked), "</td><td>", feed_text(block.feed_reached), "</td><td>",
        readable_time(block.duration), "</td><td>", readable_time(block.lost), "</td><td class=\"text\">",
        escaped(cause_text(block.cause)), "</td></tr>\n");
  }
  put(page, "</tbody></table></div>\n");
}

}  // namespace

void put_loss_section(std::string& page, const PageContent& content) {
  const Report& report = content.report;
  if (report.losses.empty() || !(report.time_s > 0)) return;
  double all = 0;
  for (const Loss& loss : report.losses) all += loss.seconds;
  put(page, "<section id=\"losses\"><h2>Where time is lost</h2>\n<p class=\"note\">Of ", readable_time(report.time_s),
      ", ", readable_time(std::max(all, 0.0)), " (", percent(std::max(all, 0.0) / report.time_s),
      ") are more than feed words ask; rapids are counted from the velocity of the axis nearest to its limit. Each "
      "servo period is laid to what its words are nearest to.</p>\n");
  if (report.losses.front().seconds > least_share * report.time_s) put_causes(page, report);
  put_dearest(page, content);
  put(page, "</section>\n");
}

}  // namespace leadscrew::report
