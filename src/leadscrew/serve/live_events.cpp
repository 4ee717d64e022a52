#include <fmt/format.h>

#include <array>
#include <leadscrew/drive/wishes.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/serve/live_events.hpp>
#include <variant>

namespace leadscrew::serve {

namespace {

using json::Json;

constexpr std::array<std::string_view, 9> state_names = {"starting",     "moving", "resting", "held",    "hold_waits",
                                                         "hold_refused", "paused", "waiting", "stopping"};

std::string live_event(std::string_view name, const Json& data) {
  return fmt::format("event: {}\ndata: {}\n\n", name, data.written_in_line());
}

Json of_axes(const machine::Machine& machine, const base::AxisVector& values) {
  Json list = Json::list();
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) list.push_back(values[base::index(axis)]);
  }
  return list;
}

Json numbers_of(std::initializer_list<double> values) {
  Json list = Json::list();
  for (const double value : values) list.push_back(value);
  return list;
}

}  // namespace

std::string machine_event(const machine::Machine& machine, const LiveMachine& live) {
  Json axes = Json::list();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    axes.push_back(Json::object({{"name", std::string(1, base::letter(axis))},
                                 {"rotary", base::is_rotary(axis)},
                                 {"travel", numbers_of({limits.travel_min, limits.travel_max})},
                                 {"velocity", limits.velocity},
                                 {"acceleration", limits.acceleration},
                                 {"jerk", limits.jerk}}));
  }
  return live_event("machine", Json::object({{"schema", "leadscrew.live-machine/1"},
                                             {"program", live.program},
                                             {"has_text", live.has_text},
                                             {"may_control", live.may_control},
                                             {"machine", machine.name},
                                             {"kinematics", machine.kinematics},
                                             {"period_s", machine.period.seconds()},
                                             {"tolerance_mm", machine.tolerance},
                                             {"chord_error_mm", machine.chord_error},
                                             {"axes", axes}}));
}

std::string sample_event(const machine::Machine& machine, const drive::Feedback& feedback, const LiveState& state) {
  const base::Word& word = feedback.word;
  Json sample = Json::object({{"schema", "leadscrew.live-sample/1"},
                              {"t", base::seconds(word.tick, machine.period)},
                              {"line", base::number(word.line)},
                              {"length_mm", word.path_length},
                              {"position", of_axes(machine, word.position)},
                              {"actual", of_axes(machine, feedback.actual)},
                              {"feed", word.feed},
                              {"measured_feed", feedback.measured_feed},
                              {"following_error", feedback.following_error},
                              {"state", state_names[static_cast<std::size_t>(state.kind)]},
                              {"override", state.override_factor},
                              {"pause_line", state.pause_line}});
  kinematics::WordPoses poses(machine);
  poses.hold(feedback.tool);
  if (const auto pose = poses.of(feedback.actual)) {
    sample["tip"] = numbers_of({pose->tip[0], pose->tip[1], pose->tip[2]});
    sample["direction"] = numbers_of({pose->direction[0], pose->direction[1], pose->direction[2]});
  }
  return live_event("sample", sample);
}

std::string end_event() {
  return live_event("end", Json::object());
}

std::optional<Wish> wish_of(std::string_view body) {
  const auto object = Json::parse(body);
  const auto* members = object ? object->members() : nullptr;
  if (members == nullptr || members->empty()) return std::nullopt;
  Wish wish;
  for (const auto& [key, value] : *members) {
    const auto truth = value.visit([](const auto& held) -> std::optional<bool> {
      if constexpr (std::is_same_v<std::decay_t<decltype(held)>, bool>) return held;
      return std::nullopt;
    });
    const auto number = value.number();
    if (key == "hold" && truth) {
      wish.hold = truth;
    } else if (key == "override" && number && *number >= drive::Wishes::least_factor &&
               *number <= drive::Wishes::greatest_factor) {
      wish.override_factor = number;
    } else if (key == "stop" && truth == true) {
      wish.stop = true;
    } else if (key == "go_on" && truth == true) {
      wish.go_on = true;
    } else {
      return std::nullopt;
    }
  }
  return wish;
}

}  // namespace leadscrew::serve
