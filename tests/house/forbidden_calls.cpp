#include "forbidden_calls.hpp"

#include <dlfcn.h>
#include <pthread.h>
#include <time.h>

#include <cstdlib>

using leadscrew::testing_support::watch;

namespace {

thread_local leadscrew::testing_support::Watch of_thread;

void count(const char* name) {
  if (!of_thread.armed) return;
  ++of_thread.calls;
  of_thread.last = name;
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
  if (!of_thread.may_read_clock) count("clock_gettime");
  return real("clock_gettime", &clock_gettime)(clock, time);
}

}  // extern "C"

leadscrew::testing_support::Watch& leadscrew::testing_support::watch() {
  return of_thread;
}

bool leadscrew::testing_support::counts_each_function() {
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
  const bool none_unarmed = watch().calls == 0;
  watch().armed = true;
  call_each();
  watch().armed = false;
  const bool each_armed = watch().calls >= 17;
  watch().calls = 0;
  return none_unarmed && each_armed;
}

std::string leadscrew::testing_support::told(const Watch& watch) {
  std::string text = std::to_string(watch.calls) + " forbidden calls";
  if (watch.calls > 0) text += std::string(", the last of ") + watch.last;
  return text;
}
