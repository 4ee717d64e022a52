// Surfaces from arrays: evaluated at many places, written as blocks, and the passes of a tool over them.

#include <pybind11/stl.h>

#include <cmath>
#include <leadscrew/surfaces/frame.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <leadscrew/surfaces/surface_text.hpp>
#include <memory>
#include <numbers>

#include "arrays.hpp"
#include "bindings.hpp"
#include "watch.hpp"

namespace leadscrew::python {

namespace {

using Shared = std::shared_ptr<surfaces::Surface>;

std::string text_of(const surfaces::SurfaceFault& fault) {
  using Kind = surfaces::SurfaceFault::Kind;
  const std::string direction = fault.direction == surfaces::Direction::u ? "u" : "v";
  const std::string where = std::to_string(fault.index) + " in " + direction;
  switch (fault.kind) {
    case Kind::counts:
      return "degree, points and knots in " + direction +
             " do not go together: expected a degree of 1 to 5, more points than that, and points + degree + 1 knots";
    case Kind::not_finite:
      return "a coordinate, weight or knot is not finite";
    case Kind::weight:
      return "weight " + std::to_string(fault.index) + " is not above 0";
    case Kind::knots:
      return "knot " + where +
             ": expected knots that do not decrease, degree + 1 alike at both ends and inside no more than degree "
             "alike";
    case Kind::rows:
      return "rows " + where + " and the next coincide: expected a surface without folds";
    case Kind::normal:
      return "the normal vanishes at u = " + std::to_string(fault.u) + ", v = " + std::to_string(fault.v);
  }
  return "no surface";
}

std::string text_of(const surfaces::PassFailure& failure) {
  constexpr const char* texts[] = {
      "the surface's normal vanishes",
      "the tool gouges where it touches: expected a smaller tool, or allow_gouge",
      "a flat tool stands on the surface with all of its bottom: expected a lead or a tilt",
      "the tool's axis points into the surface: expected the other side, or another orientation",
      "the normal turns by a step inside the range: expected a range that ends there",
      "the tip stands still while the contact moves",
      "passes are too many: expected a greater scallop or step",
      "no step leaves so low a ridge: expected a smaller tool or a greater scallop",
      "planes of the pattern meet the surface in lines that double back",
      "no link was found that keeps off the surface"};
  return std::string(texts[static_cast<std::size_t>(failure.kind)]) + " (u = " + std::to_string(failure.u) +
         ", v = " + std::to_string(failure.v) + ")";
}

/// net: nu × nv × 4, X Y Z and weight, mm.
Shared surface_of(const Numbers& net, const std::array<int, 2>& degree,
                  const std::array<std::vector<double>, 2>& knots) {
  surfaces::SurfaceForm form;
  form.degree = degree;
  form.count = {static_cast<std::size_t>(net.shape(0)), static_cast<std::size_t>(net.shape(1))};
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_uniform = knots[k].empty() && degree[k] >= 1 && form.count[k] > static_cast<std::size_t>(degree[k]);
    form.knots[k] = is_uniform ? surfaces::uniform_knots(form.count[k], degree[k]) : knots[k];
  }
  for (py::ssize_t j = 0; j < net.shape(1); ++j) {
    for (py::ssize_t i = 0; i < net.shape(0); ++i) {
      const double* const at = net.data(i, j, 0);
      form.net.push_back({{at[0], at[1], at[2]}, at[3]});
    }
  }
  if (const auto fault = surfaces::fault_of(form)) throw py::value_error(text_of(*fault));
  return std::make_shared<surfaces::Surface>(std::move(form));
}

void put(Numbers& rows, std::size_t i, const kinematics::Vector& values) {
  std::copy(values.begin(), values.end(), rows.mutable_data(static_cast<py::ssize_t>(i), 0));
}

/// Of n places: position, normal on the side of Su × Sv, first derivatives, n × 3 each, and both principal curvatures, n × 2.
py::dict evaluate(const surfaces::Surface& surface, const Numbers& us, const Numbers& vs) {
  const auto count = static_cast<std::size_t>(us.size());
  Numbers position = new_numbers(count, 3), normal = new_numbers(count, 3), by_u = new_numbers(count, 3),
          by_v = new_numbers(count, 3), curvature = new_numbers(count, 2);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i) {
    const auto jet = surface.jet_of_second_order(us.data()[i], vs.data()[i]);
    put(position, i, jet.s);
    put(by_u, i, jet.u);
    put(by_v, i, jet.v);
    const auto frame = surfaces::frame_of(jet, 1);
    put(normal, i, frame ? frame->n : kinematics::Vector{none, none, none});
    const auto both = frame ? surfaces::curvature_of(jet, *frame, surfaces::tangents_of(jet, *frame, 1, 0)).principal()
                            : std::array<double, 2>{none, none};
    std::copy(both.begin(), both.end(), curvature.mutable_data(static_cast<py::ssize_t>(i), 0));
  }
  py::dict found;
  found["position"] = position;
  found["normal"] = normal;
  found["by_u"] = by_u;
  found["by_v"] = by_v;
  found["curvature"] = curvature;
  return found;
}

