#pragma once
// Adaptive control beside a simulated program: the cut is fed what the slides travel, and moves the program's override.
//
// Each override that the program is given makes it plan anew, which is costly, and most changes are the sensor's noise.
// So it is given the override's mean over 100 ms, when that has moved by 0.5 %; and the override itself when the sensor
// has failed, or as soon as it is off by more than 10 % or the sensor's noise, nearly six times what is left of noise
// in the mean of 32 forces.

#include <leadscrew/cli/job.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/pipeline/programmed_feed.hpp>
#include <leadscrew/results/simulate_figures.hpp>
#include <leadscrew/servo/servo.hpp>
#include <memory>

namespace leadscrew::cli {

class AdaptiveRun {
 public:
  /// Does nothing where no adaptive control was asked for; else has the program, before its first word, plan in short
  /// slices. File and job must outlive it. Errors: those of servo::AdaptiveCut, and `usage` where no limit is told and
  /// nothing cuts.
  static base::Result<std::unique_ptr<AdaptiveRun>> create(const files::InputFile& file, const Job& job,
                                                           pipeline::Program& program);

  /// A period: what was followed, and the feed that was measured meanwhile, mm/s.
  void follow(const servo::Followed& followed, double measured_feed, pipeline::Program& program);

  /// With the time of the program at the safe feed. Errors: reading the file, `interrupted`.
  base::Result<std::optional<results::AdaptiveFigures>> conclude() const;

 private:
  AdaptiveRun(const files::InputFile& file, const Job& job);
  base::Result<double> time_at(double factor) const;

  const files::InputFile& file_;
  const Job& job_;
  gcode::Reader reader_;
  pipeline::ProgrammedFeed programmed_;
  std::optional<servo::AdaptiveCut> cut_;
  double limit_ = 0;
  double noise_ = 0;  ///< of the sensor, share of the limit
  double mean_ = 1;   ///< of the override
  double told_ = 1;   ///< to the program
};

}  // namespace leadscrew::cli
