// What the cycle calls, seen while it runs: this program puts itself in the place of the functions that the cycle may
// not call, and counts who calls them while a word is made. Beside the cycle it holds functions that do what is
// forbidden, for the checks of the checks: tests/house/reached.cpp reads the machine code of them all.
//
//   cycle            words along lines, arcs, NURBS curves and dwells, through changes of chunk and a starvation
//   cycle sabotage   the same, with one allocation while a word is made: has to fail

#include <dlfcn.h>
#include <pthread.h>
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <leadscrew/interpolator/controller.hpp>
#include <mixed_paths.hpp>

namespace {

using namespace leadscrew;
using namespace testing_support;
using interpolator::Controller;

thread_local bool armed = false;
thread_local int calls = 0;
thread_local const char* last_call = "";

void count(const char* name) {
  if (!armed) return;
  ++calls;
  last_call = name;
}

/// The function of this name in the libraries behind this program.
template <typename Function>
Function* real(const char* name, Function* /*same_type*/) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept {
  count("malloc");
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept {
  count("calloc");
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  count("realloc");
  return __libc_realloc(memory, size);
}
void free(void* memory) noexcept {
  count("free");
  __libc_free(memory);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  count("aligned_alloc");
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  count("posix_memalign");
  *memory = __libc_memalign(alignment, size);
  return *memory ? 0 : 12;  // ENOMEM
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  count("pthread_mutex_lock");
  return real("pthread_mutex_lock", &pthread_mutex_lock)(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  count("pthread_mutex_trylock");
  return real("pthread_mutex_trylock", &pthread_mutex_trylock)(mutex);
}
int pthread_mutex_unlock(pthread_mutex_t* mutex) noexcept {
  count("pthread_mutex_unlock");
  return real("pthread_mutex_unlock", &pthread_mutex_unlock)(mutex);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  count("pthread_cond_wait");
  return real("pthread_cond_wait", &pthread_cond_wait)(condition, mutex);
}
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* until) {
  count("pthread_cond_timedwait");
  return real("pthread_cond_timedwait", &pthread_cond_timedwait)(condition, mutex, until);
}
int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  count("pthread_cond_signal");
  return real("pthread_cond_signal", &pthread_cond_signal)(condition);
}
int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  count("pthread_cond_broadcast");
  return real("pthread_cond_broadcast", &pthread_cond_broadcast)(condition);
}
int clock_gettime(clockid_t clock, timespec* time) noexcept {
  count("clock_gettime");
  return real("clock_gettime", &clock_gettime)(clock, time);
}

/// For the check of machine code: what it has to find. Volatile, so that nothing of it is optimised away.
void* volatile allocated = nullptr;
double (*volatile any_function)(double) = nullptr;

[[gnu::noinline]] base::Word cycle_that_allocates(Controller& controller) {
  allocated = ::operator new(24);
  return controller.next();
}
[[gnu::noinline]] double cycle_that_calls_through_a_pointer(Controller& controller) {
  return any_function(controller.next().feed) + 1;
}
[[gnu::noinline]] double cycle_that_leaves_through_a_pointer(double feed) {
  return any_function(feed);
}

}  // extern "C"

namespace {

enum class Sabotage : std::uint8_t { none, allocation };

/// One word, watched.
base::Word watched_word(Controller& controller, Sabotage sabotage) {
  armed = true;
  const base::Word word = sabotage == Sabotage::allocation ? cycle_that_allocates(controller) : controller.next();
  armed = false;
  return word;
}

/// Words until nothing is left to do.
std::int64_t watch(Controller& controller) {
  std::int64_t words = 0;
  do {
    watched_word(controller, Sabotage::none);
    ++words;
  } while (!controller.idle());
  return words;
}

/// Each of the functions above counts itself while armed, and none otherwise.
bool counts_each_function() {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
  timespec time{};
  const auto call_each = [&] {
    void* volatile memory = std::malloc(10);
    memory = std::realloc(memory, 20);
    std::free(memory);
    memory = std::calloc(1, 10);
    std::free(memory);
    memory = std::aligned_alloc(64, 64);
    std::free(memory);
    void* aligned = nullptr;
    if (posix_memalign(&aligned, 64, 64) == 0) std::free(aligned);
    pthread_mutex_lock(&mutex);
    pthread_cond_timedwait(&condition, &mutex, &time);
    pthread_mutex_unlock(&mutex);
    pthread_mutex_trylock(&mutex);
    pthread_mutex_unlock(&mutex);
    pthread_cond_signal(&condition);
    pthread_cond_broadcast(&condition);
    clock_gettime(CLOCK_MONOTONIC, &time);
  };
  call_each();
  const bool none_unarmed = calls == 0;
  armed = true;
  call_each();
  armed = false;
  const bool each_armed = calls >= 17;
  calls = 0;
  return none_unarmed && each_armed;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (!counts_each_function()) {
    std::puts("the counting does not count");
    return 2;
  }
  const Path path = mixed_path();
  const auto cuts = cut_motion(path, 0, path.length(), path_speed, path_jerk, 0.03);
  Controller controller(path_period, {}, 4 * cuts.size());
  const auto offer = [&](planner::Chunk chunk) {
    if (controller.offer(chunk) != Controller::Offer::accepted) std::abort();
  };
  std::int64_t words = 0;
  // Starved behind every chunk, and anew from there.
  for (std::size_t last = 0; last + 1 < cuts.size(); ++last) {
    for (std::size_t k = 0; k <= last; ++k) offer(cuts[k].chunk);
    words += watch(controller);
    const auto again = cut_motion(path, cuts[last].rest, path.length(), path_speed, path_jerk, 0.02);
    if (path.length() - cuts[last].rest > 1e-9) {
      for (const CutChunk& cut : again) offer(cut.chunk);
    }
    offer(dwell(path.at(path.length()), 0.05));
    offer({});
    words += watch(controller);
  }
  if (argument_count > 1 && std::strcmp(arguments[1], "sabotage") == 0) watched_word(controller, Sabotage::allocation);
  std::printf("%lld words, %lld starvations, %lld chunks: %d forbidden calls%s%s\n", static_cast<long long>(words),
              static_cast<long long>(controller.starvations()), static_cast<long long>(controller.begun()), calls,
              calls > 0 ? ", the last of " : "", calls > 0 ? last_call : "");
  return calls == 0 ? 0 : 1;
}
