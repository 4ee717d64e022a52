#include <fmt/format.h>

#include <cmath>
#include <leadscrew/results/trace_period.hpp>
#include <leadscrew/trace/trace_reader.hpp>

namespace leadscrew::results {

namespace {

constexpr double evenness = 0.02;
constexpr double shortest = 1e-6, longest = 1.0;  // seconds; a log of another controller may be slower than a servo

tl::unexpected<base::Diagnostic> trace_problem(std::string_view code, const files::InputFile& file, std::string message,
                                               std::string hint) {
  return base::failure({base::Severity::error, code, std::move(message), std::move(hint), {.file = file.name()}, {}});
}

}  // namespace

base::Result<base::Period> trace_period(const files::InputFile& file, base::AxisSet axes, base::Period otherwise) {
  auto reader = trace::TraceReader::open(file.source(), file.name(), axes);
  if (!reader) return base::failure(reader.error());
  double first = 0, before = 0, spacing = 0;
  std::int64_t rows = 0;
  while (true) {
    const auto row = reader->next();
    if (!row) return base::failure(row.error());
    if (!*row) break;
    const double t = (*row)->t;
    ++rows;
    if (rows == 1) first = t;
    if (rows == 2) spacing = t - first;
    const double slack = evenness * spacing + 4e-16 * std::abs(t);
    const bool is_even = rows == 1 || (spacing > 0 && std::abs(t - before - spacing) <= slack);
    if (!is_even) {
      return trace_problem("trace-period", file,
                           fmt::format("row {} is at t = {}, the row before at {}, and the first two are {} apart",
                                       rows, t, before, spacing),
                           "rows evenly spaced");
    }
    before = t;
  }
  if (rows == 0) return trace_problem("trace-empty", file, "the trace has no row", "one row for each servo period");
  if (rows == 1) return otherwise;
  const double mean = (before - first) / static_cast<double>(rows - 1);
  if (mean >= shortest && mean <= longest) return base::Period{std::llround(mean * 1e9)};
  return trace_problem("trace-period", file, fmt::format("rows are {} s apart", mean),
                       "between 1 us and 1 s; t is in seconds");
}

bool is_trace(const files::InputFile& file, base::AxisSet axes) {
  return trace::TraceReader::open(file.source(), file.name(), axes).has_value();
}

}  // namespace leadscrew::results
