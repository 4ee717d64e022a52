#include <fmt/format.h>

#include <leadscrew/sweep/build.hpp>
#include <leadscrew/sweep/summary.hpp>

namespace leadscrew::sweep {

namespace {

constexpr std::size_t most_refused = 5;  // listed

std::string word_in(const json::Json& row, std::string_view key) {
  const json::Json* const value = row.find(key);
  return value == nullptr || value->text() == nullptr ? std::string() : *value->text();
}

/// Rows of one program come one after the other.
void observe_refusal(const json::Json& row, Summary& summary) {
  const std::string program = word_in(row, "program"), code = word_in(row, "code");
  if (std::string own = program + " " + code; own != summary.last_refused) {
    summary.last_refused = std::move(own);
  } else {
    return;
  }
  if (summary.refused.size() >= most_refused) return void(++summary.more_refused);
  const json::Json* const line = row.find("line");
  const std::int64_t number = line == nullptr ? 0 : line->integer().value_or(0);
  summary.refused.push_back(fmt::format("{}{}: {} [{}]", program, number > 0 ? fmt::format(":{}", number) : "",
                                        word_in(row, "message"), code));
}

}  // namespace

void observe(const json::Json& row, Summary& summary) {
  const std::string text = word_in(row, "status");
  ++summary.rows;
  summary.kept += text == "kept" ? 1 : 0;
  summary.not_kept += text == "not-kept" ? 1 : 0;
  summary.rejected += text == "rejected" ? 1 : 0;
  summary.unreadable += text == "unreadable" ? 1 : 0;
  if (text == "rejected" || text == "unreadable") observe_refusal(row, summary);
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
  for (const std::string& each : summary.refused) text += fmt::format("refused     {}\n", each);
  if (summary.more_refused > 0) text += fmt::format("            and {} more: results.html\n", summary.more_refused);
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
