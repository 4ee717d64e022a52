#include <algorithm>
#include <leadscrew/host/program_reading.hpp>
#include <utility>

namespace leadscrew::host {

namespace {

constexpr std::size_t bytes_between_questions = 4096;

}  // namespace

base::Diagnostic interruption() {
  return base::problem("interrupted", "interrupted", {});
}

gcode::ByteSource asking_source(std::string_view text, std::function<bool(double)> goes_on,
                                std::shared_ptr<double> share) {
  if (!goes_on) return gcode::text_source(text);
  return [source = gcode::text_source(text), goes_on = std::move(goes_on), share = std::move(share),
          whole = static_cast<double>(text.size()),
          given = std::size_t{0}](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    *share = whole > 0 ? static_cast<double>(given) / whole : 1;
    if (!goes_on(*share)) return base::failure(interruption());
    const auto count = source(buffer.first(std::min(buffer.size(), bytes_between_questions)));
    if (count) given += *count;
    return count;
  };
}

gcode::ReaderOptions reading_of(const machine::Machine& machine, const MotionOptions& options,
                                const std::shared_ptr<ProgramTexts>& texts) {
  gcode::ReaderOptions reading{.file = options.file, .start = options.start, .dialect = machine.dialect};
  reading.opener = [texts](const std::string& name, std::int64_t offset) { return texts->open(name, offset); };
  reading.path_mode = options.path_mode;
  reading.tolerance = options.tolerance;
  reading.fuel = options.fuel;
  reading.asks_inputs = options.has_inputs;
  reading.allows_gouging = options.allows_gouging;
  reading.surface_drafts = texts->surface_drafts();
  if (options.has_probe) reading.probing = gcode::ProbingMoves::real;
  return reading;
}

}  // namespace leadscrew::host
