#include <fmt/format.h>

#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/results/measured_trace.hpp>

namespace leadscrew::results {

namespace {

constexpr std::int64_t moves_between_looks = 1024;

base::Diagnostic of_file(base::Diagnostic problem, const std::string& file) {
  if (problem.place.file.empty()) problem.place.file = file;
  return problem;
}

}  // namespace

base::Result<measuring::ProgramTools> surfaces_of(gcode::Reader reader, const machine::ToolTable& tools,
                                                  const std::string& program) {
  measuring::ProgramTools found(tools);
  gcode::Move move;
  for (std::int64_t count = 0; reader.next(move); ++count) {
    found.see(move, reader);
    if (count % moves_between_looks == 0 && files::interrupted()) return base::failure(files::interruption());
  }
  if (reader.source_failure()) return base::failure(*reader.source_failure());
  if (!found.surfaces().empty()) return found;
  return base::failure(of_file(
      base::problem("measure-nothing", "machines no surface", "G6.4 defines a surface, G6.5 machines it"), program));
}

std::optional<base::Diagnostic> warning_of(const measuring::ProgramTools& tools, const std::string& program) {
  if (tools.left_out() == 0) return std::nullopt;
  return base::Diagnostic{base::Severity::warning,
                          "measure-surfaces",
                          fmt::format("machines {} surfaces more than are measured", tools.left_out()),
                          fmt::format("the first {} are", measuring::ProgramTools::most_surfaces),
                          {.file = program},
                          {}};
}

measuring::MeasureOptions options_of(const MeasureQuestion& question) {
  measuring::MeasureOptions options{.reach = question.reach};
  if (question.places) options.most_places = static_cast<std::size_t>(*question.places);
  return options;
}

base::Result<void> read_trace(const files::InputFile& trace, measuring::TraceMeasurement& measured,
                              const MeasureProgress& progress) {
  std::int64_t bytes = 0;
  const auto open = [&] { return trace::TraceReader::open(trace.source(&bytes), trace.name(), measured.axes()); };
  const auto read = measured.measure(open, [&](std::int64_t rows) -> base::Result<void> {
    if (files::interrupted()) return base::failure(files::interruption());
    progress(rows, bytes);
    return {};
  });
  if (read) return trace.unchanged();
  return base::failure(of_file(read.error(), trace.name()));
}

}  // namespace leadscrew::results
