#pragma once
// A program run to its end, with the events that its words passed.

#include <leadscrew/pipeline/program.hpp>
#include <string>
#include <vector>

namespace leadscrew::testing_support {

struct Motion {
  std::vector<base::Word> words;
  std::vector<base::PassedEvent> events;
  std::string problems;
};

inline Motion run_with_events(const std::string& text, const machine::Machine& machine = machine::mill3(),
                              double slice = 0) {
  const machine::ToolTable tools;
  Motion motion;
  pipeline::Program program(gcode::text_source(text), machine, tools, {},
                            [&](const base::Diagnostic& problem) { motion.problems += problem.message + '\n'; });
  program.on_event([&](const base::PassedEvent& event) { motion.events.push_back(event); });
  if (slice > 0) program.slice(slice);
  while (program.prepare()) motion.words.push_back(program.cycle());
  return motion;
}

inline double seconds(const Motion& motion) {
  return base::seconds(motion.words.back().tick, machine::mill3().period);
}

inline std::string numbered(const char* letters, int k) {
  return letters + std::to_string(k);
}

}  // namespace leadscrew::testing_support
