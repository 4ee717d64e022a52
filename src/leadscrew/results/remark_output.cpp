#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/results/messages.hpp>
#include <leadscrew/results/remark_output.hpp>

namespace leadscrew::results {

namespace {

constexpr std::size_t most_logs = 100;
constexpr std::int64_t largest_continued_log = 64 << 20;  // bytes

base::Diagnostic log_problem(const gcode::Remark& remark, std::string message, std::string hint) {
  return {base::Severity::error, "bad-log", std::move(message), std::move(hint), remark.place, {}};
}

// Whether a path, links followed, lies below the folder.
bool is_below(const std::filesystem::path& path, const std::filesystem::path& folder) {
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  const auto whole_folder = std::filesystem::weakly_canonical(folder, error);
  if (error) return false;
  return std::mismatch(whole_folder.begin(), whole_folder.end(), whole.begin(), whole.end()).first ==
         whole_folder.end();
}

}  // namespace

base::Result<void> write_parameters(const std::string& path, const std::vector<gcode::NumberedValue>& values) {
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  if (auto written = file->write(gcode::parameter_file_text(values)); !written) return written;
  return file->publish_durably();
}

RemarkOutput::RemarkOutput(const std::string& program, std::function<bool(const std::string&)> is_taken, Say say)
    : folder_(std::filesystem::path(program).parent_path().string()),
      is_taken_(std::move(is_taken)),
      say_(std::move(say)) {
  if (folder_.empty()) folder_ = ".";
}

gcode::RemarkSink RemarkOutput::sink() {
  return [this](const gcode::Remark& remark) { take(remark); };
}

void RemarkOutput::take(const gcode::Remark& remark) {
  using Kind = gcode::Remark::Kind;
  base::Result<void> done;
  switch (remark.kind) {
    case Kind::message:
    case Kind::print:
      return say_(text_of(remark));
    case Kind::log_open:
    case Kind::log_append:
      log_ = nullptr;
      done = open(remark, log_);
      break;
    case Kind::probe_open:
      points_ = nullptr;
      done = open(remark, points_);
      break;
    case Kind::probe_point:
      if (points_ != nullptr) done = points_->write(remark.text + '\n');
      break;
    case Kind::probe_close:
      points_ = nullptr;
      break;
    case Kind::log:
      if (log_ != nullptr) done = log_->write(remark.text + '\n');
      break;
    case Kind::log_close:
      log_ = nullptr;
      break;
  }
  if (!done && !failure_) failure_ = done.error();
}

base::Result<std::string> RemarkOutput::path_of(const gcode::Remark& remark) const {
  const std::filesystem::path path = std::filesystem::path(folder_) / remark.text;
  std::error_code error;
  if (!is_below(path, folder_) || !is_below(files::target_of(path.string()), folder_)) {
    return base::failure(log_problem(remark, fmt::format("log file {} is not in the program's folder", path.string()),
                                     "a link leads out of it"));
  }
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
    return base::failure(
        log_problem(remark, fmt::format("log file {} is no regular file", path.string()), "give another name"));
  }
  if (is_taken_(path.string())) {
    return base::failure(log_problem(remark, fmt::format("log file {} is read or written otherwise", path.string()),
                                     "give another name"));
  }
  return path.lexically_normal().string();
}

base::Result<void> RemarkOutput::open(const gcode::Remark& remark, files::OutputFile*& log) {
  if (failure_) return {};
  const auto path = path_of(remark);
  if (!path) return base::failure(path.error());
  auto& file = logs_[*path];
  const bool appends = remark.kind == gcode::Remark::Kind::log_append;
  if (file && appends) {
    log = file.get();
    return {};
  }
  if (logs_.size() > most_logs) {
    return base::failure(
        log_problem(remark, fmt::format("there are more than {} log files", most_logs), "write to one of them"));
  }
  auto created = files::OutputFile::create(*path, files::OutputFile::Access::sequential);
  if (!created) return base::failure(created.error());
  file = std::make_unique<files::OutputFile>(std::move(*created));
  if (appends) {
    if (auto continued = continue_file(*file, *path); !continued) return continued;
  }
  log = file.get();
  return {};
}

base::Result<void> RemarkOutput::continue_file(files::OutputFile& file, const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const auto before = files::read_whole(path, largest_continued_log);
  if (!before) return base::failure(before.error());
  return file.write(*before);
}

base::Result<std::vector<std::string>> RemarkOutput::publish() {
  if (failure_) return base::failure(*failure_);
  std::vector<std::string> paths;
  for (auto& [path, file] : logs_) {
    if (auto published = files::publish_together({file.get()}); !published) return base::failure(published.error());
    paths.push_back(path);
  }
  return paths;
}

}  // namespace leadscrew::results
