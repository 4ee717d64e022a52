#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/gouging.hpp>
#include <leadscrew/results/program_json.hpp>

namespace leadscrew::results {

namespace {

Json object_of(const base::Diagnostic& diagnostic) {
  return Json::object({{"file", diagnostic.place.file},
                       {"line", diagnostic.place.line},
                       {"column", diagnostic.place.column},
                       {"code", diagnostic.code},
                       {"severity", base::name(diagnostic.severity)},
                       {"message", diagnostic.message},
                       {"hint", diagnostic.hint}});
}

Json list_of(const std::vector<base::Diagnostic>& diagnostics) {
  Json list = Json::list();
  for (const base::Diagnostic& diagnostic : diagnostics) list.push_back(object_of(diagnostic));
  return list;
}

Json list_of(const std::vector<gcode::Remark>& messages) {
  Json list = Json::list();
  for (const gcode::Remark& message : messages) {
    list.push_back(Json::object({{"file", message.place.file},
                                 {"line", message.place.line},
                                 {"column", message.place.column},
                                 {"kind", message.kind == gcode::Remark::Kind::print ? "print" : "message"},
                                 {"text", message.text}}));
  }
  return list;
}

Json axis_object(base::Axis axis, double velocity, double acceleration, double jerk) {
  return Json::object({{"name", std::string(1, base::letter(axis))},
                       {"velocity_ratio", velocity},
                       {"acceleration_ratio", acceleration},
                       {"jerk_ratio", jerk}});
}

Json list_of(const std::vector<Extent>& extents) {
  Json list = Json::list();
  for (const Extent& extent : extents) {
    list.push_back(Json::object(
        {{"name", std::string(1, base::letter(extent.axis))}, {"least", extent.least}, {"greatest", extent.greatest}}));
  }
  return list;
}

Json losses_of(const pipeline::LostByCause& lost) {
  Json list = Json::list();
  for (const auto& [cause, seconds] : pipeline::ranked(lost))
    list.push_back(Json::object({{"cause", pipeline::name(cause)}, {"s", seconds}}));
  return list;
}

Json axes_of(const referee::Verdict& verdict) {
  Json list = Json::list();
  for (const referee::AxisVerdict& axis : verdict.axes) {
    list.push_back(axis_object(axis.axis, axis.velocity_ratio, axis.acceleration_ratio, axis.jerk_ratio));
  }
  return list;
}

Json feed_of(double programmed_max, const referee::Verdict& verdict) {
  return Json::object({{"programmed_max_mm_s", programmed_max},
                       {"max_ratio", verdict.feed_max_ratio},
                       {"ripple", verdict.feed_ripple}});
}

Json plan_of(const constraints::LimitRatios& plan, const machine::Machine& machine) {
  Json list = Json::list();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::Derivatives ratios = plan.of_axis(axis);
    list.push_back(axis_object(axis, ratios.velocity, ratios.acceleration, ratios.jerk));
  }
  for (const auto& [name, ratio] : plan.of_path()) {
    if (ratio > 0) list.push_back(Json::object({{"name", name}, {"ratio", ratio}}));
  }
  return list;
}

Json cpu_of(const ComputingTime& effort) {
  return Json::object({{"read_s", effort.read},
                       {"plan_s", effort.plan},
                       {"words_s", effort.words},
                       {"cycle_ns", Json::object({{"p50", effort.cycles.percentile(0.5)},
                                                  {"p99", effort.cycles.percentile(0.99)},
                                                  {"max", effort.cycles.longest()}})}});
}

Json violations_of(const referee::Verdict& verdict) {
  Json list = Json::list();
  for (const referee::Violation& violation : verdict.violations) {
    Json objection = Json::object({{"t", violation.t},
                                   {"line", base::number(violation.line)},
                                   {"what", violation.what},
                                   {"value", violation.value},
                                   {"limit", violation.limit}});
    put_file_and_visit(objection, violation.line);
    list.push_back(std::move(objection));
  }
  return list;
}

Json json_of_steps(const StepFigures& steps) {
  Json json = Json::object(
      {{"method", steps.method}, {"clock_hz", steps.clock_hz}, {"steps", steps.steps}, {"time_s", steps.time_s}});
  json["error_blu"] = steps.error_blu;
  json["compensation"] = Json::list();
  for (const Correction& correction : steps.corrections) {
    const char* key = base::is_rotary(correction.axis) ? "greatest_correction_deg" : "greatest_correction_mm";
    json["compensation"].push_back(
        Json::object({{"name", std::string(1, base::letter(correction.axis))}, {key, correction.greatest}}));
  }
  return json;
}

}  // namespace

Json json_of_rejected(std::string_view schema, const std::string& program, const std::string& machine,
                      const Diagnostics& diagnostics) {
  return Json::object({{"schema", schema},
                       {"program", program},
                       {"machine", machine.empty() ? Json(nullptr) : Json(machine)},
                       {"diagnostics", list_of(diagnostics)}});
}

