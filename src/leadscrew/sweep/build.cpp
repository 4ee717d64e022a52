#include <fcntl.h>
#include <fmt/format.h>

#include <leadscrew/base/hash.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/sweep/build.hpp>
#include <vector>

namespace leadscrew::sweep {

namespace {

std::string name_of_running_command() {
  const std::string path = "/proc/self/exe";
  const auto file = files::open_descriptor(path, O_RDONLY | O_CLOEXEC, "cannot open");
  if (!file) return LEADSCREW_VERSION;
  base::Hash bytes;
  std::vector<char> buffer(1 << 20);
  while (true) {
    const auto count = files::read_some(file->number(), buffer, path);
    if (!count) return LEADSCREW_VERSION;
    if (*count == 0) return fmt::format("{} {:016x}", LEADSCREW_VERSION, bytes.value());
    bytes.add({buffer.data(), *count});
  }
}

}  // namespace

const std::string& build_name() {
  static const std::string name = name_of_running_command();
  return name;
}

}  // namespace leadscrew::sweep
