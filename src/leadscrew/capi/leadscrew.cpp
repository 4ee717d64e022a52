#include "leadscrew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/host/motion.hpp>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

using namespace leadscrew;

struct leadscrew_machine {
  machine::Machine machine;
};

struct leadscrew_motion {
  std::unique_ptr<host::Motion> motion;
  bool is_busy = false;  ///< one of its functions is running
};

static_assert(LEADSCREW_AXES == base::axis_count);

namespace {

/// The structure as this version knows it; empty where its size is none that a version had.
template <class Struct>
std::optional<Struct> known(const Struct* given) {
  if (given == nullptr || given->size < sizeof(Struct)) return std::nullopt;
  return *given;
}

template <std::size_t size>
void copy_text(char (&to)[size], std::string_view from) {
  const std::size_t length = std::min(from.size(), size - 1);
  std::copy_n(from.data(), length, to);
  to[length] = '\0';
}

leadscrew_error error_of(const base::Diagnostic& diagnostic) {
  leadscrew_error error{};
  error.size = sizeof error;
  error.severity = static_cast<std::int32_t>(diagnostic.severity);
  error.line = diagnostic.place.line;
  error.column = diagnostic.place.column;
  copy_text(error.code, diagnostic.code);
  copy_text(error.message, diagnostic.message);
  copy_text(error.hint, diagnostic.hint);
  return error;
}

void tell(leadscrew_error* error, const base::Diagnostic& diagnostic) {
  if (!known(error)) return;
  const std::size_t size = error->size;
  *error = error_of(diagnostic);
  error->size = size;
}

int misuse(leadscrew_error* error, const char* message) {
  tell(error, base::problem("misuse", message, {}));
  return LEADSCREW_MISUSE;
}

/// Can memory hold so long a text?
bool is_text(const char* text, std::size_t length) {
  return text != nullptr && length <= std::string().max_size();
}

int rejected(leadscrew_error* error, const base::Diagnostic& diagnostic) {
  tell(error, diagnostic);
  return LEADSCREW_REJECTED;
}

int code_of(const base::Result<void>& result, leadscrew_error* error) {
  return result ? LEADSCREW_OK : rejected(error, result.error());
}

/// What `work` returns, unless there is no memory for it.
template <class Work>
int guarded(leadscrew_error* error, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    tell(error, base::problem("memory", "out of memory", {}));
    return LEADSCREW_OUT_OF_MEMORY;
  }
}

/// The same of a motion, while nobody else is in it.
template <class Work>
int within(leadscrew_motion* motion, leadscrew_error* error, const Work& work) {
  if (motion == nullptr) return misuse(error, "the motion is NULL");
  if (motion->is_busy) return misuse(error, "the motion is used from within its own functions");
  motion->is_busy = true;
  const int code = guarded(error, [&] { return work(*motion->motion); });
  motion->is_busy = false;
  return code;
}

base::AxisVector axes_of(const double (&from)[LEADSCREW_AXES]) {
  base::AxisVector position;
  std::copy(std::begin(from), std::end(from), position.begin());
  return position;
}

leadscrew_event event_of(const base::PassedEvent& from) {
  leadscrew_event event{};
  event.size = sizeof event;
  event.tick = base::count(from.tick);
  event.path_length = from.path_length;
  event.value = from.value;
  event.line = base::number(from.line);
  event.output = from.output;
  event.waits = from.waits ? 1 : 0;
  copy_text(event.code, base::code_of(from.kind));
  return event;
}

leadscrew_word word_of(const base::Word& from) {
  leadscrew_word word{};
  word.tick = base::count(from.tick);
  std::copy(from.position.begin(), from.position.end(), word.position);
  word.path_length = from.path_length;
  word.speed = from.speed;
  word.feed = from.feed;
  word.line = base::number(from.line);
  word.state = static_cast<std::uint8_t>(from.state);
  return word;
}

/// What the options ask for; an error where the structure is none, or the slice or the start is not sound.
base::Result<host::MotionOptions> options_of(const leadscrew_options& given, const machine::Machine& machine) {
  host::MotionOptions options;
  options.start = axes_of(given.start);
  if (auto inside = host::check_position(options.start, machine); !inside) return base::failure(inside.error());
  if (!(given.slice >= 0 && std::isfinite(given.slice)))
    return base::failure(base::problem("slice", "a slice of less than nothing", "seconds, more than 0; 0 for 0.05"));
  if (given.slice > 0) options.slice = given.slice;
  if (given.file != nullptr) options.file = given.file;
  if (given.on_event != nullptr) {
    options.on_event = [function = given.on_event, user = given.user](const base::PassedEvent& passed) {
      const leadscrew_event event = event_of(passed);
      function(&event, user);
    };
  }
  return options;
}

