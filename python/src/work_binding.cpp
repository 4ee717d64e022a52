// Work of both kinds, and what is done with it.

#include <pybind11/stl.h>

#include <leadscrew/host/moves.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/simulation.hpp>

#include "bindings.hpp"
#include "moving.hpp"

namespace leadscrew::python {

namespace {

std::unique_ptr<TextWork> text_work(const machine::Machine& machine, const std::string& program,
                                    const std::string& name, const Numbers& start, const py::dict& options) {
  TextOptions reading;
  const auto take = [&](const char* key, auto& to) {
    if (options.contains(key)) to = options[key].cast<std::remove_reference_t<decltype(to)>>();
  };
  take("tools", reading.tools);
  take("tools_name", reading.tools_name);
  take("subprograms", reading.subprograms);
  take("tolerance", reading.tolerance);
  take("fuel", reading.fuel);
  take("allow_gouge", reading.allows_gouging);
  if (options.contains("mode")) {
    const bool blends = options["mode"].cast<std::string>() == "blend";
    reading.mode = blends ? gcode::PathMode::blend : gcode::PathMode::exact_stop;
  }
  if (options.contains("interpolator")) {
    const auto wanted = options["interpolator"].cast<std::string>();
    for (const auto rule : interpolator::all_step_rules) {
      if (interpolator::name(rule) == wanted) reading.step_rule = rule;
    }
  }
  auto file = name.empty() ? files::InputFile::open(program) : files::InputFile::of_text(program, name);
  return std::make_unique<TextWork>(machine, value_or_raise(std::move(file)), axes_of(start), reading);
}

/// With the lock; raises where the program has an error.
Reading read_sound(const Work& work, Watch& watch) {
  Reading reading = without_lock(watch, [&] { return work.read(watch); });
  if (reading.has_errors()) raise(reading.diagnostics);
  return reading;
}

/// Of work that may have ended by an interruption, whose own exception comes first.
template <class T>
T done(base::Result<T> result, const Reading& reading) {
  if (result) return std::move(*result);
  Diagnostics all = reading.diagnostics;
  all.push_back(result.error());
  raise(all);
}

py::list events_of(const std::vector<base::PassedEvent>& events) {
  py::list all;
  for (const base::PassedEvent& event : events) {
    if (event.kind == base::Event::Kind::tool_offset || event.kind == base::Event::Kind::tip_control) continue;
    py::dict each;
    each["tick"] = base::count(event.tick);
    each["code"] = std::string(base::code_of(event));
    each["line"] = base::number(event.line);
    each["value"] = event.value;
    each["output"] = event.output;
    each["waits"] = event.waits;
    each["path_length"] = event.path_length;
    all.append(each);
  }
  return all;
}

py::dict run_work(const Work& work, py::object progress) {
  const Work::Use use(work);
  Watch watch(std::move(progress));
  const Reading reading = read_sound(work, watch);
  Moved moved = done(without_lock(watch, [&] { return run(work, reading, watch); }), reading);
  py::dict result;
  result["figures"] =
      results::json_of_run(work.name(), work.machine(), moved.figures, moved.diagnostics).written_in_line();
  result["diagnostics"] = list_of(moved.diagnostics);
  result["kept"] = moved.figures.kept();
  result["events"] = events_of(moved.events);
  result["words"] = array_of(std::move(moved.words), word_fields());
  result["blocks"] = array_of(std::move(moved.blocks), block_fields());
  return result;
}

py::dict check_work(const Work& work, py::object progress) {
  const Work::Use use(work);
  Watch watch(std::move(progress));
  pipeline::PathSurvey survey(work.machine(), work.start());
  const Reading reading = without_lock(watch, [&] {
    Reading read = work.read(watch, &survey);
    if (!read.has_errors()) survey.finish();
    return read;
  });
  results::CheckFigures figures{.blocks = reading.program.blocks, .moves = reading.program.moves};
  if (!reading.has_errors()) {
    figures.extents = results::extents_of(work.machine(), survey.least(), survey.greatest());
    figures.bound_s = survey.bound_seconds();
  }
  py::dict result;
  result["figures"] =
      results::json_of_check(work.name(), work.machine(), figures, reading.diagnostics).written_in_line();
  result["diagnostics"] = list_of(reading.diagnostics);
  return result;
}

py::dict judge_work(const Work& work, const Numbers& positions, py::object progress) {
  const Work::Use use(work);
  Watch watch(std::move(progress));
  const Reading reading = read_sound(work, watch);
  const double* const rows = positions.data();
  const auto count = static_cast<std::size_t>(positions.shape(0));
  const auto figures = done(without_lock(watch, [&] { return judge(work, rows, count, watch); }), reading);
  py::dict result;
  result["figures"] =
      results::json_of_verify(work.name(), work.machine(), figures, reading.diagnostics).written_in_line();
  result["diagnostics"] = list_of(reading.diagnostics);
  result["kept"] = !figures.verdict.objects();
  return result;
}

py::dict simulate_work(const Work& work, bool pulses, py::object progress) {
  const Work::Use use(work);
  Watch watch(std::move(progress));
  const Reading reading = read_sound(work, watch);
  const auto kind = pulses ? drive::LoopKind::pulses : drive::LoopKind::words;
  Simulated simulated = done(without_lock(watch, [&] { return simulate(work, reading, kind, watch); }), reading);
  py::dict result;
  result["figures"] = results::json_of_simulation(work.name(), work.machine(), simulated.figures, simulated.diagnostics)
                          .written_in_line();
  result["diagnostics"] = list_of(simulated.diagnostics);
  result["kept"] = simulated.figures.kept();
  result["rows"] = array_of(std::move(simulated.rows), followed_fields());
  return result;
}

pipeline::Trajectory plan_work(const Work& work, py::object progress) {
  const Work::Use use(work);
  Watch watch(std::move(progress));
  const Reading reading = read_sound(work, watch);
  return done(without_lock(watch, [&] { return plan(work, watch); }), reading);
}

/// The next moves of a host, with their numbers as lines: all, or none where one is refused.
void push(MoveWork& work, std::vector<gcode::Move> moves) {
  host::MoveQueue& queue = work.queue_to_change();
  auto number = static_cast<std::int64_t>(queue.waiting().size());
  for (gcode::Move& move : moves) move.line = base::line_at(++number);
  value_or_raise(queue.push(std::move(moves)));
}
void push(MoveWork& work, gcode::Move move) {
  push(work, std::vector<gcode::Move>{std::move(move)});
}

void push_lines(MoveWork& work, const Numbers& ends, const Numbers& feeds) {
  std::vector<gcode::Move> lines;
  lines.reserve(static_cast<std::size_t>(ends.shape(0)));
  for (py::ssize_t i = 0; i < ends.shape(0); ++i) {
    base::AxisVector end;
    std::copy_n(ends.data(i, 0), end.size(), end.begin());
    lines.push_back(host::line(end, feeds.at(i)));
  }
  push(work, std::move(lines));
}

void push_arc(MoveWork& work, const Numbers& end, const std::string& plane, double first, double second, int turns,
              double feed) {
  const auto of = plane == "XY" ? gcode::Plane::XY : plane == "ZX" ? gcode::Plane::ZX : gcode::Plane::YZ;
  push(work, host::arc(axes_of(end), of, first, second, turns, feed));
}

void push_curve(MoveWork& work, const Numbers& points, const Numbers& weights, const std::vector<double>& knots,
                int degree, double feed) {
  gcode::NurbsCurve curve;
  curve.degree = degree;
  curve.knots = knots;
  for (py::ssize_t i = 0; i < points.shape(0); ++i) {
    gcode::ControlPoint point;
    std::copy_n(points.data(i, 0), point.position.size(), point.position.begin());
    point.weight = weights.at(i);
    curve.points.push_back(point);
  }
  push(work, host::curve(std::move(curve), feed));
}

}  // namespace

void bind_work(py::module_& module) {
  py::class_<Work>(module, "Work")
      .def_property_readonly("name", &Work::name)
      .def_property_readonly("machine", [](const Work& work) { return work.machine(); })
      .def("run", &run_work, py::arg("progress"))
      .def("check", &check_work, py::arg("progress"))
      .def("judge", &judge_work, py::arg("positions"), py::arg("progress"))
      .def("simulate", &simulate_work, py::arg("pulses"), py::arg("progress"))
      .def("plan", &plan_work, py::arg("progress"));
  py::class_<TextWork, Work>(module, "Program")
      .def(py::init(&text_work), py::arg("machine"), py::arg("program"), py::arg("name"), py::arg("start"),
           py::arg("options"));
  py::class_<MoveWork, Work>(module, "Moves")
      .def(py::init([](const machine::Machine& machine, const std::string& name, const Numbers& start) {
             const base::AxisVector at = axes_of(start);
             value_or_raise(host::check_position(at, machine));
             return std::make_unique<MoveWork>(machine, name, at);
           }),
           py::arg("machine"), py::arg("name"), py::arg("start"))
      .def_property_readonly("end", [](const MoveWork& work) { return array_of(work.queue().end()); })
      .def_property_readonly("count", [](const MoveWork& work) { return work.queue().waiting().size(); })
      .def(
          "smooth", [](MoveWork& work, double tolerance) { value_or_raise(work.queue_to_change().smooth(tolerance)); },
          py::arg("tolerance"))
      .def("lines", &push_lines, py::arg("ends"), py::arg("feeds"))
      .def("arc", &push_arc, py::arg("end"), py::arg("plane"), py::arg("first"), py::arg("second"), py::arg("turns"),
           py::arg("feed"))
      .def("curve", &push_curve, py::arg("points"), py::arg("weights"), py::arg("knots"), py::arg("degree"),
           py::arg("feed"))
      .def(
          "dwell", [](MoveWork& work, double seconds) { push(work, host::dwell(seconds)); }, py::arg("seconds"))
      .def("stop", [](MoveWork& work) { work.queue_to_change().end_for_now(); });
}

}  // namespace leadscrew::python
