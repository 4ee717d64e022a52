#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>

namespace leadscrew::files {

namespace {

base::Diagnostic problem(std::string_view code, std::string message, const std::string& file, std::string hint = {}) {
  return {base::Severity::error, code, std::move(message), std::move(hint), base::Place{.file = file}, {}};
}

base::Diagnostic ended_early(std::int64_t at, std::int64_t size, const std::string& file) {
  return problem(
      "io-read",
      "ends at byte " + std::to_string(at) + " but had " + std::to_string(size) + " bytes when it was opened", file,
      "do not change a file while it is read");
}

/// A file that has no name and goes when it is closed.
base::Result<Descriptor> anonymous_file() {
  const char* folder = std::getenv("TMPDIR");
  const std::string where = folder != nullptr && *folder != '\0' ? folder : "/tmp";
  const int number = ::open(where.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (number >= 0) return Descriptor(number);
  std::string name = where + "/leadscrew-XXXXXX";
  Descriptor named(::mkostemp(name.data(), O_CLOEXEC));
  if (!named) return base::failure(system_failure("io-open", "cannot make a temporary file", where, errno));
  ::unlink(name.c_str());
  return named;
}

/// 1 GiB, 16 MiB, 64 KiB or 100 bytes.
std::string size_text(std::int64_t bytes) {
  for (const auto& [unit, shift] : {std::pair(" GiB", 30), {" MiB", 20}, {" KiB", 10}}) {
    if (bytes > 0 && bytes % (std::int64_t{1} << shift) == 0) return std::to_string(bytes >> shift) + unit;
  }
  return std::to_string(bytes) + " bytes";
}

base::Diagnostic too_large(const std::string& name, std::int64_t largest, std::string hint) {
  return problem("input-too-large", "is larger than " + size_text(largest), name, std::move(hint));
}

base::Result<Descriptor> copied(const Descriptor& from, const std::string& name, std::int64_t largest) {
  auto copy = anonymous_file();
  if (!copy) return copy;
  std::array<char, 1 << 16> buffer;
  for (std::int64_t length = 0;;) {
    const auto got = read_some(from.number(), buffer, name);
    if (!got) return base::failure(got.error());
    if (*got == 0) return copy;
    length += static_cast<std::int64_t>(*got);
    if (length > largest) {
      return base::failure(too_large(name, largest, "what can be read only once is copied first; give it as a file"));
    }
    auto written = write_all(copy->number(), {buffer.data(), *got}, "temporary copy of " + name);
    if (!written) return base::failure(written.error());
  }
}

base::Result<Descriptor> with_text(std::string_view text, const std::string& name) {
  auto file = anonymous_file();
  if (!file) return file;
  auto written = write_all(file->number(), text, "temporary file of " + name);
  if (!written) return base::failure(written.error());
  ::lseek(file->number(), 0, SEEK_SET);
  return file;
}

base::Result<Descriptor> opened(const std::string& path) {
  if (path == "-") return Descriptor(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3));
  return open_descriptor(path, O_RDONLY, "cannot open");
}

bool can_be_read_twice(const Descriptor& descriptor, const struct stat& status) {
  return S_ISREG(status.st_mode) && ::lseek(descriptor.number(), 0, SEEK_CUR) == 0;
}

bool differ(const timespec& a, const timespec& b) {
  return a.tv_sec != b.tv_sec || a.tv_nsec != b.tv_nsec;
}

}  // namespace

InputFile::InputFile(std::string name, std::string_view changed)
    : name_(std::move(name)),
      changed_(problem(changed, "was changed while it was read", name_, "do not change a file while it is read")),
      text_(changed_) {}

base::Result<InputFile> InputFile::open(const std::string& path, std::string_view changed, std::int64_t largest) {
  InputFile file(path == "-" ? "<stdin>" : path, changed);
  auto descriptor = opened(path);
  if (!descriptor) return base::failure(descriptor.error());
  if (auto taken = file.take(std::move(*descriptor), largest); !taken) return base::failure(taken.error());
  return file;
}

base::Result<InputFile> InputFile::of_text(std::string_view text, const std::string& name) {
  InputFile file(name, "program-changed");
  auto descriptor = with_text(text, name);
  if (!descriptor) return base::failure(descriptor.error());
  if (auto taken = file.take(std::move(*descriptor), largest_copy); !taken) return base::failure(taken.error());
  return file;
}

base::Result<void> InputFile::take(Descriptor descriptor, std::int64_t largest) {
  descriptor_ = std::move(descriptor);
  if (::fstat(descriptor_.number(), &opened_) != 0)
    return base::failure(system_failure("io-open", "cannot open", name_, errno));
  if (S_ISDIR(opened_.st_mode))
    return base::failure(problem("io-open", "is a directory", name_, "give the files in it"));
  if (!can_be_read_twice(descriptor_, opened_)) {
    auto copy = copied(descriptor_, name_, largest);
    if (!copy) return base::failure(copy.error());
    descriptor_ = std::move(*copy);
    ::fstat(descriptor_.number(), &opened_);
  }
  size_ = opened_.st_size;
  return {};
}

base::Result<std::size_t> InputFile::read_at(std::int64_t offset, std::span<char> buffer) const {
  // Not beyond the size it had: what is appended meanwhile is not part of this run.
  const auto wanted = std::min<std::int64_t>(static_cast<std::int64_t>(buffer.size()), size_ - offset);
  if (wanted <= 0) return std::size_t{0};
  while (true) {
    if (interrupted()) return base::failure(interruption());
    const ssize_t got = ::pread(descriptor_.number(), buffer.data(), static_cast<std::size_t>(wanted), offset);
    if (got > 0) return static_cast<std::size_t>(got);
    if (got == 0) return base::failure(ended_early(offset, size_, name_));
    if (errno != EINTR) return base::failure(system_failure("io-read", "cannot read", name_, errno));
  }
}

base::ByteSource InputFile::reading(std::int64_t offset, std::int64_t* position) const {
  return [this, position, offset](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    auto got = read_at(offset, buffer);
    if (!got) return got;
    offset += static_cast<std::int64_t>(*got);
    if (position != nullptr) *position = offset;
    return got;
  };
}

base::ByteSource InputFile::source(std::int64_t* position) const {
  return text_.source(reading(0, position));
}

base::ByteSource InputFile::source_at(std::int64_t offset) const {
  return text_.source_at(offset, [this](std::int64_t from) { return reading(from, nullptr); });
}

base::Result<void> InputFile::unchanged() const {
  struct stat now = {};
  ::fstat(descriptor_.number(), &now);
  if (now.st_size != opened_.st_size || differ(now.st_mtim, opened_.st_mtim)) return base::failure(changed_);
  for (const auto& [name, file] : subprograms_) {
    if (auto same = file->unchanged(); !same) return same;
  }
  return {};
}

bool InputFile::is_same(const std::string& path) const {
  struct stat other = {};
  return ::stat(path.c_str(), &other) == 0 && other.st_dev == opened_.st_dev && other.st_ino == opened_.st_ino;
}

base::Result<std::string> read_whole(const std::string& path, std::int64_t largest) {
  constexpr const char* hint = "is this the right file?";
  auto file = InputFile::open(path, "file-changed", largest);
  if (!file) {
    if (file.error().code == "input-too-large") file.error().hint = hint;
    return base::failure(file.error());
  }
  if (file->size() > largest) return base::failure(too_large(path, largest, hint));
  return all_of(file->source(), file->size(), path);
}

base::Result<std::string> all_of(const base::ByteSource& source, std::int64_t size, const std::string& name) {
  std::string text(static_cast<std::size_t>(size), '\0');
  for (std::size_t filled = 0; filled < text.size();) {
    const auto got = source(std::span(text).subspan(filled));
    if (!got) return base::failure(got.error());
    if (*got == 0) return base::failure(ended_early(static_cast<std::int64_t>(filled), size, name));
    filled += *got;
  }
  return text;
}

}  // namespace leadscrew::files
