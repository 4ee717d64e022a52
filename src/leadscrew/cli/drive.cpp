#include <leadscrew/cli/drive.hpp>
#include <leadscrew/cli/drive_checks.hpp>
#include <leadscrew/cli/drive_view.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/drive/checks.hpp>
#include <leadscrew/drive/drive.hpp>
#include <leadscrew/results/drive.hpp>
#include <leadscrew/results/remark_output.hpp>
#include <leadscrew/serve/drive_stream.hpp>
#include <mutex>

namespace leadscrew::cli {

namespace {

constexpr std::size_t most_unshown = 1 << 20;  // bytes of messages

drive::Setup setup_of(const Job& job, const std::string& program) {
  drive::Setup setup{job.machine,         job.tools, job.reader_options(),     job.text,
                     job.arguments.drive, program,   job.arguments.subprograms};
  setup.reading.repeats = true;
  setup.machine_file = job.machine_text();
  setup.tool_table = job.tools_text();
  return setup;
}

class ProgramDrive {
 public:
  ProgramDrive(const std::string& program, const Job& job, Console& console, DiagnosticLog& log)
      : program_(program), job_(job), setup_(setup_of(job, program)), console_(console), log_(log) {
    setup_.remarks = remarks_.sink();
    setup_.parameters_at_end = [this](const auto& values) { parameters_ = values; };
  }

  /// Empty where the log says why.
  std::optional<drive::Figures> execute() {
    const bool live = setup_.options.live;  // then nothing is known of it yet
    const auto file = live ? files::InputFile::of_text({}, shown_name(program_)) : open_program(program_);
    if (!file) return failed(file.error());
    if (auto sound = check_drive_files(*file, job_); !sound) return failed(sound.error());
    if (auto sound = drive::check_machine(setup_); !sound) return failed(sound.error());
    const Reading reading = live ? Reading{} : read_program(*file, job_, console_, log_);
    if (log_.errors() > 0) return std::nullopt;
    const bool page_waits = job_.arguments.serve.port && job_.arguments.serve.control;
    if (reading.pauses > 0 && !can_wait() && !page_waits) {
      log_.add(
          {base::Severity::note, "pause-passed", "M0 and M1 do not pause: no key can be pressed here", {}, {}, {}});
    }
    if (auto sound = serve_to_browsers(*file); !sound) return failed(sound.error());
    const auto figures = drive::drive(*file, setup_, stream_ ? stream_->join(onlooker(*file)) : onlooker(*file));
    if (!figures) return failed(figures.error());
    if (figures->problem) log_.add(*figures->problem);
    show_remarks();
    if (figures->end == drive::Figures::End::done) {
      if (auto kept = keep(); !kept) return failed(kept.error());
    }
    return *figures;
  }

 private:
  std::nullopt_t failed(const base::Diagnostic& problem) {
    log_.add(problem);
    return std::nullopt;
  }

  base::Result<void> serve_to_browsers(const files::InputFile& file) {
    const ServeArguments& asked = job_.arguments.serve;
    if (!asked.port) return {};
    auto stream = serve::DriveStream::open(file, setup_, {*asked.port, asked.control}, wishes_);
    if (!stream) return base::failure(stream.error());
    stream_ = std::move(*stream);
    console_.error_text(stream_->text() + "\n");
    return {};
  }

  /// Log files and parameters, once motion has ended well.
  base::Result<void> keep() {
    if (const auto logs = remarks_.publish(); !logs) return base::failure(logs.error());
    if (!job_.arguments.parameters || !parameters_) return {};
    return results::write_parameters(*job_.arguments.parameters, *parameters_);
  }

  /// What the program has said since; a view of its own has the terminal while the axes move.
  void show_remarks() {
    std::string said;
    {
      const std::lock_guard lock(said_mutex_);
      said.swap(said_);
    }
    if (!said.empty()) console_.error_text(said);
  }

