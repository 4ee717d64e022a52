#include <csignal>
#include <leadscrew/cli/interrupt.hpp>

namespace leadscrew::cli {

namespace {

volatile std::sig_atomic_t raised = 0;
volatile std::sig_atomic_t forgiven = 0;

extern "C" void raise_flag(int) {
  if (raised < 2) raised = raised + 1;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void watch_signals() {
  handle(SIGINT, raise_flag);
  handle(SIGTERM, raise_flag);
  struct sigaction before = {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) handle(SIGHUP, raise_flag);
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
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

}  // namespace leadscrew::cli
