// The live view on a terminal: what it shows, its keys, and that the terminal is as it was, whatever happens.

#include <gtest/gtest.h>
#include <pty.h>
#include <termios.h>

#include <algorithm>
#include <cerrno>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_view {

/// The command on a terminal of its own.
class OnTerminal {
 public:
  OnTerminal(const Folder& folder, std::vector<std::string> arguments) {
    winsize size = {40, 100, 0, 0};
    arguments.insert(arguments.begin(), LEADSCREW_COMMAND);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    int other = -1;
    if (::openpty(&terminal_, &other, nullptr, nullptr, &size) != 0) throw std::runtime_error("no terminal");
    keeper_ = other;  // else it would be gone with the command
    ::tcgetattr(other, &before_);
    ::fcntl(terminal_, F_SETFL, O_NONBLOCK);
    process_ = ::fork();
    if (process_ == 0) {
      ::setsid();
      ::dup2(other, STDIN_FILENO);
      ::dup2(other, STDOUT_FILENO);
      ::dup2(other, STDERR_FILENO);
      ::setenv("TERM", "xterm", 1);
      if (::chdir(folder.path().c_str()) == 0) ::execv(LEADSCREW_COMMAND, pointers.data());
      ::_exit(127);
    }
  }
  ~OnTerminal() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    ::close(terminal_);
    ::close(keeper_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  void press(std::string_view keys) const {
    EXPECT_EQ(::write(terminal_, keys.data(), keys.size()), ssize_t(keys.size()));
  }
  void kill() const { ::kill(process_, SIGKILL); }

  /// Reads on until it has been shown.
  bool shows(std::string_view text) {
    return eventually([&] {
      read();
      return contains(shown_, text);
    });
  }
  /// By the last look.
  const std::string& shown() const { return shown_; }
  void forget() { shown_.clear(); }

  bool has_ended() {
    read();
    if (process_ > 0 && ::waitpid(process_, &state_, WNOHANG) == process_) process_ = 0;
    return process_ == 0;
  }
  int status() const { return WIFEXITED(state_) ? WEXITSTATUS(state_) : -1; }

  bool is_as_before() {
    read();
    termios now = {};
    ::tcgetattr(keeper_, &now);
    return now.c_lflag == before_.c_lflag && now.c_cc[VMIN] == before_.c_cc[VMIN] && contains(shown_, "\033[?25h");
  }

 private:
  void read() {
    char buffer[65536];
    for (ssize_t got = 0; (got = ::read(terminal_, buffer, sizeof buffer)) > 0;)
      shown_.append(buffer, static_cast<std::size_t>(got));
  }

  int terminal_ = -1, keeper_ = -1;
  pid_t process_ = 0;
  int state_ = 0;
  termios before_{};
  std::string shown_;
};

const std::string circle = "G21 G90 G94 G17\nG2 X0 Y0 I60 J0 F3000\nM2\n";

TEST(DriveView, ShowsThePartAndObeysItsKeys) {
  const Folder folder;
  folder.write("part.ngc", circle);
  OnTerminal running(folder, {"drive", "part.ngc", "--state", "state"});
  EXPECT_TRUE(running.shows("override 100 %"));
  EXPECT_TRUE(running.shows("\u28C0") || running.shows("\u2809"));  // dots of the circle
  running.press("++-");
  EXPECT_TRUE(running.shows("override 110 %"));
  running.press(" ");
  EXPECT_TRUE(running.shows("HELD"));
  EXPECT_TRUE(running.shows("feed      0.0 /min"));
  running.forget();
  running.press(" ");
  EXPECT_TRUE(running.shows("feed   3300.0 /min"));
  EXPECT_FALSE(running.is_as_before());
  running.press("q");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 130);
  EXPECT_TRUE(running.is_as_before());
  EXPECT_TRUE(running.shows("stopped"));
}

TEST(DriveView, ObeysItsKeysAsFarAsTheProgramAllows) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nM49\nM53 P0\nG2 X0 Y0 I60 J0 F3000\nM2\n");
  OnTerminal running(folder, {"drive", "part.ngc", "--state", "state"});
  EXPECT_TRUE(running.shows("override 100 % not obeyed (M49)"));
  running.press("--");
  EXPECT_TRUE(running.shows("override  80 % not obeyed (M49)"));
  running.press(" ");
  EXPECT_TRUE(running.shows("hold not obeyed (M53 P0)"));
  running.forget();
  EXPECT_TRUE(running.shows("feed   3000.0 /min"));
  running.press("q");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 130);
}

/// A thread goes on as it is programmed; the hold takes effect where it ends.
TEST(DriveView, HoldsBehindAThread) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nS300 M3\nG33 Z-20 K1\nG1 X5 F600\nM2\n");
  OnTerminal running(folder, {"drive", "part.ngc", "--state", "state"});
  EXPECT_TRUE(running.shows("override 100 % not obeyed (in step)"));
  running.press("--");
  EXPECT_TRUE(running.shows("override  80 % not obeyed (in step)"));
  EXPECT_TRUE(running.shows("feed    300.0 /min"));
  running.press(" ");
  EXPECT_TRUE(running.shows("hold waits (in step)"));
  EXPECT_TRUE(running.shows("  HELD"));
  EXPECT_TRUE(running.shows("Z   -20.0000"));
  running.press(" ");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 0);
}

