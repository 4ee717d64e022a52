// The calls of leadscrew.h that read machine files.

#include <leadscrew/config/machine_file.hpp>

#include "handles.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

namespace {

int give_machine(config::MachineOrProblems read, leadscrew_machine** machine, leadscrew_error* error) {
  return with_read(std::move(read), error,
                   [&](machine::Machine made) { *machine = new leadscrew_machine{std::move(made)}; });
}

}  // namespace

int leadscrew_machine_of_text(const char* text, size_t length, leadscrew_machine** machine, leadscrew_error* error) {
  if (!is_text(text, length) || machine == nullptr)
    return misuse(error, "the text or the place for the machine is NULL, or the length is none that memory holds");
  return guarded(error, [&] { return give_machine(config::read_machine({text, length}, {}), machine, error); });
}

int leadscrew_machine_of_file(const char* path, leadscrew_machine** machine, leadscrew_error* error) {
  if (path == nullptr || machine == nullptr) return misuse(error, "the path or the place for the machine is NULL");
  return guarded(error, [&] { return give_machine(config::load_machine(path), machine, error); });
}
