#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <leadscrew/base/hash.hpp>
#include <leadscrew/drive/state.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/json/json.hpp>
#include <stdexcept>

namespace leadscrew::drive {

namespace {

using json::Json;

constexpr std::string_view state_schema = "leadscrew.state/3";
constexpr std::int64_t largest_state = 1 << 20;
constexpr std::array<std::string_view, 3> kinds = {"moving", "stopped", "ended"};

std::string text_of(const base::Hash& hash) {
  return fmt::format("{:016x}-{}", hash.value(), hash.count());
}

std::string text_of(const base::AxisVector& values) {
  std::string text;
  for (const double value : values) text += fmt::format(" {:a}", value);
  return text;
}

std::string machine_text(const Setup& setup) {
  std::string text = fmt::format("{} {}\n{}\n", setup.machine.name, setup.machine.period.nanoseconds, setup.text);
  const gcode::ReaderOptions& reading = setup.reading;
  text += "start" + text_of(reading.start);
  if (reading.dialect != machine::Dialect::leadscrew) text += fmt::format(" dialect {}", name(reading.dialect));
  if (reading.path_mode) text += fmt::format(" mode {}", static_cast<int>(*reading.path_mode));
  if (reading.tolerance) text += fmt::format(" tolerance {:a}", *reading.tolerance);
  return text;
}

Json json_of(const base::AxisVector& values) {
  return std::vector<double>(values.begin(), values.end());
}

Json json_of(const ToolState& tool) {
  const auto list = [](const kinematics::Vector& vector) { return std::vector<double>(vector.begin(), vector.end()); };
  return Json::object({{"offset", list(tool.offset)}, {"tip", list(tool.tip)}, {"direction", list(tool.direction)}});
}

base::Result<void> add_text(const files::InputFile& file, base::Hash& hash) {
  std::vector<char> buffer(1 << 16);
  auto source = file.source();
  while (true) {
    const auto got = source(buffer);
    if (!got) return base::failure(got.error());
    if (*got == 0) return {};
    hash.add({buffer.data(), *got});
  }
}

/// The members of a state file; each throws where there is none of its kind.
class Members {
 public:
  explicit Members(const Json& json) : json_(json) {}

  std::string text(std::string_view key) const {
    const std::string* text = member(key).text();
    return text != nullptr ? *text : throw wrong(key, "is no text");
  }
  std::int64_t count(std::string_view key) const {
    const auto count = member(key).integer();
    return count && *count >= 0 ? *count : throw wrong(key, "counts nothing");
  }
  /// 0 where there is none.
  std::int64_t count(std::string_view key, std::int64_t most) const {
    const std::int64_t value = json_.find(key) != nullptr ? count(key) : 0;
    return value <= most ? value : throw wrong(key, "counts too much");
  }
  double length(std::string_view key) const {
    const auto length = member(key).number();
    return length && *length >= 0 ? *length : throw wrong(key, "is no length");
  }
  base::AxisVector axes(std::string_view key) const {
    return numbers<base::AxisVector>(key, "is no list of nine axes");
  }
  kinematics::Vector vector(std::string_view key) const {
    return numbers<kinematics::Vector>(key, "is no list of X, Y and Z");
  }
  /// None where there is none.
  std::optional<Members> members(std::string_view key) const {
    const Json* found = json_.find(key);
    return found != nullptr ? std::optional(Members(*found)) : std::nullopt;
  }

 private:
  template <class Numbers>
  Numbers numbers(std::string_view key, std::string_view else_wrong) const {
    const auto* list = member(key).values();
    Numbers values{};
    if (list == nullptr || list->size() != values.size()) throw wrong(key, else_wrong);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto number = (*list)[i].number();
      values[i] = number ? *number : throw wrong(key, "is no list of numbers");
    }
    return values;
  }
  const Json& member(std::string_view key) const {
    const Json* found = json_.find(key);
    return found != nullptr ? *found : throw wrong(key, "is missing");
  }
  static std::runtime_error wrong(std::string_view key, std::string_view what) {
    return std::runtime_error(fmt::format("{} {}", key, what));
  }

