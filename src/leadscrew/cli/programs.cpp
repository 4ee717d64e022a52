#include <leadscrew/cli/programs.hpp>
#include <leadscrew/results/program_json.hpp>

namespace leadscrew::cli {

Status write_output(Console& console, std::string_view text) {
  const auto written = console.output(text);
  if (written) return Status::done;
  if (written.error().code == "io-write") console.diagnostic(written.error());
  return status_of(written.error());
}

Status for_each_program(const Job& job, Console& console, std::string_view schema, const ProgramWork& work) {
  const Arguments& arguments = job.arguments;
  Status worst = Status::done;
  std::vector<json::Json> objects;
  for (const std::string& program : arguments.programs) {
    ProgramResult result = work(program, job_of(job, program));
    worst = worse(worst, result.status);
    if (result.status == Status::interrupted) return worst;
    if (arguments.json) {
      objects.push_back(std::move(result.json));
    } else if (!arguments.quiet && !result.summary.empty()) {
      const Status written = write_output(console, result.summary);
      if (written != Status::done) return worse(worst, written);
    }
  }
  return arguments.json ? worse(worst, write_output(console, results::json_text(schema, std::move(objects)))) : worst;
}

}  // namespace leadscrew::cli
