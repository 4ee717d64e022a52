#include <algorithm>
#include <leadscrew/gcode/surface_blocks.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr int highest_surface_order = surfaces::highest_degree + 1;
constexpr char knot_letters[2] = {'K', 'L'};
constexpr const char* direction_names[2] = {"u", "v"};

}  // namespace

/// 0, and an error, where it is no integer between these.
int SurfaceBlocks::count_of(const Block& block, char letter, int least, int most) {
  const std::optional<int> count = as_integer(block.value_or(letter, 0));
  if (count && least <= *count && *count <= most) return *count;
  if (block.has(letter)) {
    error("surface-counts", block.column_of(letter), std::string(1, letter) + " is " + text(block[letter]),
          letter == 'D' ? "the number of a surface is an integer above 0"
          : most <= 6   ? "an order is the degree and one, 2 to 6"
                        : "as many points as the order or more, at most " + std::to_string(most));
  }
  reporter_.fail();
  return 0;
}

void SurfaceBlocks::begin(const Block& block) {
  constexpr int most = static_cast<int>(surfaces::most_control_points);
  auto draft = std::make_unique<Draft>();
  draft->place = reporter_.place(block.column_of(Group::nonmodal));
  draft->number = count_of(block, 'D', 1, 1'000'000);
  surfaces::SurfaceForm& form = draft->form;
  for (std::size_t d = 0; d < 2; ++d) {
    const int order = count_of(block, d == 0 ? 'P' : 'Q', 2, highest_surface_order);
    form.degree[d] = order - 1;
    form.count[d] = static_cast<std::size_t>(count_of(block, d == 0 ? 'I' : 'J', std::max(order, 2), most));
  }
  const std::size_t points = form.count[0] * form.count[1];
  if (!reporter_.failed() && points > surfaces::most_control_points) {
    error("surface-counts", block.column_of('I'), "the surface has " + std::to_string(points) + " points",
          "at most " + std::to_string(most) + " of one surface");
  }
  // Where it is not known how many points follow, all that do are taken.
  draft->spoiled = reporter_.failed();
  draft_ = std::move(draft);
  modal_.is_plain = false;
}

bool SurfaceBlocks::problem(std::string_view code, std::uint32_t column, std::string message, std::string hint) {
  if (std::exchange(draft_->spoiled, true)) return reporter_.fail();
  return error(code, column, std::move(message), std::move(hint));
}

bool SurfaceBlocks::add(const Block& block) {
  constexpr std::uint32_t number = letter_bit('N');
  constexpr std::uint32_t point =
      letter_bit('X') | letter_bit('Y') | letter_bit('Z') | letter_bit('R') | letter_bit('K') | letter_bit('L');
  if (reporter_.failed()) draft_->spoiled = true;
  const bool is_point = block.groups == 0 && (block.words & point) && !(block.words & ~(point | number));
  if (!is_point && block.groups == 0 && !(block.words & ~number)) return true;
  if (!is_point) {
    const std::unique_ptr<Draft> draft = std::exchange(draft_, nullptr);
    surfaces_[draft->number] = nullptr;
    if (draft->spoiled) return false;
    error("unfinished-surface", block.first_column,
          "surface " + std::to_string(draft->number) + " of line " + std::to_string(base::number(draft->place.line)) +
              " has " + std::to_string(draft->form.net.size()) + " points, and needs " +
              std::to_string(draft->form.count[0] * draft->form.count[1]),
          "between G6.4 and its last point there are only points: X Y Z, the weight R, the knots K and L");
    return false;
  }
  add_point(block);
  for (std::size_t d = 0; d < 2; ++d) add_knot(block, knot_letters[d], d);
  if (reporter_.failed()) draft_->spoiled = true;
  const std::size_t all = draft_->form.count[0] * draft_->form.count[1];
  if (all > 0 && draft_->lines.size() == all) finish(block);
  return true;
}

void SurfaceBlocks::add_point(const Block& block) {
  Draft& draft = *draft_;
  // Of a surface that is spoiled, points are counted and no more.
  if (draft.lines.size() < surfaces::most_control_points) draft.lines.push_back(modal_.line);
  if (draft.spoiled) return;
  surfaces::NetPoint point;
  if (!draft.form.net.empty()) point.position = draft.form.net.back().position;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = static_cast<char>('X' + i);
    if (block.has(letter)) {
      const double half = letter == 'X' && modal_.diameters ? 0.5 : 1;
      point.position[i] = half * block[letter] * frame_.length_unit;
    } else if (draft.form.net.empty()) {
      problem("missing-word", block.first_column, "the first point of a surface lacks " + std::string(1, letter),
              "X, Y and Z; in the points behind it those that are not given keep their value");
    }
  }
  point.weight = block.value_or('R', 1);
  if (!(point.weight > 0)) {
    problem("surface-weight", block.column_of('R'), "the weight of the point is " + text(point.weight),
            "R must be above 0");
  }
  draft.form.net.push_back(point);
}

