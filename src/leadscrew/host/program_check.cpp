#include <leadscrew/host/program_check.hpp>
#include <leadscrew/host/program_reading.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>
#include <memory>
#include <utility>

namespace leadscrew::host {

base::Result<CheckedProgram> check_program(const machine::Machine& machine, std::string text,
                                           const MotionOptions& options, const gcode::DiagnosticSink& diagnostics) {
  CheckedProgram checked;
  const auto share = std::make_shared<double>(0);
  const auto texts = std::make_shared<ProgramTexts>(std::move(text), options.subprogram);
  gcode::Reader reader(asking_source(texts->program(), options.goes_on, share), machine, options.tools,
                       reading_of(machine, options, texts), [&](const base::Diagnostic& diagnostic) {
                         if (diagnostic.severity == base::Severity::error && !checked.error) checked.error = diagnostic;
                         if (diagnostics) diagnostics(diagnostic);
                       });
  pipeline::PathSurvey survey(machine, options.start);
  const auto read =
      pipeline::read_whole(reader, {.survey = &survey,
                                    .is_sound = [&] { return !checked.error; },
                                    .moves_between_questions = 64,  // the survey makes the tool path
                                    .goes_on = [&] { return !options.goes_on || options.goes_on(*share); }});
  if (read.was_interrupted) return base::failure(interruption());
  if (reader.source_failure()) return base::failure(*reader.source_failure());
  checked.blocks = read.blocks;
  checked.moves = read.moves;
  if (checked.error) return checked;
  survey.finish();
  checked.bound_s = survey.bound_seconds();
  checked.least = survey.least();
  checked.greatest = survey.greatest();
  return checked;
}

}  // namespace leadscrew::host