gcode::DiagnosticSink sink_of(const leadscrew_options& options) {
  if (options.on_diagnostic == nullptr) return {};
  return [function = options.on_diagnostic, user = options.user](const base::Diagnostic& diagnostic) {
    const leadscrew_error error = error_of(diagnostic);
    function(&error, user);
  };
}

/// Makes a motion by `make`, which takes the machine, host::MotionOptions and the options as given.
template <class Make>
int make_motion(const leadscrew_machine* machine, const leadscrew_options* given, leadscrew_motion** motion,
                leadscrew_error* error, const Make& make) {
  if (machine == nullptr || motion == nullptr) return misuse(error, "the machine or the place for the motion is NULL");
  leadscrew_options none{};
  none.size = sizeof none;
  const auto asked = known(given == nullptr ? &none : given);
  if (!asked) return misuse(error, "the size of the options is none that a version had");
  return guarded(error, [&] {
    auto options = options_of(*asked, machine->machine);
    if (!options) return rejected(error, options.error());
    base::Result<std::unique_ptr<host::Motion>> made = make(machine->machine, std::move(*options), *asked);
    if (!made) return rejected(error, made.error());
    *motion = new leadscrew_motion{std::move(*made)};
    return static_cast<int>(LEADSCREW_OK);
  });
}

int give_machine(config::MachineOrProblems read, leadscrew_machine** machine, leadscrew_error* error) {
  if (!read) {
    const base::Diagnostic& first = read.error().front();
    tell(error, first);
    return first.code.substr(0, 3) == "io-" ? LEADSCREW_INPUT : LEADSCREW_REJECTED;
  }
  *machine = new leadscrew_machine{std::move(*read)};
  return LEADSCREW_OK;
}

gcode::NurbsCurve curve_of(const leadscrew_move& move) {
  gcode::NurbsCurve curve;
  curve.degree = move.degree;
  for (std::size_t i = 0; i < move.points; ++i) {
    gcode::ControlPoint& point = curve.points.emplace_back();
    std::copy_n(move.positions + i * LEADSCREW_AXES, LEADSCREW_AXES, point.position.begin());
    if (move.weights != nullptr) point.weight = move.weights[i];
  }
  if (move.knots != nullptr)
    curve.knots.assign(move.knots, move.knots + move.points + static_cast<std::size_t>(move.degree) + 1);
  return curve;
}

/// Empty where a field is out of its range.
std::optional<gcode::Move> move_of(const leadscrew_move& given) {
  std::optional<gcode::Move> move;
  if (given.line < 0) return move;
  switch (given.kind) {
    case LEADSCREW_LINE:
      move = host::line(axes_of(given.end), given.feed);
      break;
    case LEADSCREW_ARC:
      if (given.plane < LEADSCREW_XY || given.plane > LEADSCREW_YZ) return move;
      move = host::arc(axes_of(given.end), static_cast<gcode::Plane>(given.plane), given.center[0], given.center[1],
                       given.turns, given.feed);
      break;
    case LEADSCREW_CURVE:
      if (given.degree < 1 || given.degree > gcode::highest_degree || given.positions == nullptr ||
          given.points > gcode::most_control_points)
        return move;
      move = host::curve(curve_of(given), given.feed);
      break;
    case LEADSCREW_DWELL:
      move = host::dwell(given.seconds);
      break;
    default:
      return move;
  }
  move->line = base::Line{given.line};
  return move;
}

int next_words(host::Motion& motion, leadscrew_word* words, std::size_t word_size, std::size_t capacity,
               std::size_t& count) {
  std::array<base::Word, 256> made;
  auto* to = reinterpret_cast<char*>(words);
  while (count < capacity) {
    const std::size_t some = motion.next(std::span(made).first(std::min(made.size(), capacity - count)));
    for (std::size_t i = 0; i < some; ++i, to += word_size) {
      const leadscrew_word word = word_of(made[i]);
      std::memcpy(to, &word, sizeof word);
    }
    count += some;
    if (motion.progress() != pipeline::Progress::moving) break;
  }
  return count == 0 && capacity > 0 && motion.failure() ? LEADSCREW_FAILED : LEADSCREW_OK;
}

}  // namespace

const char* leadscrew_version() {
  return LEADSCREW_VERSION_TEXT;
}

