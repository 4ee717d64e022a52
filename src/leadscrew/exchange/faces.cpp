#include <sys/stat.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/exchange/face_lines.hpp>
#include <leadscrew/exchange/faces.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/files/interrupt.hpp>

namespace leadscrew::exchange {

namespace {

constexpr std::int64_t largest_file = std::int64_t{1} << 28, largest_line = std::int64_t{1} << 26,
                       largest_answer = std::int64_t{1} << 30;  // bytes

base::Diagnostic problem(std::string_view code, std::string message, std::string hint, const std::string& file) {
  base::Diagnostic diagnostic = base::problem(code, std::move(message), std::move(hint));
  diagnostic.place.file = file;
  return diagnostic;
}

/// The code as static storage: what other programs say is not.
base::Diagnostic told_problem(const Refusal& told, const std::string& file) {
  if (told.code == "exchange-faces") return problem("exchange-faces", told.why, told.hint, file);
  return problem("exchange-read", told.why, told.hint, file);
}

/// That it can be opened, is not too large, and begins as one of the two formats does.
base::Result<std::string_view> checked_format(const std::string& file) {
  const auto descriptor = files::open_descriptor(file, O_RDONLY | O_CLOEXEC, "cannot open");
  if (!descriptor) return base::failure(descriptor.error());
  struct stat status = {};
  if (::fstat(descriptor->number(), &status) != 0)
    return base::failure(files::system_failure("io-read", "cannot read", file, errno));
  if (S_ISDIR(status.st_mode)) return base::failure(files::system_failure("io-read", "cannot read", file, EISDIR));
  if (!S_ISREG(status.st_mode))
    return base::failure(problem("io-read", "is no regular file", "it is read more than once", file));
  if (status.st_size > largest_file) {
    return base::failure(problem("input-too-large", "is larger than " + std::to_string(largest_file >> 20) + " MiB",
                                 "write the faces that are machined into a file of their own", file));
  }
  std::array<char, 4096> beginning;
  const auto length = files::read_some(descriptor->number(), beginning, file);
  if (!length) return base::failure(length.error());
  const std::string_view format = format_of({beginning.data(), *length});
  if (format.empty()) {
    return base::failure(problem("exchange-format", *length == 0 ? "is empty" : "is neither STEP nor IGES",
                                 "STEP begins with ISO-10303-21; and IGES has an S in column 73 of its first line",
                                 file));
  }
  return format;
}

/// A program that has been started, whose standard output is read; it ends with this.
class Child {
 public:
  static base::Result<Child> start(const std::string& program, std::vector<std::string> words) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      return base::failure(files::system_failure("io-open", "cannot start", program, errno));
    Child child;
    child.output_ = files::Descriptor(ends[0]);
    const files::Descriptor input(ends[1]);
    std::vector<char*> arguments;
    words.insert(words.begin(), program);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    child.id_ = ::fork();
    if (child.id_ < 0) return base::failure(files::system_failure("io-open", "cannot start", program, errno));
    if (child.id_ == 0) {
      ::dup2(input.number(), STDOUT_FILENO);
      ::execv(program.c_str(), arguments.data());
      ::_exit(127);
    }
    return child;
  }
  Child(Child&& other) noexcept : output_(std::move(other.output_)), id_(std::exchange(other.id_, 0)) {}
  Child& operator=(Child&&) = delete;
  ~Child() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    end();
  }

  int output() const { return output_.number(); }
  /// Waits for its end; its status as waitpid(2) has it.
  int end() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) continue;
    id_ = 0;
    return status;
  }

 private:
  Child() = default;

  files::Descriptor output_;
  ::pid_t id_ = 0;
};

