#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <leadscrew/cli/drive.hpp>
#include <leadscrew/cli/drive_beginning.hpp>
#include <leadscrew/cli/drive_checks.hpp>
#include <leadscrew/cli/drive_process.hpp>
#include <leadscrew/cli/drive_text.hpp>
#include <leadscrew/cli/drive_view.hpp>
#include <leadscrew/cli/interrupt.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/servo/machine_loops.hpp>
#include <leadscrew/servo/stability.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t frame = 20'000'000;  // ns between two looks at what happens
constexpr double least_spare = 0.1;         // s planned behind the words that are made ahead

base::Diagnostic drives_problem(std::string_view code, std::string message, std::string hint = {}) {
  return base::problem(code, std::move(message), std::move(hint));
}

class ProgramDrive {
 public:
  ProgramDrive(const std::string& program, const Job& job, Console& console, DiagnosticLog& log)
      : program_(program), job_(job), arguments_(job.arguments.drive), console_(console), log_(log) {}

  /// Nothing where the log says why.
  std::optional<DriveFigures> execute() {
    const auto file = InputFile::open(program_);
    if (!file) return failed(file.error());
    if (auto sound = check_drive(*file, job_); !sound) return failed(sound.error());
    const Reading reading = read_program(*file, job_, console_, log_);
    if (log_.errors() > 0) return std::nullopt;
    if (reading.pauses > 0 && !can_wait()) {
      log_.add(
          {base::Severity::note, "pause-passed", "M0 and M1 do not pause: no key can be pressed here", {}, {}, {}});
    }
    if (auto stable = check_loops(); !stable) return failed(stable.error());
    auto begin = DriveBeginning::of(*file, job_);
    if (!begin) return failed(begin.error());
    if (begin->warning) log_.add(*begin->warning);
    let_first_interruption_pass();
    // Before there are threads.
    auto process = DriveProcess::start(job_, begin->state, begin->way_back);
    if (!process) return failed(process.error());
    return move(*file, *begin, **process);
  }

 private:
  /// Before a state is touched.
  base::Result<void> check_loops() const {
    if (arguments_.sink) return {};
    return servo::check_stable(servo::loops_of(job_.machine), job_.machine.period);
  }
  std::nullopt_t failed(const base::Diagnostic& problem) {
    log_.add(problem);
    return std::nullopt;
  }

  std::optional<DriveFigures> move(const InputFile& file, const DriveBeginning& begin, DriveProcess& drives) {
    const base::Word& first = begin.state.word;
    DriveLink& link = drives.link();
    if (const auto settings = Terminal::settings(); settings && can_wait()) {
      link.show_terminal(*settings);
      view_.emplace(*settings, file, job_, console_.error_style());
    }
    if (auto ready = await(drives, begin.way_back.size()); !ready) {
      view_.reset();
      return failed(ready.error());
    }
    pipeline::MotionSource source(counted(file.source()), job_.machine, job_.tools, job_.reader_options(file.name()),
                                  nullptr);
    source.planner().slice(drive_slice);
    source.planner().start_at(first.path_length, first.line);
    const double period = job_.machine.period.seconds();
    const std::int64_t lead = std::llround(arguments_.lead / period);
    const std::int64_t words_of_slice = std::max<std::int64_t>(1, std::llround(drive_slice / period));
    realtime::Runner runner({.period = job_.machine.period,
                             .position = first.position,
                             .path_length = first.path_length,
                             .line = first.line,
                             .look_ahead = std::max(arguments_.look_ahead, arguments_.lead + least_spare) +
                                           static_cast<double>(words_of_slice) * period,
                             .lead = lead,
                             .slice = words_of_slice},
                            {.next = [&] { return source.next(); },
                             .refuse = [&] { source.planner().refuse(); },
                             .override_feed = [&](double factor) { source.planner().override_feed(factor); },
                             .lets = [&](const planner::Chunk& chunk) { return lets(chunk); }},
                            sink_to(link, static_cast<std::size_t>(2 * (lead + words_of_slice) + 4)));
    runner.start();
    figures_.last = first;
    watch(runner, drives, file.size());
    conclude(runner, drives);
    view_.reset();
    console_.clear_progress();
    if (notice_) log_.add(*notice_);
    figures_.blocks = source.reader().blocks();
    if (auto sound = look_at(drives); !sound) return failed(sound.error());
    if (figures_.end == DriveFigures::End::tripped) log_.add(why_tripped());
    if (source.reader().source_failure()) return failed(*source.reader().source_failure());
    return figures_;
  }

