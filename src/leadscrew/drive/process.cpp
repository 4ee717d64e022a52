#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <leadscrew/drive/drive_side.hpp>
#include <leadscrew/drive/process.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <new>

namespace leadscrew::drive {

namespace {

constexpr std::int64_t heartbeat_patience = 10'000'000'000, longest_nap = 1'000'000'000;  // ns

}  // namespace

base::Result<std::unique_ptr<Process>> Process::start(const Setup& setup, Beginning& begin) {
  void* memory = ::mmap(nullptr, sizeof(Link), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    return base::failure(files::system_failure("io-open", "no memory to share", "drives", errno));
  // What is not used is not touched, and takes no memory and no time.
  std::unique_ptr<Process> process(new Process(new (memory) Link(std::min(setup.most_waiting(), Link::most_words),
                                                                 static_cast<std::size_t>(setup.periods_to_stop()))));
  process->id_ = ::fork();
  if (process->id_ < 0) return base::failure(files::system_failure("io-open", "cannot start", "drives", errno));
  if (process->id_ == 0) {
    run_drives(process->link(), setup, begin);
    ::_exit(0);
  }
  return process;
}

Process::Process(Link* link) : link_(link), beat_(realtime::now()), looked_(beat_) {}

Process::~Process() {
  link_->order.store(Link::Order::abandon);
  while (is_running()) realtime::sleep_until(realtime::now() + 1'000'000);
  link_->hide_terminal();
  link_->~Link();
  ::munmap(link_, sizeof(Link));
}

bool Process::is_silent() {
  const std::int64_t now = realtime::now(), beats = link_->beats.load(std::memory_order_relaxed);
  const bool slept = now - looked_ > longest_nap;
  if (beats != beats_ || slept || link_->concluding.load(std::memory_order_acquire)) beat_ = now;
  beats_ = beats;
  looked_ = now;
  return now - beat_ > heartbeat_patience;
}

bool Process::is_running() {
  if (id_ > 0 && is_silent()) {
    was_silent_ = true;
    ::kill(id_, SIGKILL);
  }
  if (id_ > 0 && ::waitpid(id_, nullptr, WNOHANG) == id_) id_ = 0;
  return id_ > 0;
}

}  // namespace leadscrew::drive