int leadscrew_machine_builtin(const char* name, leadscrew_machine** machine, leadscrew_error* error) {
  if (name == nullptr || machine == nullptr) return misuse(error, "the name or the place for the machine is NULL");
  return guarded(error, [&] {
    if (std::string_view(name) != "mill3")
      return rejected(error, base::problem("machine-name", "no machine of this name is built in", "mill3"));
    *machine = new leadscrew_machine{machine::mill3()};
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_machine_of_text(const char* text, size_t length, leadscrew_machine** machine, leadscrew_error* error) {
  if (!is_text(text, length) || machine == nullptr)
    return misuse(error, "the text or the place for the machine is NULL, or the length is none that memory holds");
  return guarded(error, [&] { return give_machine(config::read_machine({text, length}, {}), machine, error); });
}

int leadscrew_machine_of_file(const char* path, leadscrew_machine** machine, leadscrew_error* error) {
  if (path == nullptr || machine == nullptr) return misuse(error, "the path or the place for the machine is NULL");
  return guarded(error, [&] { return give_machine(config::load_machine(path), machine, error); });
}

double leadscrew_machine_period(const leadscrew_machine* machine) {
  return machine == nullptr ? 0 : machine->machine.period.seconds();
}

void leadscrew_machine_free(leadscrew_machine* machine) {
  delete machine;
}

int leadscrew_motion_of_program(const leadscrew_machine* machine, const char* text, size_t length,
                                const leadscrew_options* options, leadscrew_motion** motion, leadscrew_error* error) {
  if (!is_text(text, length)) return misuse(error, "the text is NULL, or its length is none that memory holds");
  return make_motion(machine, options, motion, error, [&](const auto& limits, auto asked, const auto& given) {
    return host::Motion::of_program(limits, std::string(text, length), std::move(asked), sink_of(given));
  });
}

int leadscrew_motion_of_moves(const leadscrew_machine* machine, const leadscrew_options* options,
                              leadscrew_motion** motion, leadscrew_error* error) {
  return make_motion(machine, options, motion, error,
                     [](const auto& limits, auto asked, const auto&) -> base::Result<std::unique_ptr<host::Motion>> {
                       return std::make_unique<host::Motion>(limits, std::move(asked));
                     });
}

void leadscrew_motion_free(leadscrew_motion* motion) {
  if (motion == nullptr || motion->is_busy) return;
  delete motion;
}

int leadscrew_motion_smooth(leadscrew_motion* motion, double tolerance, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) { return code_of(m.smooth(tolerance), error); });
}

int leadscrew_motion_push(leadscrew_motion* motion, const leadscrew_move* move, leadscrew_error* error) {
  const auto given = known(move);
  if (!given) return misuse(error, "the move is NULL, or its size is none that a version had");
  return within(motion, error, [&](host::Motion& m) {
    auto made = move_of(*given);
    if (!made) return misuse(error, "the kind of the move, its line, plane, degree or points are out of their range");
    return code_of(m.push(std::move(*made)), error);
  });
}

int leadscrew_motion_end_for_now(leadscrew_motion* motion) {
  return within(motion, nullptr, [](host::Motion& m) {
    m.end_for_now();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_motion_finish(leadscrew_motion* motion) {
  return within(motion, nullptr, [](host::Motion& m) {
    m.finish();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_motion_next(leadscrew_motion* motion, leadscrew_word* words, size_t word_size, size_t capacity,
                          size_t* count, leadscrew_error* error) {
  if (count == nullptr) return misuse(error, "the place for the count is NULL");
  *count = 0;
  if (words == nullptr || word_size < sizeof(leadscrew_word))
    return misuse(error, "the words are NULL, or their size is none that a version had");
  return within(motion, error, [&](host::Motion& m) {
    const int code = next_words(m, words, word_size, capacity, *count);
    if (code == LEADSCREW_FAILED) tell(error, *m.failure());
    return code;
  });
}

int leadscrew_motion_progress(const leadscrew_motion* motion) {
  return motion == nullptr ? static_cast<int>(LEADSCREW_ENDED) : static_cast<int>(motion->motion->progress());
}

int leadscrew_motion_override(leadscrew_motion* motion, double factor, leadscrew_error* error) {
  return within(motion, error, [&](host::Motion& m) { return code_of(m.override_feed(factor), error); });
}

int leadscrew_motion_abort(leadscrew_motion* motion) {
  return within(motion, nullptr, [](host::Motion& m) {
    m.abort();
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_motion_reset(leadscrew_motion* motion, const double* position, leadscrew_error* error) {
  if (position == nullptr) return misuse(error, "the position is NULL");
  return within(motion, error, [&](host::Motion& m) {
    base::AxisVector there;
    std::copy_n(position, LEADSCREW_AXES, there.begin());
    return code_of(m.reset(there), error);
  });
}