void put_file_and_visit(Json& json, base::Line line) {
  if (base::file(line) != 0) json["file"] = base::file(line);
  if (base::visit(line) != 0) json["visit"] = base::visit(line);
}

Json json_of_diagnostics(const Diagnostics& diagnostics) {
  return list_of(diagnostics);
}

void add_tip(Json& json, const referee::Verdict& verdict) {
  if (!verdict.tip_deviation_mm) return;
  json["tip"] = Json::object({{"deviation_mm", *verdict.tip_deviation_mm},
                              {"orientation_deviation_deg", *verdict.orientation_deviation_deg},
                              {"orientation_tolerance_deg", verdict.orientation_tolerance_deg}});
}

void add_threads(Json& json, const interpolator::ThreadFigures& threads) {
  Json figures = Json::object({{"lines", threads.lines}, {"run_in_mm", threads.run_in}});
  if (threads.run_in > 0) figures["line"] = base::number(threads.run_in_line);
  figures["out_of_step"] = threads.out_of_step;
  if (threads.out_of_step > 0) figures["out_of_step_line"] = base::number(threads.out_of_step_line);
  json["threads"] = figures;
}

Json json_of_motion(std::string_view schema, const std::string& program, const machine::Machine& machine,
                    const pipeline::Summary& summary, std::initializer_list<Json::Member> more) {
  Json json = Json::object({{"schema", schema},
                            {"program", program},
                            {"machine", machine.name},
                            {"period_s", machine.period.seconds()},
                            {"words", summary.words},
                            {"blocks", summary.blocks},
                            {"moves", summary.moves},
                            {"length_mm", summary.length_mm},
                            {"time_s", summary.time_s},
                            {"dwell_s", summary.dwell_s}});
  for (const auto& [key, value] : more) json[key] = value;
  return json;
}

Json json_of_run(const std::string& program, const machine::Machine& machine, const RunFigures& figures,
                 const Diagnostics& diagnostics) {
  const pipeline::Summary& summary = figures.summary;
  const referee::Verdict& verdict = figures.verdict;
  Json json = json_of_motion(run_schema, program, machine, summary,
                             {{"bound_s", summary.bound_s},
                              {"deviation_mm", verdict.deviation_mm},
                              {"tolerance_mm", summary.tolerance_mm},
                              {"feed", feed_of(summary.feed_programmed_max, verdict)},
                              {"axes", axes_of(verdict)},
                              {"plan", plan_of(summary.plan, machine)},
                              {"extents", list_of(figures.extents)},
                              {"losses", losses_of(figures.lost)},
                              {"violation_count", verdict.violation_count},
                              {"cpu", cpu_of(figures.effort)},
                              {"diagnostics", list_of(diagnostics)}});
  add_tip(json, verdict);
  if (machine.threads_follow()) add_threads(json, summary.threads);
  if (figures.steps) json["pulses"] = json_of_steps(*figures.steps);
  return json;
}

Json json_of_check(const std::string& program, const machine::Machine& machine, const CheckFigures& reading,
                   const Diagnostics& diagnostics) {
  Json json = Json::object({{"schema", check_schema},
                            {"program", program},
                            {"machine", machine.name},
                            {"blocks", reading.blocks},
                            {"moves", reading.moves},
                            {"extents", list_of(reading.extents)},
                            {"bound_s", reading.bound_s},
                            {"errors", count(diagnostics, base::Severity::error)},
                            {"warnings", count(diagnostics, base::Severity::warning)},
                            {"message_count", reading.message_count},
                            {"messages", list_of(reading.messages)},
                            {"diagnostics", list_of(diagnostics)}});
  if (reading.gouging) json["gouging"] = json_of_gouging(*reading.gouging);
  return json;
}

Json json_of_verify(const std::string& program, const machine::Machine& machine, const VerifyFigures& figures,
                    const Diagnostics& diagnostics) {
  const referee::Verdict& verdict = figures.verdict;
  Json json = Json::object({{"schema", verify_schema},
                            {"trace", figures.trace},
                            {"program", program},
                            {"machine", machine.name},
                            {"period_s", figures.period.seconds()},
                            {"time_s", verdict.time_s},
                            {"deviation_mm", verdict.deviation_mm},
                            {"tolerance_mm", verdict.tolerance_mm},
                            {"start_error_mm", verdict.start_error_mm},
                            {"end_error_mm", verdict.end_error_mm},
                            {"axes", axes_of(verdict)},
                            {"feed", feed_of(verdict.feed_programmed_max, verdict)},
                            {"violations", violations_of(verdict)},
                            {"violation_count", verdict.violation_count},
                            {"diagnostics", list_of(diagnostics)}});
  add_tip(json, verdict);
  return json;
}

std::string json_text(std::string_view schema, std::vector<Json> objects) {
  const Json object = objects.size() == 1 ? std::move(objects.front())
                                          : Json::object({{"schema", schema}, {"programs", std::move(objects)}});
  return object.written() + "\n";
}

}  // namespace leadscrew::results
