#include <charconv>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/study/tube_words.hpp>

namespace leadscrew::study {

namespace {

void append_number(std::string& text, double value) {
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

}  // namespace

referee::Verdict judge(const PartProgram& program, const machine::Machine& machine,
                       const std::vector<PlaneVector>& words) {
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.file = "study";
  options.start = program.start;
  gcode::Reader reader(gcode::text_source(program.text), machine, tools, options, nullptr);
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  base::AxisVector position = program.start;
  for (const PlaneVector& word : words) {
    position[base::index(base::Axis::X)] = word.x;
    position[base::index(base::Axis::Y)] = word.y;
    referee.observe(position);
  }
  return referee.conclude();
}

std::string trace_of(const std::vector<PlaneVector>& words, base::Period period) {
  std::string text = "t,X,Y,Z\n";
  for (std::size_t k = 0; k < words.size(); ++k) {
    append_number(text, base::seconds(base::Tick{static_cast<std::int64_t>(k)}, period));
    for (const double coordinate : {words[k].x, words[k].y}) append_number(text += ',', coordinate);
    text += ",0\n";
  }
  return text;
}

}  // namespace leadscrew::study
