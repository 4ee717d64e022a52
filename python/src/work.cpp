#include "work.hpp"

#include <algorithm>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/host/program_reading.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <stdexcept>

namespace leadscrew::python {

namespace {

constexpr std::size_t bytes_between_questions = 4096;

machine::ToolTable tools_of(const TextOptions& options) {
  if (options.tools.empty()) return {};
  gcode::ToolTableText read = gcode::read_tool_table(options.tools, options.tools_name);
  if (std::ranges::any_of(read.diagnostics, [](const auto& each) { return each.severity == base::Severity::error; }))
    raise(read.diagnostics);
  return std::move(read.table);
}

}  // namespace

bool Reading::has_errors() const {
  return std::ranges::any_of(diagnostics, [](const auto& each) { return each.severity == base::Severity::error; });
}

TextWork::TextWork(machine::Machine machine, files::InputFile file, const base::AxisVector& start,
                   const TextOptions& options)
    : Work(std::move(machine), file.name(), start),
      file_(std::move(file)),
      options_(options),
      tools_(tools_of(options)) {}

gcode::ReaderOptions TextWork::reading() const {
  gcode::ReaderOptions reading;
  reading.file = file_.name();
  reading.start = start();
  reading.dialect = machine().dialect;
  reading.path_mode = options_.mode;
  reading.tolerance = options_.tolerance;
  reading.fuel = options_.fuel;
  reading.opener = file_.opener(options_.subprograms);
  reading.surface_drafts = surface_drafts_;
  reading.allows_gouging = options_.allows_gouging;
  return reading;
}

gcode::ByteSource TextWork::asking(Watch& watch, Tells tells) const {
  return [source = file_.source(), &watch, tells, whole = static_cast<double>(file_.size()),
          given = std::size_t{0}](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    const double share = whole > 0 ? static_cast<double>(given) / whole : 1;
    if (!(tells == Tells::share ? watch.goes_on(share) : watch.goes_on())) return base::failure(host::interruption());
    const auto count = source(buffer.first(std::min(buffer.size(), bytes_between_questions)));
    if (count) given += *count;
    return count;
  };
}

Reading TextWork::read(Watch& watch, pipeline::Survey* survey) const {
  Reading reading;
  const double begin = realtime::SystemClocks::processor_seconds();
  gcode::Reader reader(asking(watch, Tells::nothing), machine(), tools_, this->reading(),
                       [&](const base::Diagnostic& found) { reading.diagnostics.push_back(found); });
  reading.program = pipeline::read_whole(reader, {.survey = survey,
                                                  .is_sound = [&] { return !reading.has_errors(); },
                                                  .see = nullptr,
                                                  .moves_between_questions = 64,
                                                  .goes_on = [&] { return watch.goes_on(); }});
  if (reader.source_failure()) reading.diagnostics.push_back(*reader.source_failure());
  reading.seconds = realtime::SystemClocks::processor_seconds() - begin;
  return reading;
}

template <class Joined>
std::unique_ptr<Joined> TextWork::joined(Watch& watch) const {
  auto made = std::make_unique<Joined>(asking(watch, Tells::share), machine(), tools_, reading(), nullptr);
  made->stop_when([&watch] { return !watch.goes_on(); });
  return made;
}

std::unique_ptr<pipeline::Program> TextWork::program(Watch& watch) const {
  auto made = joined<pipeline::Program>(watch);
  made->watch([this] { return file_.unchanged(); });
  made->step_by(options_.step_rule);
  return made;
}

std::unique_ptr<pipeline::MotionSource> TextWork::motion(Watch& watch) const {
  auto made = joined<pipeline::MotionSource>(watch);
  made->unchanged = [this] { return file_.unchanged(); };
  return made;
}

referee::MoveSource TextWork::moves() const {
  auto reader = std::make_shared<gcode::Reader>(file_.source(), machine(), tools_, reading(), nullptr);
  return [reader = std::move(reader)](gcode::Move& move) { return reader->next(move); };
}

host::MoveQueue& MoveWork::queue_to_change() {
  if (is_in_use())
    throw std::runtime_error(name() + ": expected a change of the path before or after its run, found one meanwhile");
  return queue_;
}

Reading MoveWork::read(Watch&, pipeline::Survey* survey) const {
  Reading reading;
  for (const gcode::Move& move : queue_.waiting()) {
    if (move.kind != gcode::Move::Kind::dwell) ++reading.program.moves;
    if (survey != nullptr) survey->observe(move);
  }
  return reading;
}

template <class Joined>
std::unique_ptr<Joined> MoveWork::joined(Watch& watch) const {
  auto given = std::make_shared<std::size_t>(0);
  const auto& all = queue_.waiting();
  auto made = std::make_unique<Joined>(
      [given, &all](gcode::Move& move) {
        if (*given == all.size()) return pipeline::Supply::end;
        move = all[(*given)++];
        return pipeline::Supply::move;
      },
      machine(), start());
  made->stop_when([&watch, given, &all] {
    return !watch.goes_on(static_cast<double>(*given) / static_cast<double>(std::max<std::size_t>(all.size(), 1)));
  });
  return made;
}

std::unique_ptr<pipeline::Program> MoveWork::program(Watch& watch) const {
  return joined<pipeline::Program>(watch);
}

std::unique_ptr<pipeline::MotionSource> MoveWork::motion(Watch& watch) const {
  return joined<pipeline::MotionSource>(watch);
}

referee::MoveSource MoveWork::moves() const {
  return [this, given = std::size_t{0}](gcode::Move& move) mutable {
    if (given == queue_.waiting().size()) return false;
    move = queue_.waiting()[given++];
    return true;
  };
}

}  // namespace leadscrew::python
