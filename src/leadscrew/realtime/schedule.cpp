#include <link.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>
#include <leadscrew/realtime/schedule.hpp>
#include <string>

namespace leadscrew::realtime {

namespace {

constexpr std::int64_t second = 1'000'000'000;
constexpr int priority = 80;  // above everything that is not the kernel's

/// Under a limit of locked memory what is taken later would be refused: then rather none is locked.
bool may_lock_all() {
  rlimit limit = {};
  return ::geteuid() == 0 || (::getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY);
}

/// Code and static data of the program and its libraries, all of it fetched: a branch that a period takes for the first time, such as
/// a stop path's, waits for no disk.
int lock_segments(dl_phdr_info* object, std::size_t, void*) {
  for (std::size_t k = 0; k < object->dlpi_phnum; ++k) {
    const auto& segment = object->dlpi_phdr[k];
    if (segment.p_type != PT_LOAD) continue;
    // An address of the process, which ELF tells as a number.
    const auto* const begin =
        reinterpret_cast<const void*>(object->dlpi_addr + segment.p_vaddr);  // NOLINT(performance-no-int-to-ptr)
    ::mlock(begin, segment.p_memsz);
  }
  return 0;
}

/// All of that, and of other pages those that are there, the rest from when they are touched: to fetch all at once, room that is never
/// used among them, took 50 ms of a drive's beginning. Systems before Linux 4.4 can do nothing else.
bool lock_memory() {
  if (!may_lock_all()) return false;
  if (::mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0) return ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  ::dl_iterate_phdr(lock_segments, nullptr);
  return true;
}

/// More of its stack the calling thread does not use: pages that are there need not be fetched in a period.
[[gnu::noinline]] void touch_stack() {
  constexpr std::size_t used = std::size_t{256} * 1024, page = 4096;
  std::array<volatile char, used> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init): touched below
  for (std::size_t k = 0; k < used; k += page) stack[k] = 0;
}

}  // namespace

std::int64_t now() noexcept {
  timespec time = {};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<std::int64_t>(time.tv_sec) * second + time.tv_nsec;
}

void sleep_until(std::int64_t time) noexcept {
  const timespec until = {static_cast<time_t>(time / second), static_cast<long>(time % second)};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

std::optional<base::Diagnostic> become_real_time() {
  std::string missing;
  const sched_param parameter = {priority};
  if (::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameter) != 0) missing = "SCHED_FIFO";
  touch_stack();
  if (!lock_memory()) missing += missing.empty() ? "locked memory" : " and locked memory";
  if (missing.empty()) return std::nullopt;
  return base::Diagnostic{base::Severity::warning,
                          "not-real-time",
                          "the system does not permit " + missing + ": words may be late whenever it does other work",
                          "grant CAP_SYS_NICE and CAP_IPC_LOCK, or raise rtprio and memlock in limits.conf",
                          {},
                          {}};
}

}  // namespace leadscrew::realtime
