// Published experiments made again.

#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <leadscrew/realtime/share_out.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <leadscrew/results/studies.hpp>
#include <leadscrew/study/studies.hpp>
#include <string>

#include "bindings.hpp"
#include "own_process.hpp"

namespace leadscrew::python {

namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// JSON as `leadscrew study NAME --json` prints it, of a name that is one. Its loops ask nobody whether to go on: it is made in a
/// process of its own, as the command's own process ends by ^C.
std::string study_json(const std::string& name) {
  const auto known = study::studies();
  const auto chosen = std::ranges::find(known, name, &study::Study::name);
  if (chosen == known.end()) throw py::value_error("name: expected that of a study, found " + name);
  Watch watch(py::none{});
  return without_lock(watch, [&] {
    return in_own_process(watch, [&] {
      const study::Host host = {realtime::SystemClocks::processor_seconds, wall_seconds, realtime::share_out};
      return results::study_json(chosen->name, chosen->rows(host));
    });
  });
}

}  // namespace

void bind_studies(py::module_& module) {
  module.def("study_list", &results::study_list_json);
  module.def("study", &study_json, py::arg("name"));
}

}  // namespace leadscrew::python
