#include <leadscrew/cli/diagnostic_text.hpp>
#include <leadscrew/cli/json_form.hpp>
#include <nlohmann/json.hpp>

namespace leadscrew::cli {

namespace {

Json object_of(const base::Diagnostic& diagnostic) {
  return {{"file", diagnostic.place.file},
          {"line", diagnostic.place.line},
          {"column", diagnostic.place.column},
          {"code", diagnostic.code},
          {"severity", base::name(diagnostic.severity)},
          {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

Json list_of(const std::vector<base::Diagnostic>& diagnostics) {
  Json list = Json::array();
  for (const base::Diagnostic& diagnostic : diagnostics) list.push_back(object_of(diagnostic));
  return list;
}

Json axis_object(base::Axis axis, double velocity, double acceleration, double jerk) {
  return {{"name", std::string(1, base::letter(axis))},
          {"velocity_ratio", velocity},
          {"acceleration_ratio", acceleration},
          {"jerk_ratio", jerk}};
}

Json axes_of(const referee::Verdict& verdict) {
  Json list = Json::array();
  for (const referee::AxisVerdict& axis : verdict.axes) {
    list.push_back(axis_object(axis.axis, axis.velocity_ratio, axis.acceleration_ratio, axis.jerk_ratio));
  }
  return list;
}

Json plan_of(const constraints::LimitRatios& plan, const machine::Machine& machine) {
  Json list = Json::array();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::Derivatives ratios = plan.of_axis(axis);
    list.push_back(axis_object(axis, ratios.velocity, ratios.acceleration, ratios.jerk));
  }
  for (const auto& [name, ratio] : plan.of_path()) {
    if (ratio > 0) list.push_back({{"name", name}, {"ratio", ratio}});
  }
  return list;
}

Json cpu_of(const Effort& effort) {
  return {{"read_s", effort.read},
          {"plan_s", effort.plan},
          {"words_s", effort.words},
          {"cycle_ns",
           {{"p50", effort.cycles.percentile(0.5)},
            {"p99", effort.cycles.percentile(0.99)},
            {"max", effort.cycles.longest()}}}};
}

Json violations_of(const referee::Verdict& verdict) {
  Json list = Json::array();
  for (const referee::Violation& violation : verdict.violations) {
    list.push_back({{"t", violation.t},
                    {"line", base::number(violation.line)},
                    {"what", violation.what},
                    {"value", violation.value},
                    {"limit", violation.limit}});
  }
  return list;
}

Json json_of_steps(const StepFigures& steps) {
  Json json = {
      {"method", steps.method}, {"clock_hz", steps.clock_hz}, {"steps", steps.steps}, {"time_s", steps.time_s}};
  json["error_blu"] = steps.error_blu ? Json(*steps.error_blu) : Json(nullptr);
  json["compensation"] = Json::array();
  for (const Correction& correction : steps.corrections) {
    const char* key = base::is_rotary(correction.axis) ? "greatest_correction_deg" : "greatest_correction_mm";
    json["compensation"].push_back(
        {{"name", std::string(1, base::letter(correction.axis))}, {key, correction.greatest}});
  }
  return json;
}

}  // namespace

Json json_of_rejected(std::string_view schema, const std::string& program, const std::string& machine,
                      const DiagnosticLog& log) {
  return {{"schema", schema},
          {"program", program},
          {"machine", machine.empty() ? Json(nullptr) : Json(machine)},
          {"diagnostics", list_of(log.all())}};
}

Json json_of_diagnostics(const DiagnosticLog& log) {
  return list_of(log.all());
}

Json json_of_run(const std::string& program, const Job& job, const RunFigures& figures, const DiagnosticLog& log) {
  const pipeline::Summary& summary = figures.summary;
  const referee::Verdict& verdict = figures.verdict;
  Json json = {{"schema", run_schema},
               {"program", program},
               {"machine", job.machine.name},
               {"period_s", job.machine.period.seconds()},
               {"words", summary.words},
               {"blocks", summary.blocks},
               {"moves", summary.moves},
               {"length_mm", summary.length_mm},
               {"time_s", summary.time_s},
               {"dwell_s", summary.dwell_s},
               {"bound_s", summary.bound_s},
               {"deviation_mm", verdict.deviation_mm},
               {"tolerance_mm", summary.tolerance_mm},
               {"feed",
                {{"programmed_max_mm_s", summary.feed_programmed_max},
                 {"max_ratio", verdict.feed_max_ratio},
                 {"ripple", summary.ripple}}},
               {"axes", axes_of(verdict)},
               {"plan", plan_of(summary.plan, job.machine)},
               {"violation_count", verdict.violation_count},
               {"cpu", cpu_of(figures.effort)},
               {"diagnostics", list_of(log.all())}};
  if (figures.steps) json["pulses"] = json_of_steps(*figures.steps);
  return json;
}

Json json_of_check(const std::string& program, const Job& job, const Reading& reading, const DiagnosticLog& log) {
  return {{"schema", check_schema},      {"program", program},
          {"machine", job.machine.name}, {"blocks", reading.blocks},
          {"moves", reading.moves},      {"errors", log.errors()},
          {"warnings", log.warnings()},  {"diagnostics", list_of(log.all())}};
}

Json json_of_verify(const std::string& program, const Job& job, const VerifyFigures& figures,
                    const DiagnosticLog& log) {
  const referee::Verdict& verdict = figures.verdict;
  return {{"schema", verify_schema},
          {"trace", figures.trace},
          {"program", program},
          {"machine", job.machine.name},
          {"period_s", figures.period.seconds()},
          {"time_s", verdict.time_s},
          {"deviation_mm", verdict.deviation_mm},
          {"tolerance_mm", verdict.tolerance_mm},
          {"start_error_mm", verdict.start_error_mm},
          {"end_error_mm", verdict.end_error_mm},
          {"axes", axes_of(verdict)},
          {"feed",
           {{"programmed_max_mm_s", verdict.feed_programmed_max},
            {"max_ratio", verdict.feed_max_ratio},
            {"ripple", nullptr}}},
          {"violations", violations_of(verdict)},
          {"violation_count", verdict.violation_count},
          {"diagnostics", list_of(log.all())}};
}

std::string json_text(std::string_view schema, std::vector<Json> objects) {
  Json object =
      objects.size() == 1 ? std::move(objects.front()) : Json{{"schema", schema}, {"programs", std::move(objects)}};
  // Names of files need not be UTF-8.
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace leadscrew::cli
