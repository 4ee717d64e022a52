#include <leadscrew/cli/design.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/console/diagnostic_log.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/sizing.hpp>

namespace leadscrew::cli {

using json::Json;
using results::sizing_schema;

Status design(const Arguments& arguments, Console& console) {
  DiagnosticLog log(console);
  for (const base::Diagnostic& problem : results::problems_of(arguments.design)) log.add(problem);
  if (log.errors() > 0) {
    if (!arguments.json) return log.status();
    Json object = Json::object({{"schema", sizing_schema}, {"diagnostics", results::json_of_diagnostics(log.all())}});
    return worse(log.status(), write_output(console, results::json_text(sizing_schema, {std::move(object)})));
  }
  results::Sizing result = results::answer(arguments.design, console.output_style());
  if (!arguments.json) return arguments.quiet ? Status::done : write_output(console, result.text);
  result.json["diagnostics"] = Json::list();
  return write_output(console, results::json_text(sizing_schema, {std::move(result.json)}));
}

}  // namespace leadscrew::cli
