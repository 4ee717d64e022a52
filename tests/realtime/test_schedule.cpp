#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <leadscrew/realtime/schedule.hpp>
#include <sanitizers.hpp>
#include <vector>

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

constexpr std::size_t page = 4096, static_pages = 32;
alignas(page) std::array<char, static_pages * page> never_touched;

int count_resident(void* memory, std::size_t pages) {
  std::vector<unsigned char> is_there(pages);
  if (::mincore(memory, pages * page, is_there.data()) != 0) return -1;
  return static_cast<int>(
      std::count_if(is_there.begin(), is_there.end(), [](unsigned char each) { return (each & 1) != 0; }));
}

/// Of pages that are mapped, one of them touched before and one behind: those two are there, and no other; of static data all are. 2 where
/// the system does not permit to lock memory.
int keeps_what_is_touched() {
  constexpr std::size_t count = 2048;
  void* const memory = ::mmap(nullptr, count * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 1;
  char* const bytes = static_cast<char*>(memory);
  bytes[3 * page] = 1;
  if (count_resident(never_touched.data(), static_pages) != 0) return 3;
  const auto notice = realtime::become_real_time();
  if (notice && notice->message.find("locked memory") != std::string::npos) return 2;
  if (count_resident(never_touched.data(), static_pages) != static_pages) return 4;
  bytes[9 * page] = 1;
  std::array<unsigned char, count> is_there{};
  if (::mincore(memory, count * page, is_there.data()) != 0) return 1;
  for (std::size_t k = 0; k < count; ++k) {
    if ((is_there[k] & 1) != (k == 3 || k == 9 ? 1 : 0)) return 1;
  }
  // What is locked is not given back.
  return ::madvise(memory, count * page, MADV_DONTNEED) == 0 ? 1 : 0;
}

TEST(Schedule, LocksWhatIsTouchedAndFetchesNothingElse) {
  if (testing_support::is_sanitized) GTEST_SKIP() << "the sanitizers lock no memory";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) ::_exit(keeps_what_is_touched());
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 2) GTEST_SKIP() << "memory may not be locked here";
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace test_schedule