surfaces::Machining machining_of(const Shared& surface, const py::dict& options) {
  surfaces::Machining machining;
  machining.surface = surface;
  machining.u = surface->range(surfaces::Direction::u);
  machining.v = surface->range(surfaces::Direction::v);
  machining.cutter = {options["radius"].cast<double>(), options["corner_radius"].cast<double>()};
  machining.scallop = options["scallop"].cast<double>();
  machining.step = options["step"].cast<double>();
  machining.side = options["side"].cast<int>();
  machining.start_corner = options["start_corner"].cast<int>();
  machining.allows_gouging = options["allow_gouge"].cast<bool>();
  machining.pattern = static_cast<surfaces::Pattern>(options["pattern"].cast<int>());
  machining.along = options["along"].cast<std::string>() == "v" ? surfaces::Direction::v : surfaces::Direction::u;
  const auto orientation = options["orientation"].cast<std::string>();
  if (orientation == "normal") {
    machining.orientation.rule = surfaces::Orientation::Rule::normal;
  } else if (orientation == "leaned") {
    constexpr double radians = std::numbers::pi / 180;
    machining.orientation = surfaces::Orientation::leaning(options["lead"].cast<double>() * radians,
                                                           options["tilt"].cast<double>() * radians);
  }
  return machining;
}

py::dict dict_of(const surfaces::Pass& pass) {
  const std::size_t count = pass.nodes.size();
  Numbers tip = new_numbers(count, 3), axis = new_numbers(count, 3), contact = new_numbers(count, 3),
          parameters = new_numbers(count, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const surfaces::PassNode& node = pass.nodes[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<py::ssize_t>(i), column = static_cast<py::ssize_t>(k);
      *tip.mutable_data(row, column) = node.tip[k][0];
      *axis.mutable_data(row, column) = node.axis[k][0];
      *contact.mutable_data(row, column) = node.contact[k][0];
    }
    *parameters.mutable_data(static_cast<py::ssize_t>(i), 0) = node.u;
    *parameters.mutable_data(static_cast<py::ssize_t>(i), 1) = node.v;
  }
  py::dict found;
  found["tip"] = tip;
  found["axis"] = axis;
  found["contact"] = contact;
  found["uv"] = parameters;
  found["is_link"] = pass.is_link;
  found["number"] = pass.number;
  return found;
}

py::list passes(const Shared& surface, const py::dict& options, py::object progress) {
  surfaces::Passes all(machining_of(surface, options));
  Watch watch(std::move(progress));
  py::list list;
  while (true) {
    const auto pass = without_lock(watch, [&] {
      watch.goes_on();
      return all.next();
    });
    if (!pass) break;
    list.append(dict_of(*pass));
  }
  if (all.failure()) throw py::value_error(text_of(*all.failure()));
  return list;
}

std::pair<double, double> range_of(const surfaces::Surface& surface, surfaces::Direction direction) {
  const surfaces::Range range = surface.range(direction);
  return {range.from, range.to};
}

}  // namespace

void bind_surfaces(py::module_& module) {
  py::class_<surfaces::Surface, Shared>(module, "Surface")
      .def(py::init(&surface_of), py::arg("net"), py::arg("degree"), py::arg("knots"))
      .def("range",
           [](const surfaces::Surface& surface) {
             return std::make_pair(range_of(surface, surfaces::Direction::u),
                                   range_of(surface, surfaces::Direction::v));
           })
      .def("evaluate", &evaluate, py::arg("u"), py::arg("v"))
      .def(
          "blocks",
          [](const surfaces::Surface& surface, int number) {
            return surfaces::definition_text(surface.form(), number);
          },
          py::arg("number"))
      .def("passes", &passes, py::arg("options"), py::arg("progress"));
}

}  // namespace leadscrew::python