  /// Until the drives stand where motion begins. After a signal, or q, they do nothing more.
  base::Result<void> await(DriveProcess& drives, std::size_t periods) {
    DriveLink& link = drives.link();
    bool stops = false;
    while (drives.is_running() && (stops || link.phase.load(std::memory_order_acquire) == DriveLink::Phase::starting)) {
      take_feedback(link);
      if (view_) view_->draw_way_back(static_cast<double>(periods) * job_.machine.period.seconds());
      stops = stops || (view_ && view_->is_asked_to_stop()) || interruptions() > 0;
      if (stops) link.order.store(DriveLink::Order::abandon, std::memory_order_release);
      realtime::sleep_until(realtime::now() + frame / 4);
    }
    if (auto sound = look_at(drives); !sound) return sound;
    if (stops) return base::failure(interruption());
    return {};
  }

  /// Until the last word is made, or nobody takes words any more.
  void watch(realtime::Runner& runner, DriveProcess& drives, std::int64_t size) {
    using End = DriveFigures::End;
    Progress progress{.work = "driving", .total = size};
    console_.begin_progress();
    bool has_notice = false;
    while (!runner.has_ended()) {
      realtime::sleep_until(realtime::now() + frame);
      take_feedback(drives.link());
      if (!has_notice && runner.counters().words > 0) {
        has_notice = true;
        figures_.real_time = !runner.notice();
        notice_ = runner.notice();
      }
      const bool is_asked_to_stop = view_ && view_->obey_keys(runner);
      if ((interruptions() > 0 || is_asked_to_stop) && figures_.end == End::done) {
        runner.stop();
        drives.link().stopping.store(true, std::memory_order_relaxed);
        figures_.end = End::stopped;
      }
      if (interruptions() > 1) {
        figures_.end = End::abandoned;
        drives.link().order.store(DriveLink::Order::abandon, std::memory_order_release);
        runner.halt();
      }
      if (!drives.is_running()) {
        runner.halt();
        break;
      }
      progress.bytes = read_.load(std::memory_order_relaxed);
      progress.words = runner.counters().words;
      progress.motion_seconds = job_.machine.period.seconds() * static_cast<double>(progress.words);
      if (view_) {
        view_->draw(runner);
      } else {
        console_.progress(progress);
      }
    }
  }

  void conclude(realtime::Runner& runner, DriveProcess& drives) {
    using End = DriveFigures::End;
    DriveLink& link = drives.link();
    link.at_end.store(figures_.end == End::done && runner.has_ended(), std::memory_order_release);
    auto order = DriveLink::Order::follow;
    link.order.compare_exchange_strong(order, DriveLink::Order::end);
    while (drives.is_running()) {
      if (interruptions() > 1) link.order.store(DriveLink::Order::abandon, std::memory_order_release);
      take_feedback(link);
      realtime::sleep_until(realtime::now() + frame / 4);
    }
    take_feedback(link);
    figures_.counters = runner.counters();
    figures_.latencies = runner.latencies();
    figures_.taken = link.taken.load(std::memory_order_acquire);
    figures_.drives_late = link.late_periods.load(std::memory_order_relaxed);
    figures_.braked = link.braked.load(std::memory_order_relaxed);
    take_slides(link);
    // A file that was given up while it was to be stopped is no surprise.
    const bool was_left = figures_.end == End::abandoned || (arguments_.sink && figures_.end == End::stopped);
    if (link.phase.load() == DriveLink::Phase::tripped && !was_left) figures_.end = End::tripped;
  }

