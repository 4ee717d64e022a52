#include <sys/stat.h>

#include <filesystem>
#include <leadscrew/files/same_output.hpp>

namespace leadscrew::files {

namespace {

/// /dev/null, a pipe: what exists and is no regular file.
bool is_special(const std::string& path) {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

/// The path by which two spellings of one file are equal.
std::filesystem::path normal(const std::string& path) {
  std::error_code error;
  const std::filesystem::path known = std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
  return error ? std::filesystem::path(path).lexically_normal() : known;
}

}  // namespace

bool is_same_output(const std::string& path, const std::string& other) {
  std::error_code error;
  return !is_special(path) && (normal(path) == normal(other) || std::filesystem::equivalent(path, other, error));
}

}  // namespace leadscrew::files
