#include <fmt/format.h>

#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/program_text.hpp>
#include <leadscrew/results/simulation.hpp>

namespace leadscrew::results {

namespace {

Json json_of_cut(const AdaptiveFigures& adaptive, double time) {
  const servo::CutFigures& cut = adaptive.cut;
  return Json::object(
      {{"force_limit_n", adaptive.limit},
       {"mean_force_max_n", cut.greatest_mean},
       {"longest_excess_s", cut.longest_excess},
       {"longest_excess_turns", cut.longest_excess / adaptive.turn},
       {"held", cut.held(adaptive.turn)},
       {"unreachable_s", cut.unreachable},
       {"override",
        Json::object({{"min", cut.least_override}, {"mean", cut.mean_override}, {"max", cut.greatest_override}})},
       {"safe_factor", adaptive.safe},
       {"safe_time_s", adaptive.safe_time},
       {"time_saved_s", adaptive.safe_time - time},
       {"sensor_failure", servo::name(adaptive.failure)},
       {"failed_at_s", cut.failed_at}});
}

std::string force_text(const AdaptiveFigures& adaptive, const Style& style) {
  const servo::CutFigures& cut = adaptive.cut;
  const std::string excess = fmt::format("beyond 1.25 times it for {:.0f} ms ({:.1f} turns) at a stretch",
                                         cut.longest_excess * 1000, cut.longest_excess / adaptive.turn);
  return fmt::format("limit {:.4g} N, mean over a turn up to {:.4g} N, {}", adaptive.limit, cut.greatest_mean,
                     cut.held(adaptive.turn) ? excess : style(Tone::error, excess));
}

std::string override_text(const AdaptiveFigures& adaptive, double time) {
  const servo::CutFigures& cut = adaptive.cut;
  return fmt::format(
      "{:.0f} to {:.0f} %, {:.0f} % on average; at {:.0f} % throughout it would take {:.4g} s, {:+.4g} s",
      cut.least_override * 100, cut.greatest_override * 100, cut.mean_override * 100, adaptive.safe * 100,
      adaptive.safe_time, adaptive.safe_time - time);
}

std::string sensor_text(const AdaptiveFigures& adaptive, const Style& style) {
  if (!adaptive.cut.failed_at) return "believed throughout";
  return style(Tone::warning, fmt::format("{}: not believed from {:.3f} s on; programmed feed times {:g} from there",
                                          servo::name(adaptive.failure), *adaptive.cut.failed_at, adaptive.safe));
}

std::string feed_text(const SimulateFigures& figures) {
  const servo::FeedTracking& feed = figures.feed;
  return fmt::format("measured up to {:.6g} mm/min, {:.6g} on average; words up to {:.6g}", feed.measured_max * 60,
                     feed.measured_mean * 60, feed.commanded_max * 60);
}

std::string contour_text(const drive::ContourFigures& contour) {
  const std::string text =
      fmt::format("{} the path of the words by {:.4g} mm at t = {:.4g} s, rms {:.4g} mm",
                  contour.orientation ? "the tip leaves" : "slides leave", contour.greatest, contour.at, contour.rms);
  return contour.orientation ? text + fmt::format("; the tool its direction by {:.3g}°", *contour.orientation) : text;
}

std::string time_text(const SimulateFigures& figures) {
  const std::string rest =
      figures.settling ? fmt::format("slides at rest {:.4g} s later", *figures.settling) : "slides do not come to rest";
  return fmt::format("{:.4f} s; {}", figures.summary.time_s, rest);
}

std::string pulse_row(base::Axis axis, const drive::PulseCounts& counts) {
  return row("pulses", fmt::format("{}: {} commanded, {} net; {} of the encoder, {} net; {} overflows, {} lost",
                                   base::letter(axis), counts.commanded_gross, counts.commanded, counts.encoder_gross,
                                   counts.encoder, counts.overflows, counts.lost));
}

std::string verdict_text(const SimulateFigures& figures, const Style& style) {
  std::vector<std::string_view> wrong;
  if (!figures.within_tolerance()) wrong.push_back("the slides leave the tolerance");
  if (!figures.settling) wrong.push_back("the slides do not come to rest");
  if (!figures.kept_pulses()) wrong.push_back("counters had no room for all pulses");
  if (!figures.held_force()) wrong.push_back("the force is beyond its limit for too long");
  if (!wrong.empty()) return style(Tone::error, fmt::format("NOT kept: {}", fmt::join(wrong, "; ")));
  return style(Tone::good, fmt::format("kept: the slides stay within the tolerance, and come to rest{}",
                                       figures.adaptive ? "; the force is held" : ""));
}

}  // namespace

Json json_of_axes(const drive::TrackedAxes& axes) {
  Json list = Json::list();
  for (const auto& [axis, tracking] : axes) {
    const std::string unit = base::is_rotary(axis) ? "deg" : "mm";
    list.push_back(Json::object({{"name", std::string(1, base::letter(axis))},
                                 {"following_max_" + unit, tracking.greatest},
                                 {"following_rms_" + unit, tracking.rms},
                                 {"overshoot_" + unit, tracking.overshoot}}));
  }
  return list;
}

std::string axis_rows(const drive::TrackedAxes& axes, const Style& style) {
  std::string text = style(Tone::faint, "  axis   lags at most        rms    overshoots") + "\n";
  for (const auto& [axis, tracking] : axes) {
    const char* unit = base::is_rotary(axis) ? "deg" : "mm";
    text += fmt::format("  {:<4} {:>11.4g} {:<3} {:>9.4g} {:>13.4g}\n", base::letter(axis), tracking.greatest, unit,
                        tracking.rms, tracking.overshoot);
  }
  return text;
}

Json json_of_simulation(const std::string& program, const machine::Machine& machine, const SimulateFigures& figures,
                        const Diagnostics& diagnostics) {
  const pipeline::Summary& summary = figures.summary;
  const servo::FeedTracking& feed = figures.feed;
  Json json = json_of_motion(simulate_schema, program, machine, summary,
                             {{"settling_s", figures.settling},
                              {"deviation_mm", figures.verdict.deviation_mm},
                              {"tolerance_mm", figures.tolerance},
                              {"end_error_mm", figures.verdict.end_error_mm},
                              {"contour", Json::object({{"max_mm", figures.contour.greatest},
                                                        {"rms_mm", figures.contour.rms},
                                                        {"max_at_s", figures.contour.at},
                                                        {"orientation_max_deg", figures.contour.orientation}})},
                              {"feed", Json::object({{"programmed_max_mm_s", summary.feed_programmed_max},
                                                     {"commanded_max_mm_s", feed.commanded_max},
                                                     {"measured_max_mm_s", feed.measured_max},
                                                     {"measured_mean_mm_s", feed.measured_mean}})},
                              {"axes", json_of_axes(figures.axes)},
                              {"diagnostics", json_of_diagnostics(diagnostics)}});
  add_tip(json, figures.verdict);
  for (const auto& [axis, counts] : figures.pulses) {
    json["pulses"].push_back(Json::object({{"name", std::string(1, base::letter(axis))},
                                           {"commanded", counts.commanded},
                                           {"commanded_gross", counts.commanded_gross},
                                           {"encoder", counts.encoder},
                                           {"encoder_gross", counts.encoder_gross},
                                           {"overflows", counts.overflows},
                                           {"lost", counts.lost}}));
  }
  if (figures.adaptive) json["adaptive"] = json_of_cut(*figures.adaptive, summary.time_s);
  return json;
}

std::string simulate_summary(const std::string& program, const machine::Machine& machine,
                             const SimulateFigures& figures, const Style& style) {
  const pipeline::Summary& summary = figures.summary;
  std::string text = heading(program, machine.name, machine.period, style);
  text += row("time", time_text(figures));
  text += row("length", fmt::format("{:.3f} mm, {} blocks", summary.length_mm, summary.blocks));
  text += row("feed", feed_text(figures));
  text += row("contour", contour_text(figures.contour));
  text += row("deviation", deviation_text(figures.verdict.deviation_mm, figures.tolerance));
  text += tip_row(figures.verdict);
  text += axis_rows(figures.axes, style);
  for (const auto& [axis, counts] : figures.pulses) text += pulse_row(axis, counts);
  if (figures.adaptive) {
    text += row("force", force_text(*figures.adaptive, style));
    text += row("override", override_text(*figures.adaptive, summary.time_s));
    text += row("sensor", sensor_text(*figures.adaptive, style));
  }
  text += "  " + verdict_text(figures, style) + "\n";
  for (const std::string& file : figures.files) text += row("wrote", printable(file));
  return text;
}

}  // namespace leadscrew::results
