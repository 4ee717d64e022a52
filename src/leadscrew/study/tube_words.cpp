#include <leadscrew/base/number_text.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/study/tube_words.hpp>

namespace leadscrew::study {

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
    text += base::text(base::seconds(base::Tick{static_cast<std::int64_t>(k)}, period));
    for (const double coordinate : {words[k].x, words[k].y}) text += ',' + base::text(coordinate);
    text += ",0\n";
  }
  return text;
}

}  // namespace leadscrew::study