/// Takes the lines that a program writes, to their end. Errors: `exchange-read` of what is no such line, interruption.
base::Result<void> take_lines(int output, FaceLines& lines, const std::string& file) {
  const auto not_understood = [&] {
    return base::failure(problem("exchange-read", "leadscrew-exchange answers what cannot be understood",
                                 "is it of the same version as this program?", file));
  };
  std::string text;
  std::array<char, 1 << 16> buffer;
  for (std::int64_t total = 0;;) {
    const auto got = files::read_some(output, buffer, file);
    if (!got) return base::failure(got.error());
    total += static_cast<std::int64_t>(*got);
    if (*got == 0) return text.empty() ? base::Result<void>() : not_understood();
    const std::size_t searched = text.size();
    text.append(buffer.data(), *got);
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n', searched); end != std::string::npos; end = text.find('\n', begin)) {
      if (!lines.take(std::string_view(text).substr(begin, end - begin))) return not_understood();
      begin = end + 1;
    }
    text.erase(0, begin);
    if (total > largest_answer || static_cast<std::int64_t>(text.size()) > largest_line) {
      return base::failure(problem("input-too-large", "has more and larger faces than can be held",
                                   "write the faces that are machined into a file of their own", file));
    }
  }
}

std::string_view name_of(surfaces::Direction direction) {
  return direction == surfaces::Direction::u ? "u" : "v";
}

Refusal refused(std::string_view code, std::string why, std::string hint) {
  return {std::string(code), std::move(why), std::move(hint)};
}

std::optional<Refusal> refusal_of(const surfaces::SurfaceForm& form) {
  using Kind = surfaces::SurfaceFault::Kind;
  const auto fault = surfaces::fault_of(form);
  if (!fault) return std::nullopt;
  const std::string index = std::to_string(fault->index + 1), of = " of " + std::string(name_of(fault->direction));
  switch (fault->kind) {
    case Kind::normal:
      return refused("face-normal", "has no normal at u " + base::text(fault->u, 6) + ", v " + base::text(fault->v, 6),
                     "split it in the CAD system where it comes to a point");
    case Kind::rows:
      return refused("face-net", "row " + index + of + " of its control points falls on the row before", {});
    case Kind::counts:
      return refused("face-net", "has wrong numbers of knots or control points" + of, {});
    case Kind::not_finite:
      return refused("face-net", "has a number that is not finite", {});
    case Kind::weight:
      return refused("face-net", "weight " + index + " is not above 0", {});
    case Kind::knots:
      return refused("face-net", "knot " + index + of + " is out of order", {});
  }
  return std::nullopt;
}

}  // namespace

std::string_view format_of(std::string_view beginning) {
  constexpr std::size_t section_column = 72;
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  if (beginning.substr(first).starts_with("ISO-10303-21;")) return "STEP";
  const std::string_view line = beginning.substr(0, beginning.find_first_of("\r\n"));
  return line.size() == 80 && line[section_column] == 'S' && line.find_first_not_of(" 0123456789", 73) == line.npos
             ? "IGES"
             : std::string_view();
}

std::string reading_program() {
  std::error_code error;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return {};
  for (const auto& place : {folder / "leadscrew-exchange", folder / "../libexec/leadscrew/leadscrew-exchange"}) {
    if (::access(place.c_str(), X_OK) == 0) return place.string();
  }
  return {};
}

base::Result<Faces> read_faces(const std::string& program, const std::string& file, std::optional<double> tolerance) {
  if (program.empty()) {
    return base::failure(problem("exchange-not-built", "STEP and IGES cannot be read by this build",
                                 "build with -DLEADSCREW_EXCHANGE=ON, which needs Debian's libocct-data-exchange-dev",
                                 {}));
  }
  const auto format = checked_format(file);
  if (!format) return base::failure(format.error());
  auto child = Child::start(program, {std::string(*format), file, base::text(tolerance.value_or(0))});
  if (!child) return base::failure(child.error());
  FaceLines lines;
  if (auto taken = take_lines(child->output(), lines, file); !taken) return base::failure(taken.error());
  const int status = child->end();
  if (files::interrupted()) return base::failure(files::interruption());
  if (lines.problem()) return base::failure(told_problem(*lines.problem(), file));
  if (!lines.ended() || status != 0) {
    const std::string how = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                                : "status " + std::to_string(WEXITSTATUS(status));
    return base::failure(problem("exchange-read", "OpenCASCADE cannot read it: leadscrew-exchange ended with " + how,
                                 "is the file whole? Export it anew, or in the other format", file));
  }
  for (Face& face : lines.faces.faces) {
    if (face.form && !face.refusal) face.refusal = refusal_of(*face.form);
  }
  return std::move(lines.faces);
}

}  // namespace leadscrew::exchange
