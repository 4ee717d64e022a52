#include <leadscrew/files/beside_command.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/results/page_report.hpp>
#include <utility>

namespace leadscrew::results {

namespace {

/// Of a page that knows recordings as this command writes them: one of another version may lie where this one's should.
std::string place() {
  return "<script type=\"application/json\" id=\"recording\" data-schema=\"" + std::string(recording_schema) + "\">";
}

constexpr std::int64_t largest_page = 64 << 20;  // bytes

/// As JSON that cannot end the element it stands in: a < in a text is written by its number.
std::string embedded(const json::Json& json) {
  const std::string written = json.written_in_line();
  std::string text;
  text.reserve(written.size());
  for (const char c : written) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

}  // namespace

json::Json json_of_events(std::span<const base::PassedEvent> events, base::Period period) {
  using json::Json;
  Json list = Json::list();
  for (const base::PassedEvent& event : events) {
    Json json = Json::object({{"t", base::seconds(event.tick, period)},
                              {"line", base::file(event.line) == 0 ? base::number(event.line) : 0},
                              {"code", base::code_of(event)},
                              {"output", nullptr},
                              {"value", nullptr},
                              {"q", nullptr},
                              {"waits", event.waits}});
    if (base::has_output(event.kind)) json["output"] = event.output;
    if (base::has_value(event.kind)) json["value"] = event.value;
    if (base::has_q(event.kind)) json["q"] = event.q;
    list.push_back(std::move(json));
  }
  return list;
}

json::Json json_of_asked(const MotionAsked& asked) {
  json::Json start = json::Json::list();
  for (const double position : asked.start) start.push_back(position);
  json::Json json = json::Json::object({{"mode", nullptr},
                                        {"tolerance_mm", nullptr},
                                        {"smoothing", nullptr},
                                        {"interpolator", interpolator::name(asked.steps)},
                                        {"start", start}});
  if (asked.mode) json["mode"] = *asked.mode == gcode::PathMode::exact_stop ? "exact-stop" : "blend";
  if (asked.smoothing) json["smoothing"] = *asked.smoothing == machine::Smoothing::splines ? "splines" : "least-time";
  if (asked.tolerance) json["tolerance_mm"] = *asked.tolerance;
  return json;
}

json::Json json_of_recording(const PageParts& parts, const PageRecording& recording) {
  json::Json json = json::Json::object({{"schema", recording_schema},
                                        {"version", LEADSCREW_VERSION},
                                        {"command", parts.command},
                                        {"name", parts.program},
                                        {"text", parts.text},
                                        {"machine", parts.machine},
                                        {"tools", parts.tools},
                                        {"asked", json_of_asked(parts.asked)},
                                        {"events", parts.events},
                                        {"event_count", parts.event_count},
                                        {"result", parts.result}});
  if (parts.gouging) json["gouging"] = *parts.gouging;
  json["samples"] = recording.samples();
  json["blocks"] = recording.blocks();
  return json;
}

std::optional<std::string> workbench_page() {
  const auto path = files::beside_command({LEADSCREW_INSTALLED_PROGRAM, LEADSCREW_BUILT_PROGRAM});
  if (!path) return std::nullopt;
  auto text = files::read_whole(*path, largest_page);
  if (!text) return std::nullopt;
  return std::move(*text);
}

std::optional<std::string> with_recording(std::string page, const json::Json& recording) {
  const std::size_t at = page.find(place());
  if (at == std::string::npos) return std::nullopt;
  page.insert(at + place().size(), embedded(recording));
  return page;
}

}  // namespace leadscrew::results