/// Under tool centre point control too, whose path is drawn as the tip goes.
TEST(DriveView, ShowsWhereTheToolIs) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG0 A30\nG43.4 H0\nG1 X40 F600\nM2\n");
  const std::string machine = (source_folder / "machines/table-table-ac.toml").string();
  OnTerminal running(folder, {"drive", "part.ngc", "--machine", machine});
  EXPECT_TRUE(running.shows("tool  0.00000  0.50000  0.86603"));
  EXPECT_TRUE(running.shows("tip "));
  running.press("q");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 130);
}

TEST(DriveView, SaysThatItWaitsForAnInput) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X5 F3000\nM66 P0 L3 Q1\nG1 X6\nM2\n");
  OnTerminal running(folder, {"drive", "part.ngc"});
  EXPECT_TRUE(running.shows("WAITS for an input (M66)"));
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 0);
}

TEST(DriveView, PausesAtM0AndM1UntilAskedToGoOn) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X5 F3000\nM0\nG1 X6\nM1\nG1 X7\nM2\n");
  OnTerminal running(folder, {"drive", "part.ngc", "--trace", "t.csv"});
  EXPECT_TRUE(running.shows("PAUSED in line 3"));
  EXPECT_TRUE(running.shows("X     5.000"));
  running.press("+");
  EXPECT_TRUE(running.shows("override 110 %"));
  EXPECT_FALSE(running.has_ended());
  running.forget();
  running.press(" ");
  EXPECT_TRUE(running.shows("PAUSED in line 5"));
  EXPECT_TRUE(running.shows("X     6.000"));
  running.press(" ");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 0);
  EXPECT_TRUE(running.shows("7"));
}

/// Words are made a second ahead; where motion stands for three until the spindle has taken up its speed, it does not pause.
TEST(DriveView, PausesBehindAWholeThread) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nM3 S300\nG33 Z-10 K1\nM0\nG1 X6 F3000\nM2\n");
  std::string slow = machine_with_spindle();
  folder.write("slow.toml", slow.replace(slow.find("2000"), 4, "100"));
  OnTerminal running(folder, {"drive", "part.ngc", "--machine", "slow.toml", "--lead", "1s", "--trace", "driven.csv"});
  EXPECT_TRUE(running.shows("PAUSED in line 4"));
  EXPECT_TRUE(contains(running.shown(), "Z   -10.00"));
  running.press(" ");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 0);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--machine", "slow.toml", "--trace", "run.csv"}).status, 0);
  EXPECT_TRUE(untimed(folder.read("driven.csv")) == untimed(folder.read("run.csv")));
}

TEST(DriveView, WaitsAtEachOfTwoPauses) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X5 F3000\nM0\nM1\nG1 X6\nM2\n");
  OnTerminal running(folder, {"drive", "part.ngc"});
  for (const char* const line : {"PAUSED in line 3", "PAUSED in line 4"}) {
    EXPECT_TRUE(running.shows(line));
    running.press(" ");
  }
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 0);
}

TEST(DriveView, StopsAtAPause) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X5 F3000\nM0\nG1 X6\nM2\n");
  OnTerminal running(folder, {"drive", "part.ngc", "--state", "state"});
  EXPECT_TRUE(running.shows("PAUSED in line 3"));
  running.press("q");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 130);
  EXPECT_NEAR(Json::parse(folder.read("state"))["position"][0], 5, 1e-9);
}

TEST(DriveView, TellsOfTheReturnPathToWhereItGoesOnAndStopsThere) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X400 F3000\nM2\n");
  {
    OnTerminal running(folder, {"drive", "part.ngc", "--state", "state"});
    EXPECT_TRUE(running.shows("feed   3000.0 /min"));
    running.press("q");
    EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  }
  Json state = Json::parse(folder.read("state"));
  for (Json* each : {&state["axes"][0], &state["axes_path_length"]}) *each = each->get<double>() + 100;
  folder.write("state", state.dump());
  OnTerminal running(folder, {"drive", "part.ngc", "--resume", "state"});
  EXPECT_TRUE(running.shows("back along the path to where motion goes on, 3."));
  running.press("q");
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_EQ(running.status(), 130);
  EXPECT_TRUE(running.is_as_before());
}

TEST(DriveView, GivesTheTerminalBackWhenItIsKilled) {
  const Folder folder;
  folder.write("part.ngc", circle);
  OnTerminal running(folder, {"drive", "part.ngc"});
  EXPECT_TRUE(running.shows("override 100 %"));
  EXPECT_FALSE(running.is_as_before());
  running.kill();
  EXPECT_TRUE(eventually([&] { return running.has_ended(); }));
  EXPECT_TRUE(eventually([&] { return running.is_as_before(); }));
}

}  // namespace test_drive_view
}  // namespace leadscrew::cli::testing
