#include <algorithm>
#include <charconv>
#include <cmath>
#include <leadscrew/gcode/probe_contact.hpp>
#include <leadscrew/gcode/probing.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr int contact_number = 5061;  // first of nine: axes X Y Z A B C U V W
constexpr int found_number = 5070;
constexpr int mach3_contact_number = 2000;  // first of nine

// As the log of probed points has them (LinuxCNC manual, "Probe Logging").
std::string text_of_point(const base::AxisVector& point) {
  std::string text;
  for (const double value : point) {
    char digits[400];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 6).ptr;
    text.append(text.empty() ? "" : " ").append(digits, end);
  }
  return text;
}

}  // namespace

// grbl checks the state at the start, and where the move leads, of all four (grbl, "gc_execute_line", "mc_probe_cycle").
void Probing::probe(const Block& block) {
  const Code code = modal_.to_do;
  const bool must_find = code == Code::G38_2 || code == Code::G38_4;
  const bool strict = must_find || options_.dialect == Dialect::grbl;
  search(block, {code == Code::G38_2 || code == Code::G38_3, must_find, !strict, !strict, motion_column(block)});
}

// Its P says which of several signals ends it (Fanuc, "Multi-step skip"): here all are the one probe's.
void Probing::skip(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  const bool is_mach3 = options_.dialect == Dialect::mach3;
  const double signal = block.value_or('P', 1);
  if (signal != 1 && signal != 2 && signal != 3 && signal != 4)
    error("bad-value", block.column_of('P'), "the skip signal is " + text(signal), "P1 to P4");
  search(block, {true, false, !is_mach3, !is_mach3, column});
}

void Probing::search(const Block& block, const Search& search) {
  made_ = false;
  const base::AxisVector target = motion_.target_of(block);
  Feed feed;
  motion_.feed_of(block, motion_.is_linear(target), block.has('F'), feed);
  if (!travel_.inside_travel(block, target) || !allows(target, search)) {
    frame_.position = target;
    return;
  }
  search_ = search;
  way_ = numeric::difference(target, frame_.position);
  made_ = true;
  const bool is_simulated = machine_.probe && options_.probing != ProbingMoves::real;
  if (!is_simulated) note_missing_probe();
  if (is_simulated) check_state(is_in_contact() == search.contact);
  const Probed result = is_simulated ? simulated(target) : Probed{true, false, target, target};
  move_to(target, result, feed);
  settle(result);
  if (options_.probing != ProbingMoves::real) log(result);
}

bool Probing::allows(const base::AxisVector& target, const Search& search) {
  if (frame_.tip_control()) {
    return error("tip-control", search.column, "a probing move while tool centre point control is on", "G49 before it");
  }
  if (modal_.feed_mode == FeedMode::per_revolution)
    return error("bad-probe", search.column, "a probing move at a feed per revolution", "give G94 and F");
  if (target == frame_.position && !search.may_stand) {
    return error("bad-probe", search.column, "a probing move leads where the tool stands",
                 "give a point behind the surface that is looked for");
  }
  return true;
}

void Probing::check_state(bool is_there) {
  if (!is_there || search_.may_be_there) return;
  error("probe-state", search_.column,
        search_.contact ? "the probe is in contact before it moves" : "the probe is not in contact before it moves",
        search_.contact ? "lift it off first, with G38.4 or G0" : "G38.2 to contact first");
}

bool Probing::is_in_contact() const {
  return !is_released() && ProbeContact(*machine_.probe, frame_.tool()).touches(frame_.position);
}

Probed Probing::simulated(const base::AxisVector& target) {
  const base::AxisVector& start = frame_.position;
  if (is_in_contact() == search_.contact) return {true, true, start, start};
  const ProbeContact probe(*machine_.probe, frame_.tool());
  const std::optional<base::AxisVector> place =
      search_.contact ? probe.contact(start, target, is_released() ? released_->way : base::AxisVector{})
                      : probe.loss(start, target);
  return place ? Probed{true, false, *place, *place} : Probed{false, false, target, target};
}

void Probing::move_to(const base::AxisVector& target, const Probed& result, Feed feed) {
  const bool whole = options_.probing != ProbingMoves::simulated;
  const base::AxisVector end = whole ? target : result.rest;
  if (end == frame_.position) return;
  Move& line = outbox_.emit(Move::Kind::line);
  line.end = end;
  line.probes = search_.contact ? ProbeSearch::contact : ProbeSearch::loss;
  // The duration that G93 gives is that of the whole move.
  if (feed.mode == Feed::Mode::per_second && !whole) {
    std::size_t longest = 0;
    for (std::size_t i = 0; i < base::axis_count; ++i) {
      if (std::abs(target[i] - line.start[i]) > std::abs(target[longest] - line.start[longest])) longest = i;
    }
    feed.value *= (target[longest] - line.start[longest]) / (end[longest] - line.start[longest]);
  }
  line.feed = feed;
}

// What the program learns of it.
void Probing::settle(const Probed& result) {
  frame_.position = result.rest;
  if (!result.found || search_.contact) {
    released_.reset();
  } else if (!is_released()) {
    released_ = {result.rest, way_};
  }
  const base::AxisVector point = in_program(result);
  parameters_.set_axes(contact_number, point);
  parameters_.set(found_number, result.found ? 1 : 0);
  if (options_.dialect == Dialect::mach3) parameters_.set_axes(mach3_contact_number, point);
  if (!result.found && search_.must_find) {
    error("probe-failed", search_.column,
          search_.contact ? "the probe has touched nothing up to the point programmed"
                          : "the probe is still in contact at the point programmed",
          "give a point further on, or G38.3 and G38.5, which leave it to #5070");
  }
}

void Probing::log(const Probed& result) const {
  if (!result.found || !options_.remarks) return;
  const base::Place place{reporter_.file(), base::number(reporter_.line()), search_.column};
  options_.remarks({Remark::Kind::probe_point, text_of_point(in_program(result)), place});
}

base::AxisVector Probing::in_program(const Probed& result) const {
  base::AxisVector point = frame_.to_program(result.at);
  for (const base::Axis axis : base::all_axes) point[base::index(axis)] /= frame_.unit(axis);
  return point;
}

void Probing::probed(const Probed& result) {
  if (!std::exchange(made_, false)) return;
  check_state(result.found && result.at_once);
  settle(result);
  log(result);
}

void Probing::note_missing_probe() {
  if (options_.probing == ProbingMoves::real || std::exchange(told_of_probe_, true)) return;
  reporter_.report(base::Severity::note, "probe-not-simulated",
                   {reporter_.file(), base::number(reporter_.line()), search_.column},
                   "no probe is simulated: probing moves are taken to touch at the point programmed",
                   "[probe] plane_mm = {Z = -3} in the machine file simulates one");
}

}  // namespace leadscrew::gcode
