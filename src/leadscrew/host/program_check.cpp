#include <leadscrew/host/program_check.hpp>
#include <leadscrew/host/program_reading.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <memory>
#include <utility>

namespace leadscrew::host {

base::Result<CheckedProgram> check_program(const machine::Machine& machine, std::string text,
                                           const MotionOptions& options, const gcode::DiagnosticSink& diagnostics) {
  constexpr std::int64_t moves_per_question = 64;  // the survey makes the tool path as well
  CheckedProgram checked;
  const auto share = std::make_shared<double>(0);
  const auto texts = std::make_shared<ProgramTexts>(std::move(text), options.subprogram);
  gcode::Reader reader(asking_source(texts->program(), options.goes_on, share), machine, options.tools,
                       reading_of(machine, options, texts), [&](const base::Diagnostic& diagnostic) {
                         if (diagnostic.severity == base::Severity::error && !checked.error) checked.error = diagnostic;
                         if (diagnostics) diagnostics(diagnostic);
                       });
  pipeline::PathSurvey survey(machine, options.start);
  gcode::Move move;
  for (std::int64_t count = 1; reader.next(move); ++count) {
    const auto excess = checked.error ? std::nullopt : survey.observe(move);
    if (excess) reader.warn_of_feed(move, pipeline::warning_of(*excess));
    if (move.kind != gcode::Move::Kind::dwell && move.kind != gcode::Move::Kind::event) ++checked.moves;
    if (count % moves_per_question == 0 && options.goes_on && !options.goes_on(*share))
      return base::failure(interruption());
  }
  if (reader.source_failure()) return base::failure(*reader.source_failure());
  checked.blocks = reader.blocks();
  if (checked.error) return checked;
  survey.finish();
  checked.bound_s = survey.bound_seconds();
  checked.least = survey.least();
  checked.greatest = survey.greatest();
  return checked;
}

}  // namespace leadscrew::host
