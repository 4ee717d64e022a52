#include <leadscrew/report/report.hpp>

#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>

namespace leadscrew::report {

using markup::escaped;
using markup::put;

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
  put_followed_section(page, content);
  put_time_section(page, content);
  put_limit_section(page, content);
  put_block_section(page, content);
  put_diagnostics(page, content);
  put_origin(page, content);
  put(page, "</main>\n<script>", page_script(), "</script>\n</body>\n</html>\n");
  return sink(page);
}

}  // namespace leadscrew::report
