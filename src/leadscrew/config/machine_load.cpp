#include <leadscrew/config/load_text.hpp>
#include <leadscrew/config/machine_file.hpp>

namespace leadscrew::config {

base::Diagnostic too_large(const std::string& file) {
  base::Diagnostic problem = base::problem("input-too-large", "is larger than 512 KiB", "is this a machine file?");
  problem.place.file = file;
  return problem;
}

MachineOrProblems load_machine(const std::string& path) {
  const auto text = load_text(path, largest_machine_file + 1);
  if (!text) return tl::unexpected(std::vector{text.error()});
  return read_machine(*text, path);
}

}  // namespace leadscrew::config
