// Spindle, coolant, tools, outputs and pauses: when and where the program asked for them.

#include <leadscrew/base/number_text.hpp>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

namespace leadscrew::report {

using markup::put;
using markup::readable;
using markup::readable_time;

void put_event_section(std::string& page, const PageContent& content) {
  const auto events = content.recording.events();
  if (events.empty()) return;
  put(page,
      "<section id=\"events\"><h2>Events</h2>\n<p class=\"note\">Each with the first word that motion reaches at its "
      "place, or behind it.</p>\n<div class=\"scroll\"><table><thead><tr><th>Line</th><th class=\"text\">Code</th>"
      "<th>Output</th><th>Value</th><th>Q</th><th>At</th><th>Along the path</th><th "
      "class=\"text\">Motion</th></tr></thead>"
      "<tbody>\n");
  for (const base::PassedEvent& event : events) {
    put(page, "<tr><td>", place_text(content.report, event.line), "</td><td class=\"text\">", base::code_of(event),
        "</td><td>", base::has_output(event.kind) ? std::to_string(event.output) : "", "</td><td>",
        base::has_value(event.kind) ? base::text(event.value) : "", "</td><td>",
        base::has_q(event.kind) ? base::text(event.q) : "", "</td><td>",
        readable_time(base::seconds(event.tick, content.period)), "</td><td>", readable(event.path_length),
        " mm</td><td class=\"text\">", event.waits ? "rests" : "goes on", "</td></tr>\n");
  }
  put(page, "</tbody></table></div>\n");
  const std::int64_t left = content.recording.event_count() - static_cast<std::int64_t>(events.size());
  if (left > 0) put(page, "<p class=\"note\">And ", std::to_string(left), " more.</p>\n");
  put(page, "</section>\n");
}

}  // namespace leadscrew::report
