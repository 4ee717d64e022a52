// What leadscrew.run() of Python does, by the library: a program is read, its words are made into one array and judged, and
// what each block loses is counted. For who counts the instructions of both (words.py).
//
//   words_in_cpp PROGRAM  prints how many words it has kept, and whether every limit is

#include <cstdio>
#include <fstream>
#include <iterator>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>
#include <leadscrew/referee/referee.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace leadscrew;

constexpr std::size_t words_together = 1024;
const machine::ToolTable no_tools;

struct Kept {
  std::vector<base::Word> words;
  std::vector<pipeline::BlockTime> blocks;
  referee::Verdict verdict;
};

bool is_sound(const std::string& text, const machine::Machine& machine) {
  bool sound = true;
  gcode::Reader reader(gcode::text_source(text), machine, no_tools, {}, [&](const base::Diagnostic& found) {
    sound = sound && found.severity != base::Severity::error;
  });
  pipeline::read_whole(reader, {});
  return sound;
}

Kept run(const std::string& text, const machine::Machine& machine) {
  Kept kept;
  pipeline::Program program(gcode::text_source(text), machine, no_tools, {}, nullptr);
  pipeline::LostTime lost(machine, [&](const pipeline::BlockTime& time) { kept.blocks.push_back(time); });
  program.on_move([&](const gcode::Move& move) { lost.observe(move); });
  auto moves =
      std::make_shared<gcode::Reader>(gcode::text_source(text), machine, no_tools, gcode::ReaderOptions{}, nullptr);
  referee::Referee referee([moves](gcode::Move& move) { return moves->next(move); }, machine, machine.period);
  while (program.prepare()) {
    const std::size_t before = kept.words.size();
    kept.words.resize(before + words_together);
    const auto made = program.cycle(std::span(kept.words).subspan(before));
    for (const base::Word& word : made) {
      referee.observe(word.position, word.feed);
      lost.observe(word);
    }
    kept.words.resize(before + made.size());
  }
  lost.finish();
  kept.verdict = referee.conclude();
  return kept;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ifstream file(arguments[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const machine::Machine machine = machine::mill3();
  if (!file || !is_sound(text, machine)) return 2;
  const Kept kept = run(text, machine);
  std::printf("%zu %s\n", kept.words.size(), kept.verdict.objects() ? "broken" : "kept");
  return kept.verdict.objects() ? 1 : 0;
}
