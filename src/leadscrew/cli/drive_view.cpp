#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/cli/drive_view.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/results/diagnostic_text.hpp>

namespace leadscrew::cli {

namespace {

constexpr int status_lines = 10, widest_map = 100, highest_map = 40;
constexpr std::int64_t between_pictures = 100'000'000;  // ns
constexpr std::string_view end = "\033[K\n";

/// As many lines as the terminal has, so that nothing scrolls.
std::string cut(std::string screen) {
  std::size_t at = 0;
  for (int lines = drive::Terminal::rows(); lines > 0; --lines) {
    at = screen.find('\n', at);
    if (at == std::string::npos) return screen;
    ++at;
  }
  screen.resize(at - 1);
  return screen;
}

/// As it was programmed, from its beginning.
gcode::Reader programmed(const files::InputFile& file, const Job& job) {
  gcode::ReaderOptions options = job.reader_options(file);
  options.repeats = true;
  options.path_mode = gcode::PathMode::exact_stop;
  return gcode::Reader(file.source(), job.machine, job.tools, options, nullptr);
}

}  // namespace

DriveView::DriveView(const termios& settings, const files::InputFile& file, const Job& job, const Style& style,
                     drive::Wishes& wishes, std::string served)
    : terminal_(settings),
      job_(job),
      program_(results::printable(file.name())),
      style_(style),
      poses_(job.machine),
      map_([&] { return programmed(file, job); }, std::min(drive::Terminal::columns() - 1, widest_map),
           std::min(drive::Terminal::rows() - status_lines, highest_map)),
      wishes_(wishes),
      served_(std::move(served)) {}

void DriveView::observe(const drive::Feedback& feedback) {
  last_ = feedback;
  poses_.hold(feedback.tool);
  const auto pose = poses_.of(feedback.actual);
  map_.visit(pose ? pose->tip : feedback.actual);
}

bool DriveView::go_on(const drive::WordMaker& maker, realtime::Runner& runner) {
  waits_for_input_ = maker.waits_for_input();
  const bool is_asked = obey_keys(runner);
  draw(runner);
  return is_asked;
}

bool DriveView::go_back(double seconds) {
  draw_return(seconds);
  return is_asked_to_stop();
}

bool DriveView::obey_keys(realtime::Runner& runner) {
  while (const auto key = drive::Terminal::key()) {
    if (*key == 'q') return true;
    if (*key == ' ' && !wishes_.held && wishes_.stand_at_pause(runner.counters(), last_.word)) {
      wishes_.pause.go_on();
      continue;
    }
    if (*key == ' ') wishes_.held = !wishes_.held;
    if (*key == '+') wishes_.change_factor(1);
    if (*key == '-') wishes_.change_factor(-1);
    wishes_.tell(runner);
  }
  return false;
}

std::string DriveView::wait_text(const realtime::Counters& counters) const {
  const drive::HoldState hold = wishes_.hold_state(counters, last_.word);
  if (hold != drive::HoldState::none)
    return style_(Tone::warning, hold == drive::HoldState::waits    ? "  hold waits (in step)"
                                 : hold == drive::HoldState::obeyed ? "  HELD"
                                                                    : "  hold not obeyed (M53 P0)");
  if (waits_for_input_) return style_(Tone::warning, "  WAITS for an input (M66)");
  if (!wishes_.stand_at_pause(counters, last_.word)) return {};
  return style_(Tone::warning, fmt::format("  PAUSED in line {}: space goes on", base::number(*wishes_.pause.line())));
}

bool DriveView::is_asked_to_stop() {
  bool asked = false;
  while (const auto key = drive::Terminal::key()) asked = asked || *key == 'q';
  return asked;
}

std::string DriveView::place_text() const {
  std::string text = fmt::format("{}  line {}{}", style_(Tone::strong, program_), base::number(last_.word.line), end);
  for (const base::Axis axis : base::all_axes) {
    if (!job_.machine.has(axis)) continue;
    text += fmt::format("{} {:10.4f}  ", base::letter(axis), last_.actual[base::index(axis)]);
  }
  text.append(end);
  if (const auto pose = poses_.of(last_.actual)) {
    text += fmt::format("tip {:10.4f} {:10.4f} {:10.4f}  tool {:8.5f} {:8.5f} {:8.5f}{}", pose->tip[0], pose->tip[1],
                        pose->tip[2], pose->direction[0], pose->direction[1], pose->direction[2], end);
  }
  return text;
}

std::string DriveView::status_text(const realtime::Runner& runner) const {
  const realtime::Counters counters = runner.counters();
  const auto micro = [&](double part) { return static_cast<double>(runner.latencies().percentile(part)) / 1e3; };
  std::string text = place_text();
  text += fmt::format("feed {:8.1f} /min  override {:3.0f} %{}{}{}", last_.word.feed * 60, wishes_.factor * 100,
                      wishes_.is_in_step(counters, last_.word) ? " not obeyed (in step)"
                      : counters.allowed_overrides.feed        ? ""
                                                               : " not obeyed (M49)",
                      wait_text(counters), end);
  if (!job_.arguments.drive.sink) {
    text += fmt::format("slides {:6.1f} /min by tachometers, behind by {:.4f}{}", last_.measured_feed * 60,
                        last_.following_error, end);
  }
  text += fmt::format("look-ahead {:5.0f} ms  planner late {}  {:.1f} s, {:.1f} mm{}", counters.seconds_ahead * 1e3,
                      counters.starvations, static_cast<double>(counters.words) * job_.machine.period.seconds(),
                      last_.word.path_length, end);
  text += fmt::format("latency 50 % {:.0f} us, 99 % {:.0f} us, at most {:.0f} us; overruns {}{}", micro(0.5),
                      micro(0.99), micro(1), counters.overruns, end);
  if (!served_.empty()) text += served_ + std::string(end);
  return text + style_(Tone::faint, "space hold/resume   + - feed   q stop").append(end);
}

bool DriveView::is_due() {
  const std::int64_t now = realtime::now();
  if (now - drawn_ < between_pictures) return false;
  drawn_ = now;
  return true;
}

std::string DriveView::map_text() const {
  return map_.text([&](bool visited, std::string_view text) {
    return style_(visited ? Tone::good : Tone::faint, std::string(text));
  });
}

void DriveView::draw(const realtime::Runner& runner) {
  if (is_due()) drive::Terminal::draw("\033[H" + cut(status_text(runner) + map_text()) + "\033[J");
}

void DriveView::draw_return(double seconds) {
  if (!is_due()) return;
  drive::Terminal::draw(fmt::format("\033[H{}back along the path to where motion goes on, {:.1f} s{}{}{}{}\033[J",
                                    place_text(), seconds, end, style_(Tone::faint, "q stop"), end, map_text()));
}

}  // namespace leadscrew::cli
