// The calls of leadscrew.h for reference pulses. They stand on the core alone, so that a browser has them too.

#include <algorithm>
#include <array>
#include <leadscrew/nc/pulse_figures.hpp>
#include <leadscrew/nc/pulse_reason.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "calls.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

struct leadscrew_pulses {
  nc::PulseCurve curve;
  nc::PulseMeasurement measurement;
  nc::PulseRun before;  ///< the last clock
};

namespace {

constexpr std::array<const char*, 5> first_columns = {"clock", "dx", "dy", "X", "Y"};

template <class T, std::size_t count>
std::optional<T> named(const char* text, const std::array<T, count>& values) {
  for (const T value : values) {
    if (nc::name(value) == text) return value;
  }
  return std::nullopt;
}

template <class T, std::size_t count>
const char* name_in(const std::array<T, count>& values, std::size_t number) {
  return number < count ? nc::name(values[number]).data() : nullptr;  // all of them literals
}

bool is_given(const char* text) {
  return text != nullptr && *text != '\0';
}

int bits_of_uses(nc::PulseMethod method) {
  const nc::MethodUses uses = nc::uses_of(method);
  return (uses.preload ? 1 << LEADSCREW_PRELOADS : 0) | (uses.order ? 1 << LEADSCREW_ORDERS : 0) |
         (uses.tie ? 1 << LEADSCREW_TIES : 0) | (uses.capacity ? 1 << LEADSCREW_CAPACITY : 0) |
         (uses.ellipse ? 1 << LEADSCREW_ELLIPSES : 0) | (uses.free ? 1 << LEADSCREW_FREE : 0) |
         (uses.accumulation ? 1 << LEADSCREW_ACCUMULATIONS : 0) | (uses.places ? 1 << LEADSCREW_PLACES : 0);
}

/// A task in the words of the rooms.
struct Asked {
  nc::PulseMethod method{};
  nc::PulseCurve curve;
  nc::MethodOptions options;
};

pulse::Point point_of(const std::int64_t (&from)[2]) {
  return {from[0], from[1]};
}

/// What is wrong with an option, or nothing.
template <class T, std::size_t count>
const char* read_choice(const char* text, bool has, const std::array<T, count>& values, std::optional<T>& to) {
  if (!is_given(text)) return nullptr;
  if (!has) return "the method does not have an option that is given";
  to = named(text, values);
  return to ? nullptr : "an option is given by a name that none of its values has";
}

const char* read_options(const leadscrew_pulse_task& task, Asked& asked) {
  const nc::MethodUses uses = nc::uses_of(asked.method);
  if (task.bits < 0 || task.bits > nc::most_pulse_bits) return "bits are 1 to 30, or 0";
  if (task.capacity < 0 || task.capacity > pulse::greatest_coordinate) return "the capacity is 1 to 2^30, or 0";
  if (task.bits > 0 && task.capacity > 0) return "bits and a capacity are given: registers of n bits have 2^n";
  if (task.capacity > 0 && !uses.capacity) return "the method does not have a capacity";
  if (task.bits > 0) asked.options.bits = task.bits;
  if (task.capacity > 0) asked.options.capacity = task.capacity;
  const bool is_arc = asked.curve.is_arc(), is_circle = is_arc && !asked.curve.is_ellipse();
  if (task.is_free != 0 && !(uses.free && is_circle)) return "arcs of circles by integrators alone run freely";
  asked.options.free = task.is_free != 0;
  if (task.places < 0 || task.places > nc::most_places) return "places are 1 to 16, or 0";
  if (task.places > 0 && !uses.places) return "the method does not have places of the radius";
  if (task.places > 0) asked.options.places = task.places;
  const char* wrong = read_choice(task.preload, uses.preload, nc::all_preloads, asked.options.preload);
  if (wrong == nullptr) wrong = read_choice(task.order, uses.order && is_arc, nc::all_orders, asked.options.order);
  if (wrong == nullptr) wrong = read_choice(task.tie, uses.tie && is_circle, nc::all_ties, asked.options.tie);
  if (wrong == nullptr)
    wrong = read_choice(task.accumulation, uses.accumulation, nc::all_accumulations, asked.options.accumulation);
  if (wrong != nullptr) return wrong;
  const std::string_view conflict = nc::conflict_of(asked.options, asked.curve);
  return conflict.empty() ? nullptr : conflict.data();  // all of them literals
}

/// What is wrong with the call, or nothing.
const char* read_task(const leadscrew_pulse_task* given, Asked& asked) {
  const auto task = known(given);
  if (!task) return "the task is NULL, its size is none that a version had, or it asks for what is not known";
  if (task->kind != LEADSCREW_LINE && task->kind != LEADSCREW_ARC) return "the kind is a line's or an arc's";
  const bool is_arc = task->kind == LEADSCREW_ARC;
  if (is_arc && task->turns != 1 && task->turns != -1) return "turns are 1 or -1";
  const auto method = is_given(task->method) ? named(task->method, nc::all_pulse_methods) : std::nullopt;
  if (!method) return "the method is none of those that leadscrew_pulse_name() lists";
  asked.method = *method;
  asked.curve.shape = is_arc ? nc::PulseCurve::Shape::arc : nc::PulseCurve::Shape::line;
  asked.curve.start = point_of(task->start);
  asked.curve.end = point_of(task->end);
  if (is_arc) {
    asked.curve.center = point_of(task->center);
    asked.curve.direction = static_cast<pulse::Direction>(task->turns);
    const auto& [along_x, along_y] = task->semi_axes;
    if (along_x != 0 || along_y != 0) asked.curve.semi_axes = {along_x, along_y};
  }
  return read_options(*task, asked);
}

std::vector<base::Diagnostic> problems_of(const Asked& asked) {
  auto problems = nc::problems_of(asked.curve, asked.options.bits);
  if (!problems.empty()) return problems;
  if (auto problem = nc::capacity_problem(asked.method, asked.curve, asked.options))
    problems.push_back(std::move(*problem));
  return problems;
}

void write_row(const leadscrew_pulses& pulses, std::int64_t* to) {
  const nc::PulseRun& run = pulses.measurement.run();
  *to++ = run.clock();
  const auto step = run.last().step;
  to = std::copy(step.begin(), step.end(), to);
  *to++ = run.at().x;
  *to++ = run.at().y;
  const nc::Registers signals = nc::signals_of(run, pulses.curve);
  for (const nc::Register& each : signals.all()) *to++ = each.value;
  const nc::Registers flow = nc::flow_of(pulses.before, run, pulses.curve);
  for (const nc::Register& each : flow.all()) *to++ = each.value;
}

std::size_t count_columns(const leadscrew_pulses& pulses) {
  std::size_t count = 0;
  while (leadscrew_pulses_column(&pulses, count) != nullptr) ++count;
  return count;
}

}  // namespace

