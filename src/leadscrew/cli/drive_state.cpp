#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <leadscrew/cli/drive_state.hpp>
#include <leadscrew/cli/interrupt.hpp>
#include <leadscrew/cli/output_file.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/way_back.hpp>
#include <nlohmann/json.hpp>

namespace leadscrew::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double at_rest = 1e-3;  // mm or degrees; axes may stand by rounding or their counts beyond their travel
constexpr std::string_view state_schema = "leadscrew.state/2";
constexpr std::array<std::string_view, 3> kinds = {"moving", "stopped", "ended"};

/// FNV-1a, 64 bits: tells files apart that differ by accident.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    count_ += bytes.size();
  }
  std::string text() const { return fmt::format("{:016x}-{}", value_, count_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
  std::size_t count_ = 0;
};

std::string text_of(const base::AxisVector& values) {
  std::string text;
  for (const double value : values) text += fmt::format(" {:a}", value);
  return text;
}

std::string machine_text(const Job& job) {
  std::string text = fmt::format("{} {}\n{}\n", job.machine.name, job.machine.period.nanoseconds, job.text);
  text += "start" + text_of(job.start);
  if (job.arguments.mode) text += fmt::format(" mode {}", static_cast<int>(*job.arguments.mode));
  if (job.arguments.tolerance) text += fmt::format(" tolerance {:a}", *job.arguments.tolerance);
  return text;
}

Json json_of(const base::AxisVector& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(value);
  return list;
}

base::AxisVector axes_of(const Json& list) {
  base::AxisVector values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = list.at(i).get<double>();
  return values;
}

std::int64_t count_of(const Json& value) {
  const auto count = value.get<std::int64_t>();
  if (count < 0) throw std::runtime_error(fmt::format("{} counts nothing", count));
  return count;
}

double length_of(const Json& value) {
  const auto length = value.get<double>();
  if (!(length >= 0)) throw std::runtime_error(fmt::format("{} mm is no length", length));
  return length;
}

tl::unexpected<base::Diagnostic> refusal(std::string_view code, std::string message, std::string hint,
                                         const std::string& path) {
  return base::failure(
      {base::Severity::error, code, std::move(message), std::move(hint), base::Place{.file = path}, {}});
}

}  // namespace

base::Result<Fingerprint> fingerprint_of(const InputFile& program, const Job& job) {
  Hash text, machine;
  std::vector<char> buffer(1 << 16);
  auto source = program.source();
  while (true) {
    const auto got = source(buffer);
    if (!got) return base::failure(got.error());
    if (*got == 0) break;
    text.add({buffer.data(), *got});
  }
  machine.add(machine_text(job));
  return Fingerprint{text.text(), machine.text()};
}

base::Result<Descriptor> hold_state(const std::string& path) {
  constexpr int most_looks = 250;
  constexpr timespec between_looks{0, 20'000'000};
  // A name that the system forgets with its last holder: no file is left.
  sockaddr_un name = {};
  name.sun_family = AF_UNIX;
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  Hash hash;
  hash.add(whole.string());
  const std::string text = "leadscrew-state-" + hash.text();
  std::copy(text.begin(), text.end(), name.sun_path + 1);  // behind a zero: of no folder
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + text.size());
  Descriptor descriptor(::socket(AF_UNIX, SOCK_DGRAM, 0));
  for (int look = 0; look < most_looks; ++look) {
    if (interruptions() > 0) return base::failure(interruption());
    if (::bind(descriptor.number(), reinterpret_cast<const sockaddr*>(&name), length) == 0) return descriptor;
    if (errno != EADDRINUSE) return base::failure(system_failure("io-open", "cannot hold", path, errno));
    ::nanosleep(&between_looks, nullptr);
  }
  return refusal("state-busy", "is being kept by another drive", "let that one end, or name another file", path);
}

