#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/study.hpp>
#include <leadscrew/console/diagnostic_log.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/realtime/share_out.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <leadscrew/results/studies.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::cli {

namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::optional<int> table_width() {
  winsize size = {};
  if (::isatty(STDOUT_FILENO) != 1) return std::nullopt;
  return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

base::Result<void> draw(const study::Study& study, const std::string& path) {
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  report::ChartSheet sheet = study.picture();
  sheet.title = "leadscrew study " + std::string(study.name) + ": " + sheet.title;
  if (auto written = report::write_charts(sheet, file->sink()); !written) return written;
  return files::publish_together({&*file});
}

base::Result<void> write_words(const std::vector<study::StudyFile>& texts, const std::string& folder) {
  for (const study::StudyFile& each : texts) {
    auto file = files::OutputFile::create(folder + "/" + each.name, files::OutputFile::Access::sequential);
    if (!file) return base::failure(file.error());
    if (auto written = file->write(each.text); !written) return written;
    if (auto published = files::publish_together({&*file}); !published) return published;
  }
  return {};
}

Status status_of(const study::Rows& rows) {
  const bool failed = std::any_of(rows.begin(), rows.end(), [](const study::Row& row) {
    return row.verdict == study::Verdict::exceeded || row.verdict == study::Verdict::not_run;
  });
  return failed ? Status::not_kept : Status::done;
}

}  // namespace

Status study(const Arguments& arguments, Console& console) {
  const Style& style = console.output_style();
  if (arguments.study.name == "list")
    return write_output(console, arguments.json ? results::study_list_json() : results::study_list(style));
  const auto known = study::studies();
  const auto chosen =
      std::find_if(known.begin(), known.end(), [&](const auto& s) { return s.name == arguments.study.name; });
  if (chosen == known.end()) return Status::usage;
  files::end_when_interrupted();
  const study::Host host = {realtime::SystemClocks::processor_seconds, wall_seconds, realtime::share_out};
  const study::Rows rows = chosen->rows(host);
  if (arguments.study.picture) {
    if (auto drawn = draw(*chosen, *arguments.study.picture); !drawn) {
      DiagnosticLog log(console);
      log.add(drawn.error());
      return log.status();
    }
  }
  if (arguments.study.words) {
    if (auto written = write_words(chosen->words(host), *arguments.study.words); !written) {
      DiagnosticLog log(console);
      log.add(written.error());
      return log.status();
    }
  }
  const std::string text =
      arguments.json ? results::study_json(chosen->name, rows) : results::study_table(rows, table_width(), style);
  return worse(status_of(rows), write_output(console, text));
}

}  // namespace leadscrew::cli
