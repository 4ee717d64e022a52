#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/probe.hpp>
#include <string>

namespace leadscrew::machine {

namespace {

using Kind = ProbeBody::Kind;

void check_plane(const Machine& machine, base::Axis axis, std::vector<base::Diagnostic>& problems) {
  const std::optional<double>& plane = machine.probe->planes[base::index(axis)];
  if (!plane || (machine.has(axis) && !base::is_rotary(axis) && std::isfinite(*plane))) return;
  const std::string whole = std::string("the probe's plane ") + base::letter(axis) + " = " + base::text(*plane);
  const base::Subject subject{.axis = axis, .field = field::probe_plane};
  if (!machine.has(axis)) {
    problems.push_back(base::problem("machine-probe", whole + ", but there is no such axis",
                                     "give planes for axes of the machine", subject));
  } else {
    problems.push_back(base::problem(
        "machine-probe", whole, "mm in machine coordinates, of a linear axis, such as plane_mm = {Z = -3}", subject));
  }
}

/// Has it an extent, and a place?
bool is_sound(const ProbeBody& body) {
  if (!std::isfinite(body.radius)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(body.from[i]) || !std::isfinite(body.to[i])) return false;
  }
  if (body.kind == Kind::sphere) return body.radius > 0;
  if (body.kind == Kind::cylinder || body.kind == Kind::bore) return body.radius > 0 && body.from != body.to;
  return std::ranges::equal(body.from, body.to, std::less<>());
}

std::string numbers(const ProbeBody& body) {
  const auto triple = [](const Vector& v) {
    return base::text(v[0]) + ", " + base::text(v[1]) + ", " + base::text(v[2]);
  };
  const bool is_round = body.kind != Kind::box && body.kind != Kind::pocket;
  return "[" + triple(body.from) + (body.kind == Kind::sphere ? "" : ", " + triple(body.to)) +
         (is_round ? ", " + base::text(body.radius) : "") + "]";
}

bool is_sound(const ProbePatch& patch) {
  const auto [p, q] = patch.degree;
  if (p < 1 || p > 5 || q < 1 || q > 5) return false;
  if (patch.net.size() != (static_cast<std::size_t>(p) + 1) * (static_cast<std::size_t>(q) + 1)) return false;
  return std::ranges::all_of(patch.net, [](const std::array<double, 4>& point) {
    return std::ranges::all_of(point, [](double value) { return std::isfinite(value); }) && point[3] > 0;
  });
}

void check_patches(const Machine& machine, std::vector<base::Diagnostic>& problems) {
  const std::vector<ProbePatch>& patches = machine.probe->patches;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    if (is_sound(patches[k])) continue;
    problems.push_back(base::problem("machine-probe", "patch " + std::to_string(k + 1) + " of the probe is none",
                                     "degrees of 1 to 5, as many points as they say, finite, weights above 0",
                                     {.field = probe_patch_field, .entry = k}));
  }
}

/// What its extent must be, and an example.
constexpr const char* extent_of(Kind kind) {
  switch (kind) {
    case Kind::sphere:
      return "a radius above 0, such as [0, 0, -20, 12]";
    case Kind::cylinder:
    case Kind::bore:
      return "which lie apart, and a radius above 0, such as [0, 0, -20, 0, 0, 0, 12]";
    case Kind::box:
    case Kind::pocket:
      break;
  }
  return "each of the second greater, such as [0, 0, -20, 60, 40, 0]";
}

}  // namespace

std::string_view probe_body_form(Kind kind) {
  switch (kind) {
    case Kind::sphere:
      return "[x, y, z, radius]: the centre and the radius";
    case Kind::cylinder:
    case Kind::bore:
      return "[x, y, z, x, y, z, radius]: the middles of both ends and the radius";
    case Kind::box:
    case Kind::pocket:
      break;
  }
  return "[x, y, z, x, y, z]: the corners of the least and the greatest coordinates";
}

void check_probe(const Machine& machine, std::vector<base::Diagnostic>& problems) {
  for (const base::Axis axis : base::all_axes) check_plane(machine, axis, problems);
  check_patches(machine, problems);
  std::array<std::size_t, probe_body_fields.size()> entries{};
  for (const ProbeBody& body : machine.probe->bodies) {
    const auto kind = static_cast<std::size_t>(body.kind);
    const std::size_t entry = entries[kind]++;
    if (is_sound(body)) continue;
    problems.push_back(base::problem("machine-probe",
                                     "entry " + std::to_string(entry + 1) + " of the " +
                                         std::string(probe_body_fields[kind]) + " is " + numbers(body),
                                     std::string(probe_body_form(body.kind)) + ", " + extent_of(body.kind),
                                     {.field = probe_body_fields[kind], .entry = entry}));
  }
}

}  // namespace leadscrew::machine