  const Json& json_;
};

}  // namespace

tl::unexpected<base::Diagnostic> state_refusal(std::string_view code, std::string message, std::string hint,
                                               const std::string& path) {
  return base::failure(
      {base::Severity::error, code, std::move(message), std::move(hint), base::Place{.file = path}, {}});
}

std::optional<ToolState> tool_state_of(const kinematics::WordPoses& poses, const base::AxisVector& axes) {
  const auto pose = poses.of(axes);
  if (!pose) return std::nullopt;
  return ToolState{poses.tool(), {pose->tip[0], pose->tip[1], pose->tip[2]}, pose->direction};
}

base::Result<Fingerprint> fingerprint_of(const files::InputFile& program, const Setup& setup) {
  base::Hash text, machine;
  if (auto added = add_text(program, text); !added) return base::failure(added.error());
  for (const files::InputFile* const subprogram : program.subprograms()) {
    if (auto added = add_text(*subprogram, text); !added) return base::failure(added.error());
  }
  machine.add(machine_text(setup));
  return Fingerprint{text_of(text), text_of(machine)};
}

base::Result<void> write_state(const std::string& path, const State& state) {
  Json json = Json::object({{"schema", state_schema},
                            {"program", state.program},
                            {"program_hash", state.fingerprint.program},
                            {"machine", state.machine},
                            {"machine_hash", state.fingerprint.machine},
                            {"state", kinds[static_cast<std::size_t>(state.kind)]},
                            {"word", base::count(state.word.tick)},
                            {"line", base::number(state.word.line)},
                            {"path_length", state.word.path_length},
                            {"position", json_of(state.word.position)},
                            {"axes", json_of(state.axes.position)},
                            {"axes_path_length", state.axes.path_length}});
  if (base::file(state.word.line) != 0) json["file"] = base::file(state.word.line);
  if (base::visit(state.word.line) != 0) json["visit"] = base::visit(state.word.line);
  if (state.tool) json["tool"] = json_of(*state.tool);
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  if (auto written = file->write(json.written() + "\n"); !written) return written;
  return file->publish_durably();
}

base::Result<State> read_state(const std::string& path) {
  const auto text = files::read_whole(path, largest_state);
  if (!text) return base::failure(text.error());
  try {
    const auto json = Json::parse(*text);
    if (!json) throw std::runtime_error("no JSON");
    const Members members(*json);
    if (members.text("schema") != state_schema) throw std::runtime_error("another schema");
    State state;
    state.program = members.text("program");
    state.machine = members.text("machine");
    state.fingerprint = {members.text("program_hash"), members.text("machine_hash")};
    const auto kind = std::find(kinds.begin(), kinds.end(), members.text("state"));
    if (kind == kinds.end()) throw std::runtime_error("another state");
    state.kind = static_cast<State::Kind>(kind - kinds.begin());
    state.word.tick = base::Tick{members.count("word")};
    state.word.line = base::line_at(members.count("line"), static_cast<int>(members.count("file", base::last_file)),
                                    members.count("visit", base::last_visit));
    state.word.path_length = members.length("path_length");
    state.word.position = members.axes("position");
    state.axes = {members.axes("axes"), members.length("axes_path_length")};
    if (const auto tool = members.members("tool"))
      state.tool = {tool->vector("offset"), tool->vector("tip"), tool->vector("direction")};
    constexpr double rounded = 1e-6;
    if (state.axes.path_length < state.word.path_length - rounded)
      throw std::runtime_error("axes stand before the last word");
    state.axes.path_length = std::max(state.axes.path_length, state.word.path_length);
    return state;
  } catch (const std::exception& error) {
    return state_refusal("resume-state", fmt::format("is no state of a drive: {}", error.what()),
                         "give the file that --state of an earlier drive wrote", path);
  }
}

base::Result<void> check_replaceable(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) == 0) return {};
  if (read_state(path)) return {};
  return state_refusal("state-other", "holds something else than the state of a drive",
                       "name another file, or remove this one", path);
}

}  // namespace leadscrew::drive
