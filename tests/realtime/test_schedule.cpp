#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <leadscrew/realtime/schedule.hpp>

namespace test_schedule {

using namespace leadscrew;

TEST(Schedule, SleepsUntilATimeAndNotAtAllWhenItHasPassed) {
  const std::int64_t begin = realtime::now();
  realtime::sleep_until(begin + 20'000'000);
  const std::int64_t end = realtime::now();
  EXPECT_GE(end, begin + 20'000'000);
  realtime::sleep_until(begin);
  realtime::sleep_until(-1);
  EXPECT_LT(realtime::now(), end + 1'000'000'000);
}

/// As somebody who may neither go before others nor keep memory.
int notice_of_a_nobody() {
  constexpr rlimit none{0, 0};
  constexpr uid_t nobody = 65534;
  ::setrlimit(RLIMIT_RTPRIO, &none);
  ::setrlimit(RLIMIT_MEMLOCK, &none);
  if (::geteuid() == 0 && ::setuid(nobody) != 0) return 2;
  const std::optional<base::Diagnostic> notice = realtime::become_real_time();
  const bool tells = notice && notice->code == "not-real-time" && notice->severity == base::Severity::warning &&
                     notice->message.find("SCHED_FIFO") != std::string::npos && !notice->hint.empty();
  return tells ? 0 : 1;
}

TEST(Schedule, TellsWhatTheSystemDoesNotPermit) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) ::_exit(notice_of_a_nobody());
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace test_schedule
