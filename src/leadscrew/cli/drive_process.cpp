#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <leadscrew/cli/drive_process.hpp>
#include <leadscrew/cli/drive_side.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <new>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t patience = 10'000'000'000, longest_nap = 1'000'000'000;  // ns

}  // namespace

base::Result<std::unique_ptr<DriveProcess>> DriveProcess::start(const Job& job, const DriveState& begin,
                                                                const std::vector<base::PathPlace>& way_back) {
  void* memory = ::mmap(nullptr, sizeof(DriveLink), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return base::failure(system_failure("io-open", "no memory to share", "drives", errno));
  // Not set to zero once more: what is not used takes no memory.
  std::unique_ptr<DriveProcess> process(new DriveProcess(new (memory) DriveLink));
  process->id_ = ::fork();
  if (process->id_ < 0) return base::failure(system_failure("io-open", "cannot start", "drives", errno));
  if (process->id_ == 0) {
    run_drives(process->link(), job, begin, way_back);
    ::_exit(0);
  }
  return process;
}

DriveProcess::DriveProcess(DriveLink* link) : link_(link), beat_(realtime::now()), looked_(beat_) {}

DriveProcess::~DriveProcess() {
  link_->order.store(DriveLink::Order::abandon);
  while (is_running()) realtime::sleep_until(realtime::now() + 1'000'000);
  link_->hide_terminal();
  link_->~DriveLink();
  ::munmap(link_, sizeof(DriveLink));
}

bool DriveProcess::is_silent() {
  const std::int64_t now = realtime::now(), beats = link_->beats.load(std::memory_order_relaxed);
  const bool slept = now - looked_ > longest_nap;
  if (beats != beats_ || slept || link_->concluding.load(std::memory_order_acquire)) beat_ = now;
  beats_ = beats;
  looked_ = now;
  return now - beat_ > patience;
}

bool DriveProcess::is_running() {
  if (id_ > 0 && is_silent()) {
    was_silent_ = true;
    ::kill(id_, SIGKILL);
  }
  if (id_ > 0 && ::waitpid(id_, nullptr, WNOHANG) == id_) id_ = 0;
  return id_ > 0;
}

}  // namespace leadscrew::cli
