// Loads machine files by the installed package: the name and the limit of X of each, or its problems with their places.

#include <cstdio>
#include <leadscrew/files.hpp>

int main(int count, char** paths) {
  for (int i = 1; i < count; ++i) {
    const auto machine = leadscrew::config::load_machine(paths[i]);
    if (machine) {
      std::printf("%s: X %g mm/s\n", machine->name.c_str(), machine->limits(leadscrew::base::Axis::X).velocity);
      continue;
    }
    for (const auto& problem : machine.error()) {
      std::printf("line %lld: %.*s\n", static_cast<long long>(problem.place.line),
                  static_cast<int>(problem.code.size()), problem.code.data());
    }
  }
}
