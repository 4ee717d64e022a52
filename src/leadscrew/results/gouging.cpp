#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/results/gouging.hpp>
#include <utility>

namespace leadscrew::results {

namespace {

using gouging::Gouge;
using gouging::GougeVerdict;
using gouging::LocalClearance;
using json::Json;

constexpr std::string_view name_of(gouging::Part::Kind kind) {
  return kind == gouging::Part::Kind::cutter ? "cutter" : kind == gouging::Part::Kind::shank ? "shank" : "holder";
}

constexpr std::string_view name_of(gcode::MachinedMove::Part part) {
  using Part = gcode::MachinedMove::Part;
  return part == Part::approach ? "approach" : part == Part::pass ? "pass" : part == Part::link ? "link" : "retract";
}

/// What move it is, by words.
std::string motion_text(const Gouge& gouge) {
  if (!gouge.pass) return "the move";
  using Part = gcode::MachinedMove::Part;
  if (gouge.of == Part::pass) return fmt::format("pass {}", *gouge.pass + 1);
  if (gouge.of == Part::link) return fmt::format("the link behind pass {}", *gouge.pass + 1);
  return gouge.of == Part::approach ? "the way to the first pass" : "the way back";
}

std::string place_text(const gouging::Vector& place) {
  return fmt::format("X{:.4f} Y{:.4f} Z{:.4f}", place[0], place[1], place[2]);
}

base::Place place_of(const GougeVerdict& verdict, base::Line line, const std::string& program) {
  const auto file = static_cast<std::size_t>(base::file(line));
  return {.file = file < verdict.files.size() ? verdict.files[file] : program, .line = base::number(line)};
}

base::Diagnostic diagnostic_of(const Gouge& gouge, double tolerance) {
  return {base::Severity::error,
          "gouge",
          fmt::format("the {} is {:.4f} mm inside surface {} at u {:.6g}, v {:.6g} ({}) on {}", name_of(gouge.part),
                      gouge.depth, gouge.surface, gouge.u, gouge.v, place_text(gouge.place), motion_text(gouge)),
          fmt::format("no more than {:g} mm: {}", tolerance,
                      gouge.part == gouging::Part::Kind::cutter
                          ? "a smaller tool, another lead or tilt, or a smaller range"
                          : "a longer tool, another lead or tilt, or a slimmer holder"),
          {},
          {}};
}

base::Diagnostic diagnostic_of(const LocalClearance& local) {
  return {base::Severity::error,
          "gouge-contact",
          fmt::format("the tool gouges beside its contact with surface {} at u {:.6g}, v {:.6g} ({}) on pass {}: the "
                      "surface bends by {:.3g} / mm more than the tool",
                      local.surface, local.u, local.v, place_text(local.place), local.pass + 1, -local.clearance),
          "a smaller tool, another lead or tilt, or a range without the place",
          {},
          {}};
}

void add_of_all(const GougeVerdict& verdict, const std::string& program, Diagnostics& all) {
  const auto add = [&](base::Severity severity, std::string_view code, std::string message, std::string hint) {
    all.push_back({severity, code, std::move(message), std::move(hint), {.file = program}, {}});
  };
  if (!verdict.fits) {
    add(base::Severity::error, "gouge-too-large", "the surfaces are more than are looked at for gouging",
        "no more than 1000 that differ, of 125 000 spans together");
  } else if (verdict.sag > verdict.tolerance / 4) {
    add(base::Severity::note, "gouge-coarse",
        fmt::format("the surfaces are looked at as {} triangles, no more than {:.3g} mm from them; what is found is "
                    "refined",
                    verdict.triangles, verdict.sag),
        "--gouge-tolerance MM, a greater one, makes them fit");
  }
  if (verdict.moves_unknown > 0) {
    add(base::Severity::warning, "gouge-no-shape",
        fmt::format("{} moves were not looked at: no shape is told of their tool", verdict.moves_unknown),
        "D and R in the tool table, and T and M6 in the program");
  }
}

template <std::size_t n>
Json list_of(const std::array<double, n>& values) {
  Json list = Json::list();
  for (const double value : values) list.push_back(value);
  return list;
}

Json json_of(const Gouge& gouge) {
  Json json = Json::object({{"line", base::number(gouge.line)},
                            {"depth_mm", gouge.depth},
                            {"part", name_of(gouge.part)},
                            {"surface", gouge.surface},
                            {"u", gouge.u},
                            {"v", gouge.v},
                            {"place", list_of(gouge.place)},
                            {"tip", list_of(gouge.pose.tip)},
                            {"axis", list_of(gouge.pose.axis)}});
  if (gouge.pass) {
    json["of"] = name_of(gouge.of);
    json["pass"] = *gouge.pass + 1;
  }
  return json;
}

Json json_of(const LocalClearance& local) {
  return Json::object({{"line", base::number(local.line)},
                       {"clearance_per_mm", local.clearance},
                       {"surface", local.surface},
                       {"pass", local.pass + 1},
                       {"u", local.u},
                       {"v", local.v},
                       {"place", list_of(local.place)}});
}

template <typename Found>
Json list_of(const std::map<base::Line, Found>& all) {
  Json list = Json::list();
  for (const auto& [line, found] : all) list.push_back(json_of(found));
  return list;
}

}  // namespace

Diagnostics gouging_diagnostics(const GougeVerdict& verdict, const std::string& program) {
  std::map<base::Line, Diagnostics> by_block;
  for (const auto& [line, local] : verdict.local) by_block[line].push_back(diagnostic_of(local));
  for (const auto& [line, gouge] : verdict.gouges) by_block[line].push_back(diagnostic_of(gouge, verdict.tolerance));
  Diagnostics all;
  add_of_all(verdict, program, all);
  for (auto& [line, found] : by_block) {
    for (base::Diagnostic& diagnostic : found) {
      diagnostic.place = place_of(verdict, line, program);
      all.push_back(std::move(diagnostic));
    }
  }
  return all;
}

Json json_of_gouging(const GougeVerdict& verdict) {
  return Json::object({{"gouges", verdict.gouged()},
                       {"tolerance_mm", verdict.tolerance},
                       {"surfaces", verdict.surfaces},
                       {"triangles", verdict.triangles},
                       {"sag_mm", verdict.sag},
                       {"moves", verdict.moves},
                       {"moves_unknown", verdict.moves_unknown},
                       {"worst", verdict.worst ? json_of(*verdict.worst) : Json()},
                       {"least_clearance", verdict.least ? json_of(*verdict.least) : Json()},
                       {"blocks", list_of(verdict.gouges)},
                       {"contacts", list_of(verdict.local)}});
}

report::Gouging reported_gouging(const GougeVerdict& verdict, bool shows_tip) {
  const auto seen = [&](const gouging::Vector& place, const gouging::Vector& offset) {
    base::AxisVector result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = place[k] + (shows_tip ? 0 : offset[k]);
    return result;
  };
  report::Gouging reported{.is_known = verdict.fits, .tolerance_mm = verdict.tolerance};
  // Of each block, passes and links and ways apart, the deepest.
  using Part = gcode::MachinedMove::Part;
  std::map<std::pair<base::Line, Part>, report::Gouge> deepest;
  for (const auto& [key, gouge] : verdict.gouges_of_passes) {
    report::Gouge& kept = deepest[{std::get<base::Line>(key), gouge.pass ? gouge.of : Part::pass}];
    const std::int64_t count = kept.count + 1;
    reported.places.push_back(seen(gouge.place, gouge.offset));
    if (!kept.depth_mm || gouge.depth > *kept.depth_mm) {
      kept = {.line = gouge.line,
              .depth_mm = gouge.depth,
              .part = std::string(name_of(gouge.part)),
              .motion = motion_text(gouge),
              .surface = gouge.surface,
              .u = gouge.u,
              .v = gouge.v,
              .place = seen(gouge.place, gouge.offset)};
    }
    kept.count = count;
  }
  for (auto& [key, gouge] : deepest) reported.blocks.push_back(std::move(gouge));
  std::stable_sort(reported.blocks.begin(), reported.blocks.end(),
                   [](const report::Gouge& a, const report::Gouge& b) { return *a.depth_mm > *b.depth_mm; });
  for (const auto& [line, local] : verdict.local) {
    reported.blocks.push_back({.line = line,
                               .bends_by = -local.clearance,
                               .motion = fmt::format("pass {}", local.pass + 1),
                               .surface = local.surface,
                               .u = local.u,
                               .v = local.v,
                               .place = seen(local.place, local.offset)});
  }
  return reported;
}

std::string gouging_text(const GougeVerdict& verdict, const Style& style) {
  if (!verdict.fits) return style(Tone::error, "not looked at");
  if (verdict.surfaces == 0) return "no surface is machined";
  const std::string looked = fmt::format("{} moves against {} surface{} as {} triangles", verdict.moves,
                                         verdict.surfaces, verdict.surfaces == 1 ? "" : "s", verdict.triangles);
  if (!verdict.gouged()) {
    return style(Tone::good, "none") + fmt::format(" beyond {:g} mm: {}", verdict.tolerance, looked);
  }
  std::string text = style(Tone::error, "the tool gouges");
  if (verdict.worst && verdict.worst->depth > verdict.tolerance)
    text += fmt::format(" {:.4f} mm deep", verdict.worst->depth);
  if (!verdict.local.empty()) text += " beside its contact";
  return text + ": " + looked;
}

}  // namespace leadscrew::results
