#include <fmt/format.h>

#include <leadscrew/sweep/build.hpp>
#include <leadscrew/sweep/summary.hpp>

namespace leadscrew::sweep {

void observe(const json::Json& row, Summary& summary) {
  const json::Json* const status = row.find("status");
  const std::string text = status == nullptr || status->text() == nullptr ? "" : *status->text();
  ++summary.rows;
  summary.kept += text == "kept" ? 1 : 0;
  summary.not_kept += text == "not-kept" ? 1 : 0;
  summary.rejected += text == "rejected" ? 1 : 0;
  summary.unreadable += text == "unreadable" ? 1 : 0;
  const json::Json* const time = row.find("time_s");
  if (time != nullptr) summary.time_s += time->number().value_or(0);
}

json::Json json_of(const Summary& summary) {
  json::Json all = json::Json::object({{"schema", sweep_schema},
                                       {"tasks", summary.tasks},
                                       {"rows", summary.rows},
                                       {"done_before", summary.done_before},
                                       {"done", summary.done},
                                       {"failed", summary.failed},
                                       {"kept", summary.kept},
                                       {"not_kept", summary.not_kept},
                                       {"rejected", summary.rejected},
                                       {"unreadable", summary.unreadable},
                                       {"time_s", summary.time_s},
                                       {"tasks_processor_s", summary.tasks_processor_s},
                                       {"processor_s", summary.processor_s},
                                       {"wall_s", summary.wall_s},
                                       {"files", summary.files}});
  for (const auto& [build, rows] : summary.rows_of_others)
    all["other_builds"].push_back(json::Json::object({{"build", build}, {"rows", rows}}));
  if (summary.sensitivities.empty()) return all;
  for (const Sensitivity& each : summary.sensitivities) all["sensitivities"].push_back(json_of(each));
  return all;
}

std::string told_of_others(const Summary& summary) {
  if (summary.rows_of_others.empty()) return {};
  std::string all;
  for (const auto& [build, rows] : summary.rows_of_others)
    all += fmt::format("{}{} {} by {}", all.empty() ? "" : ", ", rows, rows == 1 ? "row" : "rows",
                       build.empty() ? "a build that is not named" : build);
  return fmt::format("{}; this is {}. To have them done again, remove shards/ in the folder", all, build_name());
}

std::string text_of(const Summary& summary, const results::Style&) {
  std::string text = fmt::format("tasks       {}, {} of them with a result\n", summary.tasks, summary.rows);
  text += fmt::format("this start  {} done, {} were done before", summary.done, summary.done_before);
  text += summary.failed > 0 ? fmt::format(", {} failed and are left to do\n", summary.failed) : "\n";
  text += fmt::format("results     {} kept, {} not kept, {} rejected, {} unreadable\n", summary.kept, summary.not_kept,
                      summary.rejected, summary.unreadable);
  if (!summary.rows_of_others.empty()) text += fmt::format("builds      {}\n", told_of_others(summary));
  text += fmt::format("motion      {:.1f} s in all\n", summary.time_s);
  text += fmt::format("processor   {:.1f} s this start, in {:.1f} s; all tasks together {:.1f} s\n",
                      summary.processor_s, summary.wall_s, summary.tasks_processor_s);
  if (!summary.sensitivities.empty())
    text += "limit                 time of all  with 5 % less  with 5 % more  per cent of time for 1 % more\n";
  for (const Sensitivity& each : summary.sensitivities)
    text += fmt::format("{:<20}  {:9.3f} s  {:11.3f} s  {:11.3f} s  {:+.3f}  {}\n", each.limit, each.time_s,
                        each.time_less_s, each.time_more_s, each.elasticity(), each.machine);
  for (const std::string& file : summary.files) text += fmt::format("written     {}\n", file);
  return text;
}

}  // namespace leadscrew::sweep
