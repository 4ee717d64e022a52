#include <unistd.h>
#include <atomic>
#include <csignal>
#include <leadscrew/files/interrupt.hpp>
#include <string_view>

namespace leadscrew::files {

namespace {

constexpr int exit_status = 130;  // as a shell says it of SIGINT
// Signals are counted by whichever thread gets them, and looked for by all.
std::atomic<int> raised{0}, forgiven{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void raise_flag(int) {
  if (raised.load() < 2) ++raised;
}

extern "C" void end_at_once(int) {
  constexpr std::string_view text = "leadscrew: error: interrupted [interrupted]\n";
  static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
  ::_exit(exit_status);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

void handle_interruptions(void (*handler)(int)) {
  handle(SIGINT, handler);
  handle(SIGTERM, handler);
  struct sigaction before = {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) handle(SIGHUP, handler);
}

}  // namespace

void watch_signals() {
  handle_interruptions(raise_flag);
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
}

void end_when_interrupted() {
  handle_interruptions(end_at_once);
  if (raised > 0) end_at_once(0);
}

bool interrupted() {
  return raised > forgiven;
}

void let_first_interruption_pass() {
  forgiven = 1;
}

int interruptions() {
  return raised;
}

base::Diagnostic interruption() {
  return {base::Severity::error, "interrupted", "interrupted", {}, {}, {}};
}

}  // namespace leadscrew::files