// They stand in the first blocks without a gap.
void SurfaceBlocks::add_knot(const Block& block, char letter, std::size_t direction) {
  Draft& draft = *draft_;
  if (draft.spoiled) return;
  std::vector<double>& knots = draft.form.knots[direction];
  const std::size_t wanted = draft.form.count[direction] + static_cast<std::size_t>(draft.form.degree[direction]) + 1;
  const std::size_t before = draft.form.net.size() - 1;
  const bool is_wanted = before < wanted && (before == 0 || !knots.empty());
  if (!block.has(letter)) {
    if (before > 0 && is_wanted) {
      problem(
          "surface-knots", block.first_column,
          "the point lacks " + std::string(1, letter) + ": there are " + std::to_string(knots.size()) + " of " +
              std::to_string(wanted) + " knots of " + direction_names[direction],
          std::string(1, letter) + " in each of the first blocks, as many as points and order together, or in none");
    }
    return;
  }
  if (!is_wanted) {
    problem("surface-knots", block.column_of(letter),
            std::string("this is no place of a knot of ") + direction_names[direction],
            std::string(1, letter) + " in each of the first " + std::to_string(wanted) + " blocks, or in none");
    return;
  }
  knots.push_back(block[letter]);
  check_knots(block, direction);
}

/// Of the last one.
bool SurfaceBlocks::check_knots(const Block& block, std::size_t direction) {
  const std::vector<double>& knots = draft_->form.knots[direction];
  const auto p = static_cast<std::size_t>(draft_->form.degree[direction]);
  const std::size_t last = knots.size() - 1, end = draft_->form.count[direction] + p;
  const std::uint32_t column = block.column_of(knot_letters[direction]);
  const std::string which = std::string("the knot ") + text(knots[last]) + " of " + direction_names[direction];
  if (last > 0 && knots[last] < knots[last - 1])
    return problem("surface-knots", column, which + " follows " + text(knots[last - 1]), "knots do not decrease");
  const bool is_loose =
      (0 < last && last <= p && knots[last] != knots[0]) || (last > end - p && knots[last] != knots[end - p]);
  if (is_loose) {
    return problem("surface-knots", column, which + " is one of an end, and differs from " + text(knots[last - 1]),
                   "the first knots are equal, as many as the order, and so are the last");
  }
  const bool is_inside = p < last && last < end - p;
  if ((is_inside && knots[last] == knots[last - p]) || (last == end - p && knots[last] == knots[0]) ||
      (last == end - p && last > p + 1 && knots[last] == knots[last - 1])) {
    return problem("surface-knots", column, which + " stands too often",
                   "between the ends at most once less than the order, and less than the last");
  }
  return true;
}

void SurfaceBlocks::finish(const Block& block) {
  const std::unique_ptr<Draft> finished = std::exchange(draft_, nullptr);
  surfaces::SurfaceForm& form = finished->form;
  auto& held = surfaces_[finished->number];
  if (held) points_ -= held->net.size();
  held = nullptr;
  if (finished->spoiled || reporter_.failed()) {
    reporter_.fail();
    return;
  }
  for (std::size_t d = 0; d < 2; ++d) {
    if (form.knots[d].empty()) form.knots[d] = surfaces::uniform_knots(form.count[d], form.degree[d]);
  }
  if (const auto fault = surfaces::fault_of(form)) return report(*finished, *fault);
  points_ += form.net.size();
  held = std::make_shared<const surfaces::SurfaceForm>(std::move(form));
  if (points_ <= most_points) return;
  error("surface-counts", block.first_column, "the surfaces of the program have more than a million points together",
        "define a number again, which replaces what it was");
}

/// What only all points together show.
void SurfaceBlocks::report(const Draft& draft, const surfaces::SurfaceFault& fault) {
  using Kind = surfaces::SurfaceFault::Kind;
  const std::string surface = "surface " + std::to_string(draft.number);
  const auto d = static_cast<std::size_t>(fault.direction);
  if (fault.kind == Kind::rows) {
    const std::size_t first = d == 0 ? fault.index : fault.index * draft.form.count[0];
    const AtKeptPlace there(reporter_, {draft.lines[first], 1, {}});
    error("surface-rows", 1,
          "row " + std::to_string(fault.index + 1) + " of " + surface + " along " + direction_names[1 - d] +
              " coincides with the one before",
          "each row of points lies elsewhere");
  } else {
    const AtKeptPlace there(reporter_, draft.place);
    if (fault.kind == Kind::normal) {
      error("surface-normal", draft.place.column,
            "at u " + text(fault.u) + ", v " + text(fault.v) + " " + surface + " has no normal",
            "no side of it is a point, and it has no fold");
    } else {
      error("surface-knots", draft.place.column, surface + " has knots that are none", "they do not decrease");
    }
  }
  reporter_.fail();
}

void SurfaceBlocks::end() {
  if (!draft_) return;
  const std::unique_ptr<Draft> draft = std::exchange(draft_, nullptr);
  if (draft->spoiled) return;
  const AtKeptPlace there(reporter_, draft->place);
  error("unfinished-surface", draft->place.column,
        "the text ends before surface " + std::to_string(draft->number) + " has all of its points",
        "as many blocks of X Y Z as I times J");
}

std::shared_ptr<const surfaces::SurfaceForm> SurfaceBlocks::find(int number) const {
  const auto found = surfaces_.find(number);
  return found == surfaces_.end() ? nullptr : found->second;
}

std::vector<std::shared_ptr<const surfaces::SurfaceForm>> SurfaceBlocks::all() const {
  std::vector<std::shared_ptr<const surfaces::SurfaceForm>> forms;
  for (const auto& [number, form] : surfaces_) {
    if (form != nullptr) forms.push_back(form);
  }
  return forms;
}

}  // namespace leadscrew::gcode