base::Result<void> write_state(const std::string& path, const DriveState& state) {
  const Json json = {{"schema", state_schema},
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
                     {"axes_path_length", state.axes.path_length}};
  auto file = OutputFile::create(path, OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  if (auto written = file->write(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); !written)
    return written;
  return file->publish_durably();
}

base::Result<DriveState> read_state(const std::string& path) {
  const auto text = read_whole(path);
  if (!text) return base::failure(text.error());
  try {
    const Json json = Json::parse(*text);
    if (json.at("schema").get<std::string>() != state_schema) throw std::runtime_error("another schema");
    DriveState state;
    state.program = json.at("program").get<std::string>();
    state.machine = json.at("machine").get<std::string>();
    state.fingerprint = {json.at("program_hash").get<std::string>(), json.at("machine_hash").get<std::string>()};
    const auto kind = std::find(kinds.begin(), kinds.end(), json.at("state").get<std::string>());
    if (kind == kinds.end()) throw std::runtime_error("another state");
    state.kind = static_cast<DriveState::Kind>(kind - kinds.begin());
    state.word.tick = base::Tick{count_of(json.at("word"))};
    state.word.line = base::Line{count_of(json.at("line"))};
    state.word.path_length = length_of(json.at("path_length"));
    state.word.position = axes_of(json.at("position"));
    state.axes = {axes_of(json.at("axes")), length_of(json.at("axes_path_length"))};
    constexpr double rounded = 1e-6;
    if (state.axes.path_length < state.word.path_length - rounded)
      throw std::runtime_error("axes stand before the last word");
    state.axes.path_length = std::max(state.axes.path_length, state.word.path_length);
    return state;
  } catch (const std::exception& error) {
    return refusal("resume-state", fmt::format("is no state of a drive: {}", error.what()),
                   "give the file that --state of an earlier drive wrote", path);
  }
}

base::Result<void> check_resumable(const DriveState& state, const Fingerprint& now, const machine::Machine& machine,
                                   const std::string& path) {
  if (state.fingerprint.program != now.program) {
    return refusal("resume-program", fmt::format("was written by a drive of another program, {}", state.program),
                   "give the program as it was, byte for byte, or drive the new one from its start", path);
  }
  if (state.fingerprint.machine != now.machine) {
    return refusal("resume-machine",
                   fmt::format("was written by a drive of another machine, {}, with other tools, or another --period, "
                               "--start, --mode or --tolerance",
                               state.machine),
                   "a place on the path is the same only where all of these are", path);
  }
  if (state.kind == DriveState::Kind::ended)
    return refusal("resume-ended", "was written by a drive that has come to the program's end", "", path);
  for (const base::Axis axis : base::all_axes) {
    for (const double at : {state.axes.position[base::index(axis)], state.word.position[base::index(axis)]}) {
      const bool is_within = machine.has(axis) ? at >= machine.limits(axis).travel_min - at_rest &&
                                                     at <= machine.limits(axis).travel_max + at_rest
                                               : at == 0;
      if (is_within) continue;
      return refusal("resume-state", fmt::format("says that {} stands at {}, where it cannot", base::letter(axis), at),
                     "give the file that --state wrote, as it was", path);
    }
  }
  return {};
}

base::Result<void> check_replaceable(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) == 0) return {};
  if (read_state(path)) return {};
  return refusal("state-other", "holds something else than the state of a drive",
                 "name another file, or remove this one", path);
}

base::Result<std::vector<base::PathPlace>> find_way_back(const DriveState& state, const InputFile& program,
                                                         const Job& job, const std::string& path) {
  constexpr double same = 1e-6;  // mm or degrees
  const auto refused = [&](double length, std::string_view but) {
    return refusal("resume-state", fmt::format("says that the path was left after {:.6g} mm, but {}", length, but),
                   "give the file as --state wrote it, to the same version of leadscrew", path);
  };
  const auto are_same = [](const base::AxisVector& a, const base::AxisVector& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](double p, double q) { return std::abs(p - q) <= same; });
  };
  pipeline::MotionSource source(program.source(), job.machine, job.tools, job.reader_options(program.name()), nullptr);
  pipeline::PathStretch stretch(state.word.path_length, state.axes.path_length);
  source.on_element = [&](const toolpath::Element& element) { stretch.push(element); };
  source.planner().start_at(state.word.path_length, state.word.line);
  bool goes_on = source.next().has_value();
  if (source.failure()) return base::failure(*source.failure());
  const std::optional<geometry::Point> at = source.planner().started_at();
  if (!at) return refused(state.word.path_length, "it is shorter");
  if (!are_same(*at, state.word.position)) return refused(state.word.path_length, "it is elsewhere there");
  if (state.axes.path_length == state.word.path_length) {
    if (are_same(*at, state.axes.position)) return std::vector<base::PathPlace>();
    return refused(state.axes.path_length, "it is elsewhere there");
  }
  while (goes_on && !stretch.is_whole()) goes_on = source.next().has_value();
  if (source.failure()) return base::failure(*source.failure());
  if (!stretch.is_whole()) return refused(state.axes.path_length, "it is shorter");
  if (!are_same(stretch.at(stretch.to()).position, state.axes.position))
    return refused(state.axes.path_length, "it is elsewhere there");
  auto way = pipeline::way_back(stretch, job.machine);
  if (!way) return refused(state.axes.path_length, "no way leads back");
  way->back().position = state.word.position;
  return std::move(*way);
}

}  // namespace leadscrew::cli
