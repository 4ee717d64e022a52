#pragma once
// What is moved along: the text of a part program, or moves of a host. Each is read as often as somebody needs it, by
// readers that know nothing of each other.

#include <leadscrew/base/result.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>
#include <leadscrew/referee/referee.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problems.hpp"
#include "watch.hpp"

namespace leadscrew::python {

/// What reading a program whole has told.
struct Reading {
  pipeline::ReadProgram program;
  Diagnostics diagnostics;
  double seconds = 0;  ///< of the processor

  bool has_errors() const;
};

class Work {
 public:
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// While one of them lives, something is done with the work. Made and ended with the interpreter's lock; meanwhile other
  /// threads may have it.
  class Use {
   public:
    explicit Use(const Work& work) : work_(work) { ++work_.uses_; }
    ~Use() { --work_.uses_; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    const Work& work_;
  };
  bool is_in_use() const { return uses_ > 0; }

  const machine::Machine& machine() const { return machine_; }
  const std::string& name() const { return name_; }
  const base::AxisVector& start() const { return start_; }

  /// Reads all of it; without the lock.
  virtual Reading read(Watch& watch, pipeline::Survey* survey = nullptr) const = 0;
  /// The motion along it, word by word.
  virtual std::unique_ptr<pipeline::Program> program(Watch& watch) const = 0;
  /// The motion along it, chunk by chunk.
  virtual std::unique_ptr<pipeline::MotionSource> motion(Watch& watch) const = 0;
  /// Its moves, for a referee.
  virtual referee::MoveSource moves() const = 0;
  /// Is its text still the one that was read?
  virtual base::Result<void> unchanged() const { return {}; }

 protected:
  Work(machine::Machine machine, std::string name, const base::AxisVector& start)
      : machine_(std::move(machine)), name_(std::move(name)), start_(start) {}

 private:
  const machine::Machine machine_;
  std::string name_;
  base::AxisVector start_;
  mutable int uses_ = 0;
};

/// How a program is read.
struct TextOptions {
  std::string tools{};                     ///< text of the tool table; empty: none
  std::string tools_name = "<tools>";      ///< for places in diagnostics
  std::vector<std::string> subprograms{};  ///< folders
  std::optional<gcode::PathMode> mode{};
  std::optional<double> tolerance{};  ///< mm
  std::int64_t fuel = 100'000'000;
  bool allows_gouging = false;
  interpolator::StepRule step_rule = interpolator::StepRule::arc_length;
};

class TextWork : public Work {
 public:
  /// With the lock: raises what is wrong with the tool table.
  TextWork(machine::Machine machine, files::InputFile file, const base::AxisVector& start, const TextOptions& options);

  Reading read(Watch& watch, pipeline::Survey* survey) const override;
  std::unique_ptr<pipeline::Program> program(Watch& watch) const override;
  std::unique_ptr<pipeline::MotionSource> motion(Watch& watch) const override;
  referee::MoveSource moves() const override;
  base::Result<void> unchanged() const override { return file_.unchanged(); }

 private:
  gcode::ReaderOptions reading() const;
  enum class Tells : std::uint8_t { nothing, share };
  /// In pieces between which it is asked whether to go on; tells the share that has been read, if that is to be told.
  gcode::ByteSource asking(Watch& watch, Tells tells) const;
  template <class Joined>
  std::unique_ptr<Joined> joined(Watch& watch) const;

  files::InputFile file_;
  TextOptions options_;
  machine::ToolTable tools_;
  std::shared_ptr<gcode::SurfaceDrafts> surface_drafts_ = gcode::new_surface_drafts();
};

class MoveWork : public Work {
 public:
  MoveWork(machine::Machine machine, const std::string& name, const base::AxisVector& start)
      : Work(std::move(machine), name, start), queue_(this->machine(), start) {}

  const host::MoveQueue& queue() const { return queue_; }
  /// With the lock. RuntimeError where the path is in use: by another thread, or by a run whose progress function asks.
  host::MoveQueue& queue_to_change();

  Reading read(Watch& watch, pipeline::Survey* survey) const override;
  std::unique_ptr<pipeline::Program> program(Watch& watch) const override;
  std::unique_ptr<pipeline::MotionSource> motion(Watch& watch) const override;
  referee::MoveSource moves() const override;

 private:
  template <class Joined>
  std::unique_ptr<Joined> joined(Watch& watch) const;

  host::MoveQueue queue_;  ///< from which nobody takes
};

}  // namespace leadscrew::python
