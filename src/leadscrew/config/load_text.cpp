#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <leadscrew/config/load_text.hpp>
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

base::Result<std::string> load_text(const std::string& path, std::size_t most) {
  constexpr std::size_t piece = std::size_t{64} * 1024;
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) return base::failure(system_problem("io-open", "cannot open", path, errno));
  std::string text;
  for (bool more = true; more && text.size() < most;) {
    const std::size_t filled = text.size();
    text.resize(std::min(filled + piece, most));
    const std::size_t got = std::fread(text.data() + filled, 1, text.size() - filled, file.get());
    if (std::ferror(file.get()) != 0) return base::failure(system_problem("io-read", "cannot read", path, errno));
    more = filled + got == text.size();
    text.resize(filled + got);
  }
  return text;
}

}  // namespace leadscrew::config
