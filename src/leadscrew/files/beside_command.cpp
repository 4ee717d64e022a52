#include <leadscrew/files/beside_command.hpp>
#include <leadscrew/files/descriptor.hpp>

namespace leadscrew::files {

base::Result<std::filesystem::path> command_folder() {
  constexpr const char* running = "/proc/self/exe";
  std::error_code error;
  const auto command = std::filesystem::read_symlink(running, error);
  if (error) return base::failure(system_failure("io-open", "cannot open", running, error.value()));
  return command.parent_path();
}

std::optional<std::filesystem::path> beside_command(std::initializer_list<std::string> names) {
  const auto folder = command_folder();
  if (!folder) return std::nullopt;
  for (const std::string& name : names) {
    std::error_code error;
    auto path = (*folder / name).lexically_normal();
    if (std::filesystem::is_regular_file(path, error)) return path;
  }
  return std::nullopt;
}

}  // namespace leadscrew::files
