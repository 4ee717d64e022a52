#include <algorithm>
#include <condition_variable>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/results/program_json.hpp>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace leadscrew::cli {

namespace {

struct Finished {
  ProgramResult result;
  std::string errors;  ///< for standard error
};

/// Works on programs in threads of its own, and gives out what came of them in their order.
class ProgramThreads {
 public:
  ProgramThreads(const Job& job, const Console& console, const ProgramWork& work, std::size_t threads)
      : job_(job), console_(console), work_(work), finished_(job.arguments.programs.size()) {
    while (threads_.size() < threads) threads_.emplace_back([this] { take_programs(); });
  }
  /// Those at work on a program go on to its end.
  ~ProgramThreads() {
    const std::lock_guard lock(mutex_);
    next_ = finished_.size();
  }

  /// Waits for the program of this number. Each is asked for once.
  Finished await(std::size_t number) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return finished_[number].has_value(); });
    return std::move(*finished_[number]);
  }

 private:
  void take_programs() {
    while (true) {
      std::unique_lock lock(mutex_);
      if (next_ == finished_.size()) return;
      const std::size_t number = next_++;
      lock.unlock();
      Finished finished = work(job_.arguments.programs[number]);
      lock.lock();
      // After ^C none is begun. Nobody waits for those: what is given out ends with the first that was interrupted.
      if (finished.result.status == Status::interrupted) next_ = finished_.size();
      finished_[number] = std::move(finished);
      changed_.notify_all();
    }
  }

  Finished work(const std::string& program) const {
    Finished finished;
    Console console(console_, finished.errors);
    finished.result = work_(program, job_of(job_, program), console);
    return finished;
  }

  const Job& job_;
  const Console& console_;
  const ProgramWork& work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::optional<Finished>> finished_;
  std::size_t next_ = 0;               // program to begin
  std::vector<std::jthread> threads_;  // the last, so that they end first
};

/// As many as there are processors, or were asked for; one where two programs share standard input.
std::size_t threads_for(const Arguments& arguments) {
  const auto wanted = static_cast<std::size_t>(
      arguments.threads.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))));
  const bool share_input = std::count(arguments.programs.begin(), arguments.programs.end(), "-") > 1;
  return share_input ? 1 : std::min(wanted, arguments.programs.size());
}

}  // namespace

std::string shown_name(const std::string& program) {
  return program == "-" ? "<stdin>" : program;
}

ProgramResult rejected(std::string_view schema, const std::string& name, const Job& job, const DiagnosticLog& log) {
  return {log.status(), results::json_of_rejected(schema, name, job.machine.name, log.all()), {}};
}

Status for_each_program(const Job& job, Console& console, const ProgramWork& work) {
  const Arguments& arguments = job.arguments;
  std::optional<ProgramThreads> threads;
  if (const std::size_t count = threads_for(arguments); count > 1) threads.emplace(job, console, work, count);
  Status worst = Status::done;
  std::vector<json::Json> objects;
  for (std::size_t number = 0; number < arguments.programs.size(); ++number) {
    const std::string& program = arguments.programs[number];
    // One thread tells what it finds as it comes, and shows how far it is.
    Finished finished = threads ? threads->await(number) : Finished{work(program, job_of(job, program), console), {}};
    if (!finished.errors.empty()) console.error_text(finished.errors);
    ProgramResult& result = finished.result;
    worst = worse(worst, result.status);
    if (result.status == Status::interrupted) return worst;
    if (arguments.json) {
      objects.push_back(std::move(result.json));
    } else if (!arguments.quiet && !result.summary.empty()) {
      const Status written = write_output(console, result.summary);
      if (written != Status::done) return worse(worst, written);
    }
  }
  return arguments.json
             ? worse(worst, write_output(console, results::json_text(results::runs_schema, std::move(objects))))
             : worst;
}

}  // namespace leadscrew::cli
