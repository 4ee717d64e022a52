// The smallest controller: a part program in, one word a servo period out. Replace `send` by your drives.
#include <cstdio>
#include <leadscrew/program.hpp>

using namespace leadscrew;

static void send(const base::Word& word, base::Period period) {
  std::printf("%.4f s  X %.4f  Y %.4f  Z %.4f\n", base::seconds(word.tick, period), word.position[0], word.position[1],
              word.position[2]);
}

static void complain(const base::Diagnostic& diagnostic) {
  std::fprintf(stderr, "line %lld: %s\n", static_cast<long long>(diagnostic.place.line), diagnostic.message.c_str());
}

int main(int argc, char** argv) {
  std::FILE* file = argc == 2 ? std::fopen(argv[1], "rb") : nullptr;
  if (!file) return std::fprintf(stderr, "usage: controller PROGRAM\n"), 2;
  const gcode::ByteSource source = [&](std::span<char> bytes) {
    return std::fread(bytes.data(), 1, bytes.size(), file);
  };

  const machine::Machine mill = machine::mill3();
  const machine::ToolTable tools;
  gcode::Reader check(source, mill, tools, {}, complain);  // read it whole before anything moves
  for (gcode::Move move; check.next(move);) {
  }
  if (check.errors() > 0) return 3;

  std::rewind(file);
  pipeline::Program program(source, mill, tools, {}, complain);
  while (program.prepare()) send(program.cycle(), mill.period);
}
