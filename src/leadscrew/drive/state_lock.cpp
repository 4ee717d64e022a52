#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <ctime>
#include <filesystem>
#include <leadscrew/drive/state_lock.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>

namespace leadscrew::drive {

namespace {

constexpr int most_attempts = 250;
constexpr timespec between_attempts{0, 20'000'000};

std::string lock_path(const std::string& state) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(files::target_of(state), error);
  return whole.parent_path() / (".leadscrew-" + whole.filename().string() + ".lock");
}

bool needs_no_lock(const std::string& state) {
  struct stat status = {};
  return ::stat(state.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

/// Another user's file of this name could be held for ever.
base::Result<void> check_owner(const struct stat& status, const std::string& path) {
  if (S_ISREG(status.st_mode) && status.st_uid == ::geteuid()) return {};
  base::Diagnostic problem = files::system_failure("io-open", "the lock belongs to somebody else", path, EPERM);
  problem.hint = "keep the state in a folder that nobody else can write to";
  return base::failure(std::move(problem));
}

enum class Attempt : std::uint8_t { held, busy, gone };

base::Result<Attempt> try_to_hold(const std::string& path, files::Descriptor& descriptor) {
  descriptor = files::Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0600));
  if (!descriptor) {
    if (errno == EINTR) return Attempt::busy;
    return base::failure(files::system_failure("io-open", "cannot hold", path, errno));
  }
  struct stat held = {}, named = {};
  ::fstat(descriptor.number(), &held);
  if (auto own = check_owner(held, path); !own) return base::failure(own.error());
  if (::flock(descriptor.number(), LOCK_EX | LOCK_NB) != 0) return Attempt::busy;
  const bool is_named = ::stat(path.c_str(), &named) == 0 && named.st_dev == held.st_dev && named.st_ino == held.st_ino;
  return is_named ? Attempt::held : Attempt::gone;
}

}  // namespace

base::Result<StateLock> StateLock::hold(const std::string& state) {
  StateLock lock;
  if (needs_no_lock(state)) return lock;
  if (auto made = files::make_folder_of(state); !made) return base::failure(made.error());
  const std::string path = lock_path(state);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    if (files::interruptions() > 0) return base::failure(files::interruption());
    const auto result = try_to_hold(path, lock.descriptor_);
    if (!result) return base::failure(result.error());
    if (*result == Attempt::held) {
      lock.path_ = path;
      return lock;
    }
    if (*result == Attempt::busy) ::nanosleep(&between_attempts, nullptr);
  }
  return base::failure({base::Severity::error,
                        "state-busy",
                        "is being kept by another drive",
                        "let that one end, or name another file",
                        base::Place{.file = state},
                        {}});
}

void StateLock::remove_file() {
  if (!path_.empty()) ::unlink(path_.c_str());
  path_.clear();
}

}  // namespace leadscrew::drive
