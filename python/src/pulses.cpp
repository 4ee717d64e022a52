// Interpolators of reference pulses, every register at every clock, by the calls of leadscrew.h.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <leadscrew.h>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "watch.hpp"

namespace leadscrew::python {

namespace {

using Rows = py::array_t<std::int64_t, py::array::c_style>;

/// leadscrew.ProblemError of what a call has told; ValueError of misuse.
void check(int code, const leadscrew_error& error) {
  if (code == LEADSCREW_OK) return;
  if (code == LEADSCREW_MISUSE) throw py::value_error(error.message);
  const py::module_ problems = py::module_::import("leadscrew.problems");
  py::list all;
  all.append(problems.attr("Diagnostic")("error", error.code, error.message, error.hint, "", 0, 0, "", error.field));
  const py::object raised = problems.attr("ProblemError")(all);
  PyErr_SetObject(problems.attr("ProblemError").ptr(), raised.ptr());
  throw py::error_already_set();
}

struct Pulses {
  leadscrew_pulses* handle = nullptr;
  Pulses() = default;
  Pulses(const Pulses&) = delete;
  Pulses& operator=(const Pulses&) = delete;
  ~Pulses() { leadscrew_pulses_free(handle); }
};

using Point = std::array<std::int64_t, 2>;

std::unique_ptr<Pulses> load(const std::string& method, bool is_arc, const Point& start, const Point& end,
                             const Point& center, int turns, const py::dict& options) {
  leadscrew_pulse_task task{};
  task.size = sizeof task;
  task.kind = is_arc ? LEADSCREW_ARC : LEADSCREW_LINE;
  task.turns = turns;
  task.method = method.c_str();
  std::copy(start.begin(), start.end(), task.start);
  std::copy(end.begin(), end.end(), task.end);
  std::copy(center.begin(), center.end(), task.center);
  const auto number = [&](const char* name, auto& to) {
    if (options.contains(name)) to = options[name].cast<std::remove_reference_t<decltype(to)>>();
  };
  number("bits", task.bits);
  number("capacity", task.capacity);
  number("free", task.is_free);
  number("places", task.places);
  if (options.contains("semi_axes")) {
    const auto both = options["semi_axes"].cast<Point>();
    std::copy(both.begin(), both.end(), task.semi_axes);
  }
  std::array<std::string, 4> texts;
  const std::pair<const char*, const char * leadscrew_pulse_task::*> names[] = {
      {"preload", &leadscrew_pulse_task::preload},
      {"order", &leadscrew_pulse_task::order},
      {"tie", &leadscrew_pulse_task::tie},
      {"accumulation", &leadscrew_pulse_task::accumulation}};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!options.contains(names[i].first)) continue;
    texts[i] = options[names[i].first].cast<std::string>();
    task.*names[i].second = texts[i].c_str();
  }
  leadscrew_error error{};
  error.size = sizeof error;
  auto pulses = std::make_unique<Pulses>();
  check(leadscrew_pulses_load(&task, &pulses->handle, &error), error);
  return pulses;
}

/// What a call names by number, from 0 until it names nothing.
template <class NameAt>
std::vector<std::string> all_names(const NameAt& name_at) {
  std::vector<std::string> names;
  while (const char* name = name_at(names.size())) names.emplace_back(name);
  return names;
}

std::vector<std::string> columns_of(const Pulses& pulses) {
  return all_names([&](std::size_t index) { return leadscrew_pulses_column(pulses.handle, index); });
}

/// All clocks that are left, no more than so many, a row each.
Rows table(Pulses& pulses, std::size_t most, py::object progress) {
  constexpr std::size_t clocks_together = 4096;
  const std::size_t columns = columns_of(pulses).size();
  Watch watch(std::move(progress));
  auto rows = std::make_unique<std::vector<std::int64_t>>();
  without_lock(watch, [&] {
    std::size_t made = 0, count = 1;
    while (count > 0 && made < most && watch.goes_on(static_cast<double>(made) / static_cast<double>(most))) {
      const std::size_t wanted = std::min(clocks_together, most - made);
      rows->resize((made + wanted) * columns);
      leadscrew_pulses_next(pulses.handle, rows->data() + made * columns, wanted, &count, nullptr);
      made += count;
    }
    rows->resize(made * columns);
    return made;
  });
  std::int64_t* const data = rows->data();
  const auto height = static_cast<py::ssize_t>(rows->size() / columns), width = static_cast<py::ssize_t>(columns);
  const py::capsule owner(rows.release(), [](void* all) { delete static_cast<std::vector<std::int64_t>*>(all); });
  return Rows({height, width}, data, owner);
}

/// What a call tells of them in a structure of the library.
template <class Told, class Call>
Told told_of(const Pulses& pulses, const Call& call) {
  Told told{};
  told.size = sizeof told;
  call(pulses.handle, &told, nullptr);
  return told;
}

py::dict figures_of(const Pulses& pulses) {
  const auto figures = told_of<leadscrew_pulse_figures>(pulses, leadscrew_pulses_figures);
  py::dict all;
  all["clocks"] = figures.clocks;
  all["pulses"] = figures.pulses;
  all["position"] = py::make_tuple(figures.position[0], figures.position[1]);
  all["max_error"] = figures.max_error;
  all["rms_error"] = figures.rms_error;
  all["worst"] = py::make_tuple(figures.worst[0], figures.worst[1]);
  all["worst_clock"] = figures.worst_clock;
  all["done"] = figures.is_done != 0;
  return all;
}

py::dict conventions_of(const Pulses& pulses) {
  const auto found = told_of<leadscrew_pulse_conventions>(pulses, leadscrew_pulses_conventions);
  py::dict all;
  all["bits"] = found.bits;
  all["capacity"] = found.capacity;
  all["clocks_per_blu"] = found.clocks_per_blu;
  all["preload"] = found.preload;
  all["order"] = found.order;
  all["tie"] = found.tie;
  all["end"] = found.end;
  all["accumulation"] = found.accumulation;
  return all;
}

std::vector<std::string> names_of(int what) {
  return all_names([&](std::size_t index) { return leadscrew_pulse_name(what, index); });
}

}  // namespace

void bind_pulses(py::module_& module) {
  py::class_<Pulses>(module, "Pulses")
      .def(py::init(&load), py::arg("method"), py::arg("is_arc"), py::arg("start"), py::arg("end"), py::arg("center"),
           py::arg("turns"), py::arg("options"))
      .def("columns", &columns_of)
      .def("table", &table, py::arg("most"), py::arg("progress"))
      .def("figures", &figures_of)
      .def("conventions", &conventions_of);
  module.def("pulse_names", [] {
    py::dict all;
    all["method"] = names_of(LEADSCREW_METHODS);
    all["preload"] = names_of(LEADSCREW_PRELOADS);
    all["order"] = names_of(LEADSCREW_ORDERS);
    all["tie"] = names_of(LEADSCREW_TIES);
    all["accumulation"] = names_of(LEADSCREW_ACCUMULATIONS);
    return all;
  });
}

}  // namespace leadscrew::python
