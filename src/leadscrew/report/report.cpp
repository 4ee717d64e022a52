#include <leadscrew/report/report.hpp>

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>
#include <leadscrew/report/path_view.hpp>

namespace leadscrew::report {

using markup::escaped;
using markup::put;

namespace {

std::string speed_rules(Background background) {
  std::string out = stroke_rules(background);
  for (std::size_t i = 0; i < speed_levels; ++i) {
    put(out, "i.v", std::to_string(i), "{background:", speed_color(i, background), "}");
  }
  return out;
}

/// The style with the colours of speeds in the places that its comments mark.
std::string page_style() {
  std::string style(page_css);
  for (const auto& [mark, background] :
       {std::pair<std::string_view, Background>{"\n/*speeds:light*/\n", Background::light},
        {"\n/*speeds:dark*/\n", Background::dark}}) {
    style.replace(style.find(mark), mark.size(), speed_rules(background));
  }
  return style;
}

}  // namespace

base::Result<void> write_report(const Report& report, const Recording& recording, const machine::Machine& machine,
                                base::Period period, const base::ByteSink& sink, FollowedRecording* followed) {
  const PageContent content{report, recording, machine, period, followed};
  std::string page;
  put(page,
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>",
      escaped(report.title), " – motion report</title>\n<style>", page_style(), "</style>\n</head>\n<body>\n<main>\n");
  put_heading(page, content);
  put_path_section(page, content);
  put_gouging_section(page, content);
  put_loss_section(page, content);
  put_followed_section(page, content);
  put_violation_section(page, content);
  put_time_section(page, content);
  put_limit_section(page, content);
  put_block_section(page, content);
  put_event_section(page, content);
  put_diagnostics(page, content);
  put_origin(page, content);
  put(page, "</main>\n<script>", page_js, "</script>\n</body>\n</html>\n");
  return sink(page);
}

}  // namespace leadscrew::report