  void hear(const std::string& text) {
    const std::lock_guard lock(said_mutex_);
    if (said_.size() < most_unshown) said_ += text;
  }

  bool can_wait() const { return !job_.arguments.quiet && !setup_.options.live && drive::Terminal::settings(); }

  drive::Onlooker onlooker(const files::InputFile& file) {
    drive::Onlooker onlooker;
    onlooker.tell = [this](const base::Diagnostic& told) { log_.add(told); };
    onlooker.at_end = [this] {
      view_.reset();
      console_.clear_progress();
    };
    if (can_wait()) {
      onlooker.terminal = drive::Terminal::settings();
      onlooker.at_begin = [this, &file, settings = *onlooker.terminal] {
        view_.emplace(settings, file, job_, console_.error_style(), wishes_, stream_ ? stream_->text() : "");
      };
      onlooker.observe = [this](const drive::Feedback& feedback) { view_->observe(feedback); };
      onlooker.while_returning = [this](double seconds) { return view_->go_back(seconds); };
      onlooker.while_moving = [this](const drive::WordMaker& maker, realtime::Runner& runner) {
        return view_->go_on(maker, runner);
      };
      onlooker.may_start = [this](const planner::Chunk& chunk) { return wishes_.pause.may_start(chunk); };
    } else {
      onlooker.while_moving = [this, size = file.size()](const drive::WordMaker& maker, realtime::Runner& runner) {
        show_remarks();
        if (!setup_.options.live) show_progress(maker.bytes_read(), size, runner.counters().words);
        return false;
      };
    }
    return onlooker;
  }

  void show_progress(std::int64_t bytes, std::int64_t size, std::int64_t words) {
    if (!has_progress_) console_.begin_progress();
    has_progress_ = true;
    console_.progress({.work = "driving",
                       .bytes = bytes,
                       .total = size,
                       .words = words,
                       .motion_seconds = job_.machine.period.seconds() * static_cast<double>(words)});
  }

  std::string program_;
  const Job& job_;
  drive::Setup setup_;
  Console& console_;
  DiagnosticLog& log_;
  std::mutex said_mutex_;
  std::string said_;  ///< by the program, that is not shown yet
  results::RemarkOutput remarks_{
      program_, [this](const std::string& path) { return is_in_use(path, program_, {}, job_.arguments); },
      [this](const std::string& text) { hear(text); }};
  std::optional<std::vector<gcode::NumberedValue>> parameters_;  ///< where the program ended
  drive::Wishes wishes_;
  std::unique_ptr<serve::DriveStream> stream_;  ///< to browsers, if that was asked for
  std::optional<DriveView> view_;               ///< on a terminal
  bool has_progress_ = false;
};

Status status_of(const drive::Figures& figures, const DiagnosticLog& log) {
  using End = drive::Figures::End;
  switch (figures.end) {
    case End::done:
    case End::failed:
      return log.status();
    case End::tripped:
      return Status::not_kept;
    case End::stopped:
    case End::abandoned:
      break;
  }
  return Status::interrupted;
}

ProgramResult drive_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const std::string name = shown_name(program);
  const auto figures = ProgramDrive(program, job, console, log).execute();
  if (!figures) return rejected(results::drive_schema, name, job, log);
  return {status_of(*figures, log), results::json_of_drive(name, job.machine, *figures, log.all()),
          results::drive_summary(name, job.machine, *figures, console.output_style())};
}

}  // namespace

Status drive(const Job& given, Console& console) {
  const Job job = job_of(given, given.arguments.programs.front());
  const ProgramResult result = drive_program(job.arguments.programs.front(), job, console);
  Status written = Status::done;
  if (job.arguments.json) {
    written = write_output(console, results::json_text(results::drive_schema, {result.json}));
  } else if (!job.arguments.quiet && !result.summary.empty()) {
    written = write_output(console, result.summary);
  }
  return worse(result.status, written);
}

}  // namespace leadscrew::cli
