// The calls of leadscrew.h for what a tool cuts: the shape of surfaces, the tools that machine them, where these gouge, and contours.

#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/machined_surfaces.hpp>
#include <leadscrew/gouging/mesh.hpp>
#include <leadscrew/gouging/move_ways.hpp>
#include <leadscrew/gouging/program_check.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program_readings.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

namespace {

constexpr std::size_t most_cells = 500'000;  // two triangles each
constexpr int most_halvings = 12;            // of half a radian of an arc

template <class Use>
int with_program(const leadscrew_machine* machine, const char* text, size_t length, const leadscrew_options* given,
                 double number, bool has_function, leadscrew_error* error, const Use& use) {
  if (machine == nullptr || !is_text(text, length) || !has_function)
    return misuse(error, "the machine, the text or the function is NULL, or the length is none that memory holds");
  if (!(number > 0 && std::isfinite(number))) return misuse(error, "the sag or the tolerance is not more than 0");
  return with_readings(*machine, text, length, given, error, use);
}

/// The surfaces of a whole reading. False where there are too many; an error is that of the readings.
bool read_surfaces(ProgramReadings& readings, gouging::MachinedSurfaces& found) {
  gcode::Reader reader = readings.open();
  std::shared_ptr<const gcode::Machined> last;
  gcode::Move move;
  while (!readings.error() && reader.next(move)) {
    const auto& machined = reader.machined().surface;
    if (!machined || machined == last) continue;
    last = machined;
    if (found.add(*machined, reader.frame()) == nullptr) return false;
    if (readings.is_ended()) return true;
  }
  readings.take(reader);
  return true;
}

void append(const surfaces::Vector& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

void tell_surface(const surfaces::Surface& surface, int number, double sag, leadscrew_surface_function on_surface,
                  void* user) {
  std::vector<gouging::Cell> cells;
  gouging::tessellate(surface, 0, sag, std::max(most_cells, gouging::least_cells(surface)), cells);
  std::vector<double> corners, normals;
  for (const gouging::Cell& cell : cells) {
    for (const surfaces::Vector& corner : cell.corners) append(corner, corners);
    for (const auto& [u, v] : {std::pair(cell.u.from, cell.v.from), std::pair(cell.u.to, cell.v.from),
                               std::pair(cell.u.to, cell.v.to), std::pair(cell.u.from, cell.v.to)}) {
      const auto frame = surfaces::frame_of(surface.jet_of_second_order(u, v), 1);
      append(frame ? frame->n : surfaces::Vector{}, normals);
    }
  }
  leadscrew_surface told{};
  told.size = sizeof told;
  told.number = number;
  told.cells = cells.size();
  told.corners = corners.data();
  told.normals = normals.data();
  on_surface(&told, user);
}

/// What both kinds have.
template <class Found>
leadscrew_gouge gouge_at(const Found& from, std::int32_t part, std::size_t pass) {
  auto gouge = of_line<leadscrew_gouge>(from.line);
  gouge.part = part;
  gouge.pass = static_cast<std::int32_t>(pass);
  gouge.surface = from.surface;
  gouge.u = from.u;
  gouge.v = from.v;
  std::copy(from.place.begin(), from.place.end(), gouge.place);
  return gouge;
}

leadscrew_gouge gouge_of(const gouging::Gouge& from) {
  leadscrew_gouge gouge = gouge_at(from, from.pass ? 1 + static_cast<std::int32_t>(from.of) : LEADSCREW_NO_SURFACE,
                                   static_cast<std::size_t>(from.pass.value_or(0)));
  gouge.tool_part = static_cast<std::int32_t>(from.part);
  gouge.depth = from.depth;
  std::copy(from.pose.tip.begin(), from.pose.tip.end(), gouge.tip);
  std::copy(from.pose.axis.begin(), from.pose.axis.end(), gouge.direction);
  return gouge;
}

leadscrew_gouge gouge_of(const gouging::LocalClearance& from) {
  leadscrew_gouge gouge = gouge_at(from, LEADSCREW_PASS, static_cast<std::size_t>(from.pass));
  gouge.clearance = from.clearance;
  std::copy(from.place.begin(), from.place.end(), gouge.tip);
  return gouge;
}

/// Behind `from`, which the places end with, up to t = `to`: so many halvings at most.
void append_chords(const gouging::Way& way, double from, double to, double sag, int halvings,
                   std::vector<double>& places) {
  const surfaces::Vector end = way.at(to).tip, middle = way.at((from + to) / 2).tip;
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double off = middle[i] - (places[places.size() - 3 + i] + end[i]) / 2;
    squared += off * off;
  }
  if (halvings == 0 || squared <= sag * sag) return append(end, places);
  append_chords(way, from, (from + to) / 2, sag, halvings - 1, places);
  append_chords(way, (from + to) / 2, to, sag, halvings - 1, places);
}

void tell_contour(const gcode::Move& move, const gouging::Way& way, double sag, leadscrew_contour_function on_contour,
                  void* user) {
  std::vector<double> places;
  append(way.at(0).tip, places);
  const double parts = std::ceil(1 / way.most_step);
  for (double part = 0; part < parts; ++part)
    append_chords(way, part / parts, (part + 1) / parts, sag, most_halvings, places);
  auto told = of_line<leadscrew_contour>(move.line);
  told.is_rapid = move.feed.mode == gcode::Feed::Mode::rapid ? 1 : 0;
  told.count = places.size() / 3;
  told.places = places.data();
  on_contour(&told, user);
}

/// Moves of the tool's middle wait for what follows; what is told of the contour waits with them.
int tell_contours(ProgramReadings& readings, double sag, leadscrew_contour_function on_contour, void* user,
                  leadscrew_error* error) {
  const gouging::MovePoses poses(readings.machine());
  std::vector<gcode::Move> programmed;
  gcode::Reader reader = readings.open([&](const gcode::Move& move) { programmed.push_back(move); });
  gcode::Move move;
  for (bool goes_on = true; goes_on && !readings.error();) {
    goes_on = reader.next(move);
    const base::AxisVector& offset = reader.frame().tool();
    for (const gcode::Move& each : programmed)
      tell_contour(each, gouging::way_of(each, poses, {offset[0], offset[1], offset[2]}), sag, on_contour, user);
    programmed.clear();
  }
  readings.take(reader);
  return readings.error() ? rejected(error, *readings.error()) : static_cast<int>(LEADSCREW_OK);
}

int too_many(leadscrew_error* error) {
  return rejected(error, base::problem("surface-counts", "more surfaces, or larger ones, than are kept",
                                       "at most 1000 surfaces that differ"));
}

int tell_gouges(ProgramReadings& readings, double tolerance, leadscrew_gouge_function on_gouge, void* user,
                leadscrew_error* error) {
  {
    gcode::Reader reader = readings.open();
    gcode::Move move;
    while (!readings.error() && reader.next(move)) {
    }
    readings.take(reader);
  }
  if (readings.error()) return rejected(error, *readings.error());
  const gouging::GougeVerdict verdict =
      gouging::check_gouging([&] { return readings.open(); }, readings.machine(), readings.tools(),
                             {tolerance, [&] { return readings.is_ended(); }});
  if (readings.error()) return rejected(error, *readings.error());
  if (!verdict.fits) return too_many(error);
  const auto tell = [&](const auto& found) {
    const leadscrew_gouge gouge = gouge_of(found);
    on_gouge(&gouge, user);
  };
  for (const auto& [key, found] : verdict.gouges_of_passes) tell(found);
  for (const auto& [line, found] : verdict.local) tell(found);
  return LEADSCREW_OK;
}

}  // namespace

