#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <leadscrew/drive/terminal.hpp>
#include <leadscrew/files/descriptor.hpp>

namespace leadscrew::drive {

namespace {

winsize size_of_terminal() {
  winsize size = {};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) size = {24, 80, 0, 0};
  return size;
}

}  // namespace

std::optional<termios> Terminal::settings() {
  termios now = {};
  const char* kind = std::getenv("TERM");
  const bool is_dumb = kind == nullptr || std::string_view(kind) == "dumb";
  if (is_dumb || ::isatty(STDERR_FILENO) != 1 || ::tcgetattr(STDIN_FILENO, &now) != 0) return std::nullopt;
  return now;
}

Terminal::Terminal(const termios& before) : before_(before) {
  termios keys = before;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 0;
  keys.c_cc[VTIME] = 0;
  ::tcsetattr(STDIN_FILENO, TCSANOW, &keys);
  draw("\033[?1049h\033[?25l\033[?7l");  // another screen, no cursor, lines are cut
}

std::optional<char> Terminal::key() {
  char key = 0;
  if (::read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
  return key;
}

int Terminal::columns() {
  return size_of_terminal().ws_col;
}

int Terminal::rows() {
  return size_of_terminal().ws_row;
}

void Terminal::draw(std::string_view text) {
  static_cast<void>(files::write_all(STDERR_FILENO, text, "standard error"));
}

void Terminal::restore(const termios& settings) {
  std::signal(SIGTTOU, SIG_IGN);  // else who is not in front would be stopped
  draw("\033[?7h\033[?25h\033[?1049l");
  ::tcsetattr(STDIN_FILENO, TCSANOW, &settings);
}

}  // namespace leadscrew::drive
