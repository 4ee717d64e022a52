#include <leadscrew/cli/command.hpp>

int main(int count, char** values) {
  return leadscrew::cli::command(count, values);
}
