#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/sweep/shards.hpp>
#include <thread>

namespace leadscrew::sweep {

namespace {

constexpr std::string_view line_begin = R"({"check":")";
constexpr std::size_t check_digits = 16;
constexpr std::string_view key_begin = R"(","key":")";
constexpr std::size_t key_place = line_begin.size() + check_digits + key_begin.size(), key_digits = 32;
constexpr std::string_view result_begin = R"(","result":)", spent_begin = R"(,"spent":)";
constexpr auto time_between_syncs = std::chrono::seconds(1);

std::string checksum_of(std::string_view text) {
  base::Hash hash;
  hash.add(text);
  return fmt::format("{:016x}", hash.value());
}

/// Empty where the line is not whole.
std::optional<ShardLine> whole_line(std::string_view text) {
  if (text.size() < key_place + key_digits || !text.starts_with(line_begin)) return std::nullopt;
  const std::string_view behind = text.substr(line_begin.size() + check_digits);
  if (!behind.starts_with(key_begin) || checksum_of(behind) != text.substr(line_begin.size(), check_digits))
    return std::nullopt;
  const auto key = key_of_text(text.substr(key_place, key_digits));
  if (!key) return std::nullopt;
  return ShardLine{*key, text};
}

std::string host_name() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  std::string text(name.data());
  std::ranges::replace_if(text, [](char c) { return c == '/' || c == '.'; }, '-');
  return text.empty() ? "host" : text;
}

base::Result<std::vector<std::string>> shards_of(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) return paths;
  const std::filesystem::directory_iterator entries(folder, error);
  if (error) return base::failure(files::system_failure("io-open", "cannot open", folder, error.value()));
  for (const auto& entry : entries) {
    if (entry.path().extension() == ".jsonl") paths.push_back(entry.path().string());
  }
  std::ranges::sort(paths);
  return paths;
}

/// The last part, which has no end of line, stays in `rest`.
void take_lines(std::string& rest, const std::function<void(const ShardLine&)>& line) {
  std::size_t begin = 0;
  for (std::size_t end = rest.find('\n'); end != std::string::npos; end = rest.find('\n', begin)) {
    if (const auto found = whole_line(std::string_view(rest).substr(begin, end - begin))) line(*found);
    begin = end + 1;
  }
  rest.erase(0, begin);
}

base::Result<void> read_shard(const std::string& path, const std::function<void(const ShardLine&)>& line) {
  auto file = files::open_descriptor(path, O_RDONLY | O_CLOEXEC, "cannot open");
  if (!file) return base::failure(file.error());
  std::string rest;
  std::vector<char> buffer(1 << 20);
  while (true) {
    const auto count = files::read_some(file->number(), buffer, path);
    if (!count) return base::failure(count.error());
    if (*count == 0) return {};
    rest.append(buffer.data(), *count);
    take_lines(rest, line);
    if (files::interrupted()) return base::failure(files::interruption());
  }
}

bool is_written(const std::string& path) {
  const files::Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  return file && ::flock(file.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

base::Result<void> ShardWriter::open() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  path_ = fmt::format("{}/{}-{}-{}.jsonl", folder_, host_name(), ::getpid(),
                      std::chrono::duration_cast<std::chrono::microseconds>(now).count());
  if (auto made = files::make_folder_of(path_); !made) return made;
  auto file = files::open_descriptor(path_, O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, "cannot open");
  if (!file) return base::failure(file.error());
  file_ = std::move(*file);
  // Where the file system knows no locks, two starts at a time are not told.
  static_cast<void>(::flock(file_.number(), LOCK_EX | LOCK_NB));
  synced_ = std::chrono::steady_clock::now();
  return {};
}

base::Result<void> ShardWriter::add(const Key& key, const json::Json& result, const Spent& spent) {
  if (!file_) {
    if (auto opened = open(); !opened) return opened;
  }
  const json::Json times = json::Json::object(
      {{"begin", spent.begin}, {"end", spent.end}, {"processor_s", spent.processor}, {"build", build_}});
  const std::string behind = fmt::format("{}{}{}{}{}{}}}", key_begin, text_of(key), result_begin,
                                         result.written_in_line(), spent_begin, times.written_in_line());
  const std::string line = fmt::format("{}{}{}\n", line_begin, checksum_of(behind), behind);
  if (auto written = files::write_all(file_.number(), line, path_); !written) {
    // What was written of the line goes, so that the next one is whole; where it cannot, that is another shard's.
    if (::ftruncate(file_.number(), size_) != 0) file_ = files::Descriptor();
    return written;
  }
  size_ += static_cast<std::int64_t>(line.size());
  is_dirty_ = true;
  return std::chrono::steady_clock::now() - synced_ < time_between_syncs ? base::Result<void>() : sync();
}

base::Result<void> ShardWriter::sync() {
  if (!is_dirty_) return {};
  is_dirty_ = false;
  synced_ = std::chrono::steady_clock::now();
  if (::fdatasync(file_.number()) == 0 || errno == EINVAL) return {};
  return base::failure(files::system_failure("io-write", "cannot write", path_, errno));
}

// A line whose checksum is right is as add() has written it; in a text of JSON no quotation mark stands bare.
ShardParts parts_of(const ShardLine& line) {
  const std::size_t begin = key_place + key_digits + result_begin.size();
  const std::size_t end = line.text.rfind(spent_begin);
  if (end == std::string_view::npos || end < begin || !line.text.ends_with('}')) return {};
  const std::string_view spent = line.text.substr(end + spent_begin.size());
  return {line.text.substr(begin, end - begin), spent.substr(0, spent.size() - 1)};
}

base::Result<void> for_each_line(const std::string& folder, const std::function<void(const ShardLine&)>& line) {
  const auto paths = shards_of(folder);
  if (!paths) return base::failure(paths.error());
  for (const std::string& path : *paths) {
    if (auto read = read_shard(path, line); !read) return read;
  }
  return {};
}

base::Result<void> await_writers(const std::string& folder, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  const auto paths = shards_of(folder);
  if (!paths) return base::failure(paths.error());
  for (const std::string& path : *paths) {
    while (is_written(path)) {
      if (files::interrupted()) return base::failure(files::interruption());
      if (Clock::now() > deadline)
        return base::failure({base::Severity::error,
                              "sweep-in-use",
                              "another sweep writes its results here",
                              "wait for its end, or choose another --out",
                              {.file = path},
                              {}});
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  return {};
}

}  // namespace leadscrew::sweep
