#include <fmt/format.h>

#include <leadscrew/files/output_file.hpp>
#include <leadscrew/measuring/map_picture.hpp>
#include <leadscrew/measuring/map_text.hpp>
#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/measured.hpp>
#include <leadscrew/results/program_text.hpp>
#include <memory>

namespace leadscrew::results {

namespace {

using measuring::Findings;
using measuring::Measurement;
using measuring::Peak;
using measuring::ProgramSurface;

constexpr double nanometre = 1e-6;

bool is_cut_too_deep(const Findings& found, const MeasureFigures& figures) {
  return -found.cut.height > figures.allowed_cut + nanometre;
}

bool is_ridge_too_tall(const Findings& found, const MeasureFigures& figures) {
  return figures.allowed_ridge && found.ridge.height > *figures.allowed_ridge + nanometre;
}

std::string micrometres(double mm) {
  return fmt::format("{:.4g} um", mm * 1e3);
}

std::string tool_text(const surfaces::Cutter& cutter) {
  if (cutter.is_ball()) return fmt::format("a ball of {:g} mm", 2 * cutter.radius);
  if (cutter.corner_radius == 0) return fmt::format("a flat tool of {:g} mm", 2 * cutter.radius);
  return fmt::format("a bull nose of {:g} mm, edge {:g} mm", 2 * cutter.radius, cutter.corner_radius);
}

std::string passes_text(const ProgramSurface& surface) {
  const surfaces::Machining& machining = surface.machined->machining;
  const std::string apart = machining.scallop > 0 ? fmt::format("ridges of {:g} mm", machining.scallop)
                                                  : fmt::format("{:g} mm apart", machining.step);
  return fmt::format("{} passes of {}, {}", surface.passes, tool_text(machining.cutter), apart);
}

Json json_of_peak(const Peak& peak) {
  if (!peak.exists()) return {};
  return Json::object({{"mm", std::abs(peak.height)},
                       {"u", peak.u},
                       {"v", peak.v},
                       {"x", peak.place[0]},
                       {"y", peak.place[1]},
                       {"z", peak.place[2]},
                       {"t", peak.word.t},
                       {"line", peak.word.line}});
}

Json json_of_surface(const ProgramSurface& surface, const Measurement& measurement) {
  const Findings& found = measurement.findings();
  const surfaces::Machining& machining = surface.machined->machining;
  const auto or_null = [](double value) { return value > 0 ? Json(value) : Json(); };
  return Json::object({{"surface", surface.machined->number},
                       {"line", base::number(surface.machined->line)},
                       {"radius_mm", machining.cutter.radius},
                       {"corner_radius_mm", machining.cutter.corner_radius},
                       {"scallop_mm", or_null(machining.scallop)},
                       {"step_mm", or_null(machining.step)},
                       {"passes", surface.passes},
                       {"u", Json::list({machining.u.from, machining.u.to})},
                       {"v", Json::list({machining.v.from, machining.v.to})},
                       {"columns", measurement.map().columns()},
                       {"rows", measurement.map().rows()},
                       {"area_mm2", found.area},
                       {"reach_mm", measurement.target().reach},
                       {"not_reached_mm2", found.not_reached},
                       {"cut", json_of_peak(found.cut)},
                       {"ridge", json_of_peak(found.ridge)},
                       {"mean_ridge_mm", found.ridges > 0 ? Json(found.mean_ridge) : Json()},
                       {"mean_mm", found.mean_height},
                       {"chord_mm", found.chord}});
}

std::string place_text(const Peak& peak) {
  std::string text = fmt::format("at u {:.4g}, v {:.4g}: X {:.3f} Y {:.3f} Z {:.3f}", peak.u, peak.v, peak.place[0],
                                 peak.place[1], peak.place[2]);
  if (peak.word.line > 0) text += fmt::format(", line {}", peak.word.line);
  return text;
}

std::string surface_text(const ProgramSurface& surface, const Measurement& measurement, const MeasureFigures& figures,
                         const Style& style) {
  const Findings& found = measurement.findings();
  std::string text = fmt::format("  surface {}, line {}: {}\n", surface.machined->number,
                                 base::number(surface.machined->line), passes_text(surface));
  const auto judged = [&](const std::string& what, bool is_bad) { return is_bad ? style(Tone::error, what) : what; };
  if (found.cut.exists()) {
    text += row("cut", judged(micrometres(-found.cut.height), is_cut_too_deep(found, figures)) + " deep " +
                           place_text(found.cut));
  } else {
    text += row("cut", "none");
  }
  if (found.ridge.exists()) {
    text += row("ridge", judged(micrometres(found.ridge.height), is_ridge_too_tall(found, figures)) + " tall " +
                             place_text(found.ridge));
  }
  if (found.ridges > 0) text += row("ridges", micrometres(found.mean_ridge) + " on the mean");
  text += row("left", micrometres(found.mean_height) + " on the mean of all places");
  const std::string missed = found.not_reached > 0 ? fmt::format("{:.4g} mm2 not reached: more than {:g} mm left",
                                                                 found.not_reached, measurement.target().reach)
                                                   : std::string("all of it reached");
  text += row("area", fmt::format("{:.2f} mm2, {}", found.area, missed));
  return text + row("grid", fmt::format("{} by {} places; words joined to {}", measurement.map().columns(),
                                        measurement.map().rows(), micrometres(found.chord)));
}

base::Result<void> write_map(files::OutputFile& file, const MeasureFigures& figures) {
  measuring::MapText map(file.sink());
  for (std::size_t k = 0; k < figures.measured->measurements().size(); ++k) {
    const base::Line line = figures.measured->tools().surfaces()[k].machined->line;
    if (auto written = map.write(*figures.measured->measurements()[k], line); !written) return written;
  }
  return map.finish();
}

base::Result<void> write_picture(files::OutputFile& file, const MeasureFigures& figures, const std::string& program) {
  std::vector<measuring::Pictured> pictured;
  for (std::size_t k = 0; k < figures.measured->measurements().size(); ++k) {
    const ProgramSurface& surface = figures.measured->tools().surfaces()[k];
    pictured.push_back({fmt::format("Surface {}, line {}: {}", surface.machined->number,
                                    base::number(surface.machined->line), passes_text(surface)),
                        figures.measured->measurements()[k].get(), surface.machined->machining.scallop,
                        figures.allowed_cut});
  }
  return measuring::write_map_svg(fmt::format("{}: what {} leaves", program, figures.trace), pictured, file.sink());
}

}  // namespace

bool MeasureFigures::kept() const {
  for (const auto& measurement : measured->measurements()) {
    const Findings& found = measurement->findings();
    if (is_cut_too_deep(found, *this) || is_ridge_too_tall(found, *this)) return false;
  }
  return true;
}

base::Result<std::vector<std::string>> write_measured(const MeasureQuestion& question, const MeasureFigures& figures,
                                                      const std::string& program) {
  std::unique_ptr<files::OutputFile> map, picture;
  std::vector<std::string> names;
  const auto open = [&](const std::optional<std::string>& path, std::unique_ptr<files::OutputFile>& file,
                        const auto& write) -> base::Result<void> {
    if (!path) return {};
    auto opened = files::OutputFile::create(*path, files::OutputFile::Access::sequential);
    if (!opened) return base::failure(opened.error());
    file = std::make_unique<files::OutputFile>(std::move(*opened));
    names.push_back(*path);
    return write(*file);
  };
  if (auto written = open(question.map, map, [&](files::OutputFile& file) { return write_map(file, figures); });
      !written)
    return base::failure(written.error());
  if (auto written = open(question.picture, picture,
                          [&](files::OutputFile& file) { return write_picture(file, figures, program); });
      !written)
    return base::failure(written.error());
  if (auto published = files::publish_together({map.get(), picture.get()}); !published)
    return base::failure(published.error());
  return names;
}

Json json_of_measure(const std::string& program, const machine::Machine& machine, const MeasureFigures& figures,
                     const Diagnostics& diagnostics) {
  Json list = Json::list();
  for (std::size_t k = 0; k < figures.measured->measurements().size(); ++k)
    list.push_back(json_of_surface(figures.measured->tools().surfaces()[k], *figures.measured->measurements()[k]));
  return Json::object({{"schema", measure_schema},
                       {"trace", figures.trace},
                       {"program", program},
                       {"machine", machine.name},
                       {"words", figures.measured->words()},
                       {"allowed_cut_mm", figures.allowed_cut},
                       {"allowed_ridge_mm", figures.allowed_ridge},
                       {"kept", figures.kept()},
                       {"surfaces", list},
                       {"diagnostics", json_of_diagnostics(diagnostics)}});
}

std::string measure_summary(const std::string& program, const machine::Machine& machine, const MeasureFigures& figures,
                            const Style& style) {
  std::string text =
      fmt::format("{} on {}, {} words\n", style(Tone::strong, printable(figures.trace + " against " + program)),
                  printable(machine.name), figures.measured->words());
  for (std::size_t k = 0; k < figures.measured->measurements().size(); ++k)
    text += surface_text(figures.measured->tools().surfaces()[k], *figures.measured->measurements()[k], figures, style);
  const std::string asked =
      fmt::format("no cut deeper than {:g} mm{}", figures.allowed_cut,
                  figures.allowed_ridge ? fmt::format(", no ridge taller than {:g} mm", *figures.allowed_ridge) : "");
  text +=
      "  " + (figures.kept() ? style(Tone::good, "kept: " + asked) : style(Tone::error, "NOT kept: " + asked)) + "\n";
  for (const std::string& file : figures.files) text += row("wrote", printable(file));
  return text;
}

}  // namespace leadscrew::results