const char* leadscrew_pulse_name(int what, std::size_t number) {
  switch (what) {
    case LEADSCREW_METHODS:
      return name_in(nc::all_pulse_methods, number);
    case LEADSCREW_PRELOADS:
      return name_in(nc::all_preloads, number);
    case LEADSCREW_ORDERS:
      return name_in(nc::all_orders, number);
    case LEADSCREW_TIES:
      return name_in(nc::all_ties, number);
    case LEADSCREW_ACCUMULATIONS:
      return name_in(nc::all_accumulations, number);
    default:
      return nullptr;
  }
}

int leadscrew_pulse_uses(const char* method) {
  const auto asked = is_given(method) ? named(method, nc::all_pulse_methods) : std::nullopt;
  return asked ? bits_of_uses(*asked) : 0;
}

int leadscrew_pulses_problem(const leadscrew_pulse_task* task, std::size_t number, leadscrew_error* problem) {
  return guarded(problem, [&] {
    Asked asked;
    if (const char* wrong = read_task(task, asked)) return misuse(problem, wrong);
    const auto problems = problems_of(asked);
    return number < problems.size() ? rejected(problem, problems[number]) : static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_pulses_load(const leadscrew_pulse_task* task, leadscrew_pulses** pulses, leadscrew_error* error) {
  if (pulses == nullptr) return misuse(error, "the place for the pulses is NULL");
  return guarded(error, [&] {
    Asked asked;
    if (const char* wrong = read_task(task, asked)) return misuse(error, wrong);
    if (const auto problems = problems_of(asked); !problems.empty()) return rejected(error, problems.front());
    const nc::PulseRun run(asked.method, asked.curve, asked.options);
    *pulses = new leadscrew_pulses{asked.curve, nc::PulseMeasurement(run, asked.curve), run};
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_pulses_copy(const leadscrew_pulses* pulses, leadscrew_pulses** copy, leadscrew_error* error) {
  if (pulses == nullptr || copy == nullptr) return misuse(error, "the pulses or the place for the copy are NULL");
  return guarded(error, [&] {
    *copy = new leadscrew_pulses(*pulses);
    return static_cast<int>(LEADSCREW_OK);
  });
}

void leadscrew_pulses_free(leadscrew_pulses* pulses) {
  delete pulses;
}

int leadscrew_pulses_conventions(const leadscrew_pulses* pulses, leadscrew_pulse_conventions* conventions,
                                 leadscrew_error* error) {
  if (pulses == nullptr) return misuse(error, "the pulses are NULL");
  const nc::PulseRun& run = pulses->measurement.run();
  const nc::PulseConventions& in_force = run.conventions();
  leadscrew_pulse_conventions found{};
  found.bits = in_force.bits.value_or(0);
  found.capacity = in_force.capacity.value_or(0);
  found.scale = in_force.scale.value_or(0);
  found.clocks_per_blu = nc::clocks_per_blu(run.method(), pulses->curve, in_force).value_or(0);
  if (in_force.preload) copy_text(found.preload, nc::name(*in_force.preload));
  if (in_force.order) copy_text(found.order, nc::name(*in_force.order));
  found.places = in_force.places.value_or(0);
  if (in_force.accumulation) copy_text(found.accumulation, nc::name(*in_force.accumulation));
  copy_text(found.tie, in_force.tie);
  copy_text(found.end, in_force.end);
  if (fill(conventions, found)) return LEADSCREW_OK;
  return misuse(error, "the conventions are NULL, or their size is none that a version had");
}

int leadscrew_pulses_figures(const leadscrew_pulses* pulses, leadscrew_pulse_figures* figures, leadscrew_error* error) {
  if (pulses == nullptr) return misuse(error, "the pulses are NULL");
  return guarded(error, [&] {
    const nc::PulseRun& run = pulses->measurement.run();
    const nc::PulseFigures now = pulses->measurement.figures();
    leadscrew_pulse_figures found{};
    found.clocks = now.clocks;
    found.pulses = now.pulses;
    found.position[0] = run.at().x;
    found.position[1] = run.at().y;
    found.worst[0] = now.worst.x;
    found.worst[1] = now.worst.y;
    found.worst_clock = now.worst_clock;
    found.error = nc::PulseError(pulses->curve)(run.at());
    found.max_error = now.max_error;
    found.rms_error = now.rms_error;
    found.is_done = run.done() ? 1 : 0;
    if (fill(figures, found)) return static_cast<int>(LEADSCREW_OK);
    return misuse(error, "the figures are NULL, or their size is none that a version had");
  });
}

const char* leadscrew_pulses_column(const leadscrew_pulses* pulses, std::size_t number) {
  if (pulses == nullptr) return nullptr;
  if (number < first_columns.size()) return first_columns[number];
  number -= first_columns.size();
  const nc::PulseRun& run = pulses->measurement.run();
  for (const nc::Registers& some : {nc::signals_of(run, pulses->curve), nc::flow_of(run, run, pulses->curve)}) {
    if (number < some.all().size()) return some.all()[number].name.data();  // all of them literals
    number -= some.all().size();
  }
  return nullptr;
}

int leadscrew_pulses_row(const leadscrew_pulses* pulses, std::int64_t* row, leadscrew_error* error) {
  if (pulses == nullptr || row == nullptr) return misuse(error, "the pulses or the place for the row are NULL");
  return guarded(error, [&] {
    write_row(*pulses, row);
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_pulses_next(leadscrew_pulses* pulses, std::int64_t* rows, std::size_t capacity, std::size_t* count,
                          leadscrew_error* error) {
  if (pulses == nullptr || count == nullptr) return misuse(error, "the pulses or the place for the count are NULL");
  return guarded(error, [&] {
    const std::size_t columns = rows == nullptr ? 0 : count_columns(*pulses);
    std::size_t made = 0;
    for (; made < capacity && !pulses->measurement.done(); ++made) {
      pulses->before = pulses->measurement.run();
      pulses->measurement.step();
      if (rows != nullptr) write_row(*pulses, rows + made * columns);
    }
    *count = made;
    return static_cast<int>(LEADSCREW_OK);
  });
}

std::size_t leadscrew_pulses_why(const leadscrew_pulses* pulses, char* text, std::size_t length) {
  if (pulses == nullptr) return 0;
  const std::string why = nc::reason_of(pulses->before, pulses->measurement.run(), pulses->curve);
  if (text != nullptr && length > 0) {
    const std::size_t some = std::min(why.size(), length - 1);
    std::copy_n(why.begin(), some, text);
    text[some] = '\0';
  }
  return why.size();
}
