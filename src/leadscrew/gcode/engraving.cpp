#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/engraving.hpp>
#include <leadscrew/gcode/stroke_font.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double mm_of_default_height = 25.4;

}  // namespace

bool Engraving::check(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  if (!block.has('P')) return reporter_.fail();
  if (modal_.plane != Plane::XY)
    return error("bad-plane", column, "G47 outside the plane of X and Y", "give G17 before");
  if (modal_.feed_mode == FeedMode::inverse_time) return error("bad-feed-mode", column, "G47 in G93", "give G94");
  for (const base::Axis axis : base::all_axes) {
    const bool linear = axis == base::Axis::X || axis == base::Axis::Y || axis == base::Axis::Z;
    if (linear || !block.has(base::letter(axis))) continue;
    return error("unused-word", block.column_of(base::letter(axis)),
                 std::string("G47 does not move axis ") + base::letter(axis), "move it in a block before");
  }
  if (!block.has('Z')) return error("missing-word", column, "G47 lacks Z", "give how deep it engraves: Z-0.2");
  constexpr double most_turn = 360;
  if (std::fabs(block.value_or('I', 0)) > most_turn)
    return error("bad-value", block.column_of('I'), "G47 has I" + text(block['I']),
                 "an angle from -360 to 360 degrees");
  for (const char letter : {'J', 'E'}) {
    if (!block.has(letter) || block[letter] > 0) continue;
    return error("bad-value", block.column_of(letter), "G47 has " + std::string(1, letter) + text(block[letter]),
                 std::string(1, letter) + " must be above 0");
  }
  return true;
}

bool Engraving::plan(const Block& block, Plan& plan) {
  const base::AxisVector target = frame_.to_program(motion_.target_of(block));
  const base::AxisVector stands = frame_.to_program(frame_.position);
  const bool absolute = modal_.distance == Distance::absolute;
  const double unit = frame_.length_unit;
  plan.start = {target[0], target[1]};
  plan.top = block.has('R') ? block['R'] * unit + (absolute ? 0 : stands[2]) : stands[2];
  plan.bottom = absolute ? target[2] : plan.top + block['Z'] * unit;
  plan.height = block.has('J') ? block['J'] * unit : mm_of_default_height;
  plan.cosine = cosine_of_degrees(block.value_or('I', 0));
  plan.sine = sine_of_degrees(block.value_or('I', 0));
  if (plan.bottom > plan.top) {
    return error("cycle-levels", block.column_of('Z'),
                 "the bottom at " + text(plan.bottom) + " mm is above R at " + text(plan.top) + " mm",
                 "the bottom of the letters must not be above R");
  }
  if (!motion_.feed_of(block, true, block.has('F'), plan.feed)) return false;
  plan.plunge = plan.feed;
  if (block.has('E')) plan.plunge.value = block['E'] * unit / seconds_per_minute;
  return true;
}

// As many digits as there are signs #, of the parameter that counts.
bool Engraving::count(const Block& block, const std::string& remark, std::string& text) {
  const std::size_t digits = static_cast<std::size_t>(std::ranges::count(remark, '#'));
  const std::optional<int> number = as_integer(parameters_.get(counter).value_or(0));
  const std::string shown = number && *number >= 0 ? std::to_string(*number) : std::string();
  if (digits == 0 || digits != remark.size()) {
    return error("bad-text", block.column_of(Group::nonmodal), "G47 P1 has no place for a number", "G47 P1 (####)");
  }
  if (shown.empty() || shown.size() > digits) {
    return error("bad-text", block.column_of(Group::nonmodal),
                 "#599 is " + gcode::text(parameters_.get(counter).value_or(0)) + ", which is no number of " +
                     std::to_string(digits) + " digits",
                 "set #599 to the number that comes next");
  }
  text = std::string(digits - shown.size(), '0') + shown;
  parameters_.set(counter, *number + 1);
  return true;
}

bool Engraving::find_text(const Block& block, const std::string& remark, std::string& text) {
  const std::optional<int> kind = as_integer(block['P']);
  constexpr int least = 32, most = 126;
  if (kind == 1) return count(block, remark, text);
  text = remark;
  if (kind && least <= *kind && *kind <= most) text = std::string(1, static_cast<char>(*kind));
  if (kind != 0 && text == remark) {
    return error("bad-value", block.column_of('P'), "G47 has P" + gcode::text(block['P']),
                 "0 for the text of the remark, 1 for a number that counts, 32 to 126 for a character");
  }
  if (text.empty()) {
    return error("bad-text", block.column_of(Group::nonmodal), "G47 P0 has no text", "G47 P0 (TEXT)");
  }
  for (const char each : text) {
    if (strokes_of(each)) continue;
    return error("bad-text", block.column_of(Group::nonmodal), "the font has no " + shown(each),
                 "the characters of ASCII");
  }
  return true;
}

// Down where a stroke begins, along it, and up again.
void Engraving::cut(const Plan& plan, char character, std::size_t place) {
  const auto placed = [&](PlanePoint point) {
    const double x = plan.height * (point.first + static_cast<double>(place) * character_pitch),
                 y = plan.height * point.second;
    return PlanePoint{plan.start.first + plan.cosine * x - plan.sine * y,
                      plan.start.second + plan.sine * x + plan.cosine * y};
  };
  const std::vector<Stroke> strokes = strokes_of(character).value_or(std::vector<Stroke>());
  for (const Stroke& stroke : strokes) {
    cycle_.line(placed(stroke.start), Feed{});
    cycle_.level(plan.top, Feed{});
    cycle_.level(plan.bottom, plan.plunge);
    for (const Stroke::Step& step : stroke.steps) {
      if (step.turn == 0) {
        cycle_.line(placed(step.to), plan.feed);
      } else {
        cycle_.arc(placed(step.to), placed(step.center), step.turn, plan.feed);
      }
    }
    cycle_.level(plan.top, Feed{});
    if (cycle_.failed()) return;
  }
}

void Engraving::engrave(const Block& block, const std::string& remark) {
  Plan plan_of_text;
  std::string text;
  if (!check(block) || !plan(block, plan_of_text) || !find_text(block, remark, text)) return;
  cycle_.begin(block);
  if (cycle_.position()[2] < plan_of_text.top) cycle_.level(plan_of_text.top, Feed{});
  for (std::size_t i = 0; i < text.size() && !cycle_.failed(); ++i) cut(plan_of_text, text[i], i);
}

}  // namespace leadscrew::gcode
