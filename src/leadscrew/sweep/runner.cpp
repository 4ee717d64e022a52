#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/sweep/build.hpp>
#include <leadscrew/sweep/runner.hpp>
#include <numeric>
#include <set>
#include <thread>

namespace leadscrew::sweep {

namespace {

using options::Status;

double seconds_of(clockid_t clock) {
  std::timespec time = {};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

/// What processes of this computer share.
struct Shared {
  std::atomic<std::int64_t> claimed = 0, done = 0, failed = 0;
  std::atomic<bool> stops = false;  // no task is begun any more
};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

class SharedMemory {
 public:
  SharedMemory() {
    void* const memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory != MAP_FAILED) shared_ = new (memory) Shared;
  }
  ~SharedMemory() {
    if (shared_ != nullptr) ::munmap(shared_, sizeof(Shared));
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  Shared* get() const { return shared_; }

 private:
  Shared* shared_ = nullptr;
};

/// What a process does until no task is left.
class Worker {
 public:
  Worker(Work& work, const Plan& plan, const std::string& shards, console::Console& console)
      : work_(work), plan_(plan), shard_(shards, build_name()), console_(console) {}

  /// Does the task of this place of the plan's order. False: no more can be done.
  bool take(std::int64_t place) {
    const std::int64_t task = plan_.order[static_cast<std::size_t>(place)];
    Spent spent{.begin = seconds_of(CLOCK_REALTIME)};
    const double begin = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    const auto result = work_.result(task);
    spent.end = seconds_of(CLOCK_REALTIME);
    spent.processor = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - begin;
    if (!result) return fail(result.error(), result.error().code != "interrupted");
    if (auto added = shard_.add(work_.key(task), *result, spent); !added) return fail(added.error(), false);
    ++ended_.done;
    return true;
  }
  Ended end() {
    if (auto synced = shard_.sync(); !synced) fail(synced.error(), false);
    ended_.processor_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    return ended_;
  }
  const Ended& so_far() const { return ended_; }

 private:
  bool fail(const base::Diagnostic& problem, bool goes_on) {
    if (problem.code != "interrupted") console_.diagnostic(problem);
    ++ended_.failed;
    ended_.status = worse(ended_.status, options::status_of(problem));
    return goes_on;
  }

  Work& work_;
  const Plan& plan_;
  ShardWriter shard_;
  console::Console& console_;
  Ended ended_;
};

/// Ends the process that was started for it.
[[noreturn]] void work_as_process(Work& work, const Plan& plan, const std::string& shards, Shared& shared, pid_t parent,
                                  console::Console& console) {
  // A parent that is killed takes its processes along.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(static_cast<int>(Status::interrupted));
  Worker worker(work, plan, shards, console);
  const auto count = static_cast<std::int64_t>(plan.order.size());
  while (!shared.stops && !files::interrupted()) {
    const std::int64_t place = shared.claimed++;
    if (place >= count) break;
    const std::int64_t failed = worker.so_far().failed;
    const bool goes_on = worker.take(place);
    (worker.so_far().failed > failed ? shared.failed : shared.done)++;
    if (!goes_on) break;
  }
  const Ended ended = worker.end();
  if (ended.status != Status::done && ended.status != Status::input_output) shared.stops = true;
  ::_exit(static_cast<int>(files::interrupted() ? Status::interrupted : ended.status));
}

void show(const Plan& plan, std::int64_t done, console::Console& console) {
  console.progress({.work = "sweeping", .bytes = done, .total = static_cast<std::int64_t>(plan.order.size())});
}

base::Diagnostic died(int status) {
  return {base::Severity::error,
          "sweep-process",
          fmt::format("a process of the sweep was ended by signal {} ({})", WTERMSIG(status),
                      ::strsignal(WTERMSIG(status))),
          "start the sweep again: it goes on with the tasks that are not done",
          {},
          {}};
}

/// Waits for the processes; one that a signal ends takes the others along.
class Processes {
 public:
  explicit Processes(console::Console& console) : console_(console) {}

  void add(pid_t process) { running_.push_back(process); }
  bool are_running() const { return !running_.empty(); }
  Status status() const { return status_; }

  /// Looks which have ended.
  void look() {
    for (std::size_t i = 0; i < running_.size();) {
      int status = 0;
      const pid_t ended = ::waitpid(running_[i], &status, WNOHANG);
      if (ended == 0 || (ended < 0 && errno == EINTR)) {
        ++i;
        continue;
      }
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      if (ended < 0) continue;
      if (WIFEXITED(status)) status_ = worse(status_, static_cast<Status>(WEXITSTATUS(status)));
      if (!WIFSIGNALED(status)) continue;
      if (!has_died_) console_.diagnostic(died(status));
      has_died_ = true;
      status_ = worse(status_, Status::input_output);
      signal_all(SIGKILL);
    }
  }
  void signal_all(int signal) const {
    for (const pid_t process : running_) ::kill(process, signal);
  }

 private:
  console::Console& console_;
  std::vector<pid_t> running_;
  Status status_ = Status::done;
  bool has_died_ = false;
};

Ended failed_to_start(console::Console& console, int error) {
  console.diagnostic(files::system_failure("sweep-process", "cannot start a process", {}, error));
  return {.status = Status::input_output};
}

double processor_seconds_of_children() {
  rusage usage = {};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

base::Result<Plan> plan_of(const Work& work, const std::string& shards) {
  std::set<Key> done;
  const auto read = for_each_line(shards, [&](const ShardLine& line) { done.insert(line.key); });
  if (!read) return base::failure(read.error());
  Plan plan;
  for (std::int64_t task = 0; task < work.count(); ++task) {
    const Key key = work.key(task);
    if (done.contains(key)) {
      ++plan.done_before;
    } else if (done.insert(key).second) {
      plan.order.push_back(task);
    }
  }
  std::ranges::stable_sort(plan.order, [&](std::int64_t a, std::int64_t b) { return work.cost(a) > work.cost(b); });
  return plan;
}

Ended run_alone(Work& work, const Plan& plan, const std::string& shards, int processes, console::Console& console) {
  const SharedMemory memory;
  if (memory.get() == nullptr) return failed_to_start(console, errno);
  Shared& shared = *memory.get();
  const pid_t self = ::getpid();
  build_name();  // read once, before there are others
  Processes started(console);
  const auto wanted = std::min<std::int64_t>(processes, static_cast<std::int64_t>(plan.order.size()));
  for (std::int64_t i = 0; i < wanted; ++i) {
    const pid_t process = ::fork();
    if (process == 0) work_as_process(work, plan, shards, shared, self, console);
    if (process < 0) {
      started.signal_all(SIGKILL);
      return failed_to_start(console, errno);
    }
    started.add(process);
  }
  console.begin_progress();
  bool is_told = false;
  while (started.are_running()) {
    if (files::interrupted() && !is_told) started.signal_all(SIGTERM);
    is_told = files::interrupted();
    started.look();
    show(plan, shared.done + shared.failed, console);
    if (started.are_running()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  console.clear_progress();
  const Status status = files::interrupted() ? Status::interrupted : started.status();
  return {shared.done, shared.failed, status, processor_seconds_of_children() + seconds_of(CLOCK_PROCESS_CPUTIME_ID)};
}

Ended run_ranked(Work& work, const Plan& plan, const std::string& shards, World& world, console::Console& console) {
  Worker worker(work, plan, shards, console);
  const auto count = static_cast<std::int64_t>(plan.order.size());
  console.begin_progress();
  while (!files::interrupted()) {
    const std::int64_t place = world.claim();
    if (place >= count || !worker.take(place)) break;
    if (world.rank() == 0) show(plan, std::min(count, world.claimed()), console);
  }
  console.clear_progress();
  const Ended own = worker.end();
  const Status status = files::interrupted() ? Status::interrupted : own.status;
  const std::string text = fmt::format("{} {} {} {}", own.done, own.failed, static_cast<int>(status), own.processor_s);
  Ended all;
  for (const std::string& part : world.gather(text)) {
    long long done = 0, failed = 0;
    int of_status = 0;
    double processor = 0;
    if (std::sscanf(part.c_str(), "%lld %lld %d %lf", &done, &failed, &of_status, &processor) != 4) continue;
    all.done += done;
    all.failed += failed;
    all.status = worse(all.status, static_cast<Status>(of_status));
    all.processor_s += processor;
  }
  return world.rank() == 0 ? all : own;
}

}  // namespace leadscrew::sweep
