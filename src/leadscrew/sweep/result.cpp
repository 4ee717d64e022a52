#include <fmt/format.h>

#include <filesystem>
#include <leadscrew/sweep/result.hpp>

namespace leadscrew::sweep {

std::vector<json::Json::Member> judged_figures(const JudgedRun& run) {
  const auto ratios = run.worst_ratios();
  return {{"moves", run.summary.moves},
          {"words", run.summary.words},
          {"words_hash", fmt::format("{:016x}", run.words_hash)},
          {"velocity_ratio", ratios[0]},
          {"acceleration_ratio", ratios[1]},
          {"jerk_ratio", ratios[2]},
          {"plan_ratio", run.summary.plan.greatest()},
          {"feed_ratio", run.verdict.feed_max_ratio},
          {"deviation_mm", run.verdict.deviation_mm},
          {"allowed_mm", run.verdict.tolerance_mm},
          {"end_error_mm", run.verdict.end_error_mm}};
}

json::Json json_of(const JudgedRun& run) {
  json::Json result = json::Json::object({{"status", run.kept() ? "kept" : "not-kept"},
                                          {"time_s", run.summary.time_s},
                                          {"dwell_s", run.summary.dwell_s},
                                          {"bound_s", run.summary.bound_s},
                                          {"length_mm", run.summary.length_mm},
                                          {"blocks", run.summary.blocks}});
  for (auto& [name, value] : judged_figures(run)) result[name] = std::move(value);
  result["violations"] = run.verdict.violation_count;
  json::Json lost = json::Json::object();
  for (const auto& [cause, seconds] : pipeline::ranked(run.lost)) lost[pipeline::name(cause)] = seconds;
  result["lost"] = std::move(lost);
  if (run.verdict.objects()) {
    const referee::Violation& first = run.verdict.violations.front();
    result["first_violation"] = json::Json::object({{"what", first.what},
                                                    {"t", first.t},
                                                    {"line", base::number(first.line)},
                                                    {"value", first.value},
                                                    {"limit", first.limit}});
  }
  return result;
}

json::Json json_of(const base::Diagnostic& first_error, std::int64_t errors) {
  const bool is_of_file = first_error.code.starts_with("io-") || first_error.code == "input-too-large";
  return json::Json::object({{"status", is_of_file ? "unreadable" : "rejected"},
                             {"code", first_error.code},
                             {"file", std::filesystem::path(first_error.place.file).filename().string()},
                             {"line", first_error.place.line},
                             {"column", first_error.place.column},
                             {"message", first_error.message},
                             {"errors", errors}});
}

}  // namespace leadscrew::sweep