int leadscrew_tools(const leadscrew_options* options, leadscrew_tool_function on_tool, void* user,
                    leadscrew_error* error) {
  if (options == nullptr || on_tool == nullptr) return misuse(error, "the options or the function are NULL");
  return guarded(error, [&] {
    leadscrew_options asked{};
    host::MotionOptions read;
    if (const int code = read_options(options, machine::mill3(), asked, read, error); code != LEADSCREW_OK) return code;
    for (const machine::Tool& tool : read.tools.tools()) {
      leadscrew_tool told{};
      told.size = sizeof told;
      told.number = tool.number;
      told.diameter = std::fabs(tool.diameter);
      told.corner_radius = tool.corner_radius.value_or(-1);
      told.length = tool.length;
      told.holder_diameter = tool.holder_diameter;
      told.holder_length = tool.holder_length;
      on_tool(&told, user);
    }
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_program_surfaces(const leadscrew_machine* machine, const char* text, size_t length,
                               const leadscrew_options* options, double sag, leadscrew_surface_function on_surface,
                               void* user, leadscrew_error* error) {
  return with_program(machine, text, length, options, sag, on_surface != nullptr, error,
                      [&](ProgramReadings& readings) {
                        const gouging::MovePoses poses(readings.machine());
                        gouging::MachinedSurfaces found(poses);
                        if (!read_surfaces(readings, found)) return too_many(error);
                        if (readings.error()) return rejected(error, *readings.error());
                        for (std::size_t i = 0; i < found.all().size(); ++i)
                          tell_surface(*found.all()[i], found.number(i), sag, on_surface, user);
                        return static_cast<int>(LEADSCREW_OK);
                      });
}

int leadscrew_program_gouges(const leadscrew_machine* machine, const char* text, size_t length,
                             const leadscrew_options* options, double tolerance, leadscrew_gouge_function on_gouge,
                             void* user, leadscrew_error* error) {
  return with_program(
      machine, text, length, options, tolerance, on_gouge != nullptr, error,
      [&](ProgramReadings& readings) { return tell_gouges(readings, tolerance, on_gouge, user, error); });
}

int leadscrew_program_contours(const leadscrew_machine* machine, const char* text, size_t length,
                               const leadscrew_options* options, double sag, leadscrew_contour_function on_contour,
                               void* user, leadscrew_error* error) {
  return with_program(machine, text, length, options, sag, on_contour != nullptr, error,
                      [&](ProgramReadings& readings) { return tell_contours(readings, sag, on_contour, user, error); });
}
