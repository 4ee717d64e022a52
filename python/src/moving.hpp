#pragma once
// What is done with work: run, judged and simulated, each without the interpreter's lock.

#include <leadscrew/base/event.hpp>
#include <leadscrew/drive/slides.hpp>
#include <leadscrew/pipeline/trajectory.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/simulate_figures.hpp>

#include "rows.hpp"
#include "work.hpp"

namespace leadscrew::python {

/// A run of all of it, as `leadscrew run` makes it: words, what the referee says of them, where time is lost.
struct Moved {
  Words words;
  std::vector<BlockRow> blocks;
  std::vector<base::PassedEvent> events;
  Diagnostics diagnostics;
  results::RunFigures figures;
};
base::Result<Moved> run(const Work& work, const Reading& reading, Watch& watch);

/// What the referee says of positions, one a period.
base::Result<results::VerifyFigures> judge(const Work& work, const double* positions, std::size_t count, Watch& watch);

/// Under the loops of the machine's drives, as `leadscrew simulate` makes it.
struct Simulated {
  std::vector<servo::Followed> rows;
  results::SimulateFigures figures;
  Diagnostics diagnostics;
};
base::Result<Simulated> simulate(const Work& work, const Reading& reading, drive::LoopKind kind, Watch& watch);

/// The motion as polynomials of time, planned to its end.
base::Result<pipeline::Trajectory> plan(const Work& work, Watch& watch);

}  // namespace leadscrew::python