  void take_slides(const DriveLink& link) {
    if (!link.is_over() || arguments_.sink) return;
    figures_.has_drives = true;
    figures_.feed = link.slides.feed;
    for (const base::Axis axis : base::all_axes) {
      if (job_.machine.has(axis)) figures_.axes.emplace_back(axis, link.slides.axes[base::index(axis)]);
    }
  }

  /// M0 and M1 wait for a key, where somebody can press one.
  bool lets(const planner::Chunk& chunk) { return !view_ || view_->pause().lets(chunk); }
  bool can_wait() const { return !job_.arguments.quiet && Terminal::settings(); }

  static realtime::WordSink sink_to(DriveLink& link, std::size_t room) {
    return {
        .take = [&link, room](const base::Word& word) { return link.words.waiting() < room && link.words.push(word); },
        .lead_on = [&link](const base::PathPlace& place) { return link.words.lead_on(place); },
        .publish = [&link] { return link.words.publish(); }};
  }

  base::Diagnostic why_tripped() const {
    if (figures_.counters.too_long_to_rest) {
      return drives_problem(
          "stop-too-long",
          fmt::format("a stop takes more than {} periods: motion has ended before", DriveLink::longest_way),
          "a longer --period needs fewer; --resume goes on from there");
    }
    return drives_problem("words-late", "the drives got no word in time and came to rest by themselves",
                          "--resume goes on from there; a greater --lead lets words be later");
  }

  gcode::ByteSource counted(gcode::ByteSource source) {
    return [this, source = std::move(source)](std::span<char> bytes) {
      auto got = source(bytes);
      if (got) read_.fetch_add(static_cast<std::int64_t>(*got), std::memory_order_relaxed);
      return got;
    };
  }

  void take_feedback(DriveLink& link) {
    for (Feedback feedback; link.feedback.pop(feedback);) {
      figures_.last = feedback.word;
      if (view_) view_->observe(feedback);
    }
  }

  /// Do the drives do what they should, or have they done all of it?
  static base::Result<void> look_at(DriveProcess& drives) {
    const bool runs = drives.is_running();  // before the phase is looked at, which is its last word
    const DriveLink& link = drives.link();
    if (link.phase.load(std::memory_order_acquire) == DriveLink::Phase::failed)
      return base::failure(link.problem.diagnostic());
    if (drives.was_silent())
      return base::failure(drives_problem("io-drives", "the process of the drives did nothing for 10 s, and was ended",
                                          "--resume goes on from the state that it wrote last"));
    if (!runs && !link.is_over())
      return base::failure(drives_problem("io-drives", "the process of the drives has ended"));
    return {};
  }

  std::string program_;
  const Job& job_;
  const DriveArguments& arguments_;
  Console& console_;
  DiagnosticLog& log_;
  std::atomic<std::int64_t> read_{0};  ///< bytes of the program, by the planner's thread
  DriveFigures figures_;
  std::optional<DriveView> view_;           ///< on a terminal
  std::optional<base::Diagnostic> notice_;  ///< that is told when the terminal is as it was
};

ProgramResult drive_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const std::string name = program == "-" ? "<stdin>" : program;
  const auto figures = ProgramDrive(program, job, console, log).execute();
  if (!figures) return {log.status(), json_of_rejected(drive_schema, name, job.machine.name, log), {}};
  const auto status = [&] {
    switch (figures->end) {
      case DriveFigures::End::done:
        return log.status();
      case DriveFigures::End::tripped:
        return Status::not_kept;
      case DriveFigures::End::stopped:
      case DriveFigures::End::abandoned:
        break;
    }
    return Status::interrupted;
  };
  return {status(), json_of_drive(name, job, *figures, log),
          drive_summary(name, job, *figures, console.output_style())};
}

}  // namespace

Status drive(const Job& job, Console& console) {
  const ProgramResult result = drive_program(job.arguments.programs.front(), job, console);
  Status written = Status::done;
  if (job.arguments.json) {
    written = write_output(console, json_text(drive_schema, {result.json}));
  } else if (!job.arguments.quiet && !result.summary.empty()) {
    written = write_output(console, result.summary);
  }
  return worse(result.status, written);
}

}  // namespace leadscrew::cli
