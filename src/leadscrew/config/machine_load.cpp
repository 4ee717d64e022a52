#include <cerrno>
#include <cstdio>
#include <leadscrew/config/machine_file.hpp>
#include <memory>
#include <system_error>

namespace leadscrew::config {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

base::Diagnostic system_problem(std::string_view code, const char* what, const std::string& path, int error) {
  base::Diagnostic problem = base::problem(code, std::string(what) + ": " + std::generic_category().message(error), "");
  problem.place.file = path;
  return problem;
}

}  // namespace

base::Diagnostic too_large(const std::string& file) {
  base::Diagnostic problem = base::problem("input-too-large", "is larger than 512 KiB", "is this a machine file?");
  problem.place.file = file;
  return problem;
}

MachineOrProblems load_machine(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) {
    return tl::unexpected(std::vector{system_problem("io-open", "cannot open", path, errno)});
  }
  std::string text(largest_machine_file + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get()) != 0) {
    return tl::unexpected(std::vector{system_problem("io-read", "cannot read", path, errno)});
  }
  return read_machine(text, path);
}

}  // namespace leadscrew::config
