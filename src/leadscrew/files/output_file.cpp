#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>

namespace leadscrew::files {

namespace {

/// A hidden name in the folder of the target, unlike any other this process or another uses.
std::string temporary_name(const std::string& target) {
  static std::atomic<int> serial{0};
  const auto folder = std::filesystem::path(target).parent_path();
  return folder / (".leadscrew-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp");
}

/// Replacing the file that standard output goes to would lose what is printed there.
bool is_standard_output(const struct stat& file) {
  struct stat output = {};
  return ::fstat(STDOUT_FILENO, &output) == 0 && output.st_dev == file.st_dev && output.st_ino == file.st_ino;
}

bool is_temporary_or_lock(const std::string& name) {
  return name.starts_with(".leadscrew-") && (name.ends_with(".tmp") || name.ends_with(".lock"));
}

/// Who holds the lock of a file that still has its name is the only one that may remove it.
void remove_if_unlocked(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat opened = {}, named = {};
  if (!file || ::fstat(file.number(), &opened) != 0) return;
  if (!S_ISREG(opened.st_mode) || opened.st_uid != ::geteuid()) return;
  if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0 || ::lstat(path.c_str(), &named) != 0) return;
  if (named.st_dev == opened.st_dev && named.st_ino == opened.st_ino) ::unlink(path.c_str());
}

}  // namespace

void remove_left_behind(const std::string& path) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::path(target_of(path)).parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(parent.empty() ? "." : parent, error)) {
    if (is_temporary_or_lock(entry.path().filename().string())) remove_if_unlocked(entry.path());
  }
}

std::string target_of(const std::string& path) {
  std::error_code error;
  std::filesystem::path target = path;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(target, error); ++links) {
    target = target.parent_path() / std::filesystem::read_symlink(target, error);
  }
  return target.string();
}

base::Result<void> make_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(target_of(path)).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) return base::failure(system_failure("io-open", "cannot make the folder", folder, error.value()));
  return {};
}

bool is_standard_output(const std::string& path) {
  struct stat file = {};
  return ::stat(path.c_str(), &file) == 0 && is_standard_output(file);
}

std::string extension(const std::string& path) {
  std::string text = std::filesystem::path(path).extension();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

base::Result<OutputFile> OutputFile::create(const std::string& path, Access access) {
  OutputFile file;
  file.path_ = path;
  struct stat existing = {};
  const bool exists = ::stat(path.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) {
    return base::failure(system_failure("io-open", "cannot write", path, EISDIR));
  }
  if (exists && !S_ISREG(existing.st_mode)) {
    auto opened = open_descriptor(path, O_WRONLY, "cannot write");
    if (!opened) return base::failure(opened.error());
    file.descriptor_ = std::move(*opened);
    if (access == Access::rewritable && ::lseek(file.descriptor_.number(), 0, SEEK_CUR) < 0) {
      return base::failure(system_failure("io-open", "cannot hold this format", path, errno));
    }
    return file;
  }
  if (exists && is_standard_output(existing)) {
    return base::failure(system_failure("io-open", "cannot write to the file of standard output", path, EBUSY));
  }
  if (auto made = make_folder_of(path); !made) return base::failure(made.error());
  file.target_ = target_of(path);
  if (auto opened = file.open_temporary(); !opened) return base::failure(opened.error());
  if (exists) ::fchmod(file.descriptor_.number(), existing.st_mode & 0777);
  return file;
}

base::Result<void> OutputFile::open_temporary() {
  while (true) {
    const std::string name = temporary_name(target_);
    const int number = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (number >= 0) {
      descriptor_ = Descriptor(number);
      if (!is_locked()) continue;
      temporary_ = name;
      return {};
    }
    if (interrupted()) return base::failure(interruption());
    if (errno != EINTR && errno != EEXIST)
      return base::failure(system_failure("io-open", "cannot write", path_, errno));
  }
}

/// False if somebody took it for one that was left behind, and removed it, before it could be locked.
bool OutputFile::is_locked() const {
  // On a file system without locks no one can hold one.
  if (::flock(descriptor_.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat status = {};
  return ::fstat(descriptor_.number(), &status) == 0 && status.st_nlink > 0;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : descriptor_(std::move(other.descriptor_)),
      path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})) {}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

base::Result<void> OutputFile::write(std::string_view bytes) {
  return write_all(descriptor_.number(), bytes, path_);
}

base::Result<void> OutputFile::rewrite_start(std::string_view bytes) {
  if (::lseek(descriptor_.number(), 0, SEEK_SET) < 0) {
    return base::failure(system_failure("io-write", "cannot write", path_, errno));
  }
  return write(bytes);
}

base::ByteSink OutputFile::sink() {
  return [this](std::string_view bytes) { return write(bytes); };
}

base::Result<void> OutputFile::close() {
  if (::close(descriptor_.release()) == 0 || errno == EINTR) return {};
  return base::failure(system_failure("io-write", "cannot write", path_, errno));
}

base::Result<void> OutputFile::publish() {
  if (temporary_.empty()) return {};
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    return base::failure(system_failure("io-write", "cannot write", path_, errno));
  }
  temporary_.clear();
  return {};
}

base::Result<void> OutputFile::publish_durably() {
  if (temporary_.empty()) return {};
  const auto synchronise = [this](const Descriptor& file) -> base::Result<void> {
    if (::fsync(file.number()) == 0) return {};
    return base::failure(system_failure("io-write", "cannot write", path_, errno));
  };
  if (auto durable = synchronise(descriptor_); !durable) return durable;
  if (auto published = publish(); !published) return published;
  const std::string parent = std::filesystem::path(target_).parent_path().string();
  auto folder = open_descriptor(parent.empty() ? "." : parent, O_RDONLY | O_DIRECTORY, "cannot open");
  if (!folder) return base::failure(folder.error());
  return synchronise(*folder);
}

base::Result<void> publish_together(std::initializer_list<OutputFile*> files) {
  for (OutputFile* file : files) {
    if (file == nullptr) continue;
    if (auto closed = file->close(); !closed) return closed;
  }
  for (OutputFile* file : files) {
    if (file == nullptr) continue;
    if (auto published = file->publish(); !published) return published;
  }
  return {};
}

}  // namespace leadscrew::files
