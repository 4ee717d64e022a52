#pragma once
// Runs the real command as a user's shell would: in a fresh folder, as a process of its own, with its standard streams
// caught.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace leadscrew::cli::testing {

using Json = nlohmann::json;
using Names = std::set<std::string>;

inline const std::filesystem::path source_folder = LEADSCREW_SOURCE_DIR;

/// 10 mm a side, stopping at each corner.
inline const std::string square = "G21 G90 G61.1\nG1 X10 F600\nY10\nX0\nY0\nM2\n";

inline std::string with_feed(std::string program, const std::string& feed) {
  return program.replace(program.find("F600"), 4, "F" + feed);
}

/// A fresh folder that goes with its contents.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "test-cli-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Returns the name.
  std::string write(const std::string& name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return name;
  }

  std::string read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    EXPECT_TRUE(file.is_open()) << name;
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Everything in it, hidden files too.
  Names names() const {
    Names names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
      names.insert(entry.path().lexically_relative(path_));
    return names;
  }

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int status = -1;  ///< exit status; -1 if a signal ended it
  int signal = 0;   ///< that ended it
  std::string output, errors;

  /// The one object on standard output.
  Json json() const {
    Json object = Json::parse(output, nullptr, false);
    EXPECT_TRUE(object.is_object()) << output << errors;
    return object;
  }
};

/// "line:column code" of each problem.
inline Names places_of(const Json& diagnostics) {
  Names places;
  for (const Json& problem : diagnostics) {
    places.insert(std::to_string(problem["line"].get<int>()) + ":" + std::to_string(problem["column"].get<int>()) +
                  " " + problem["code"].get<std::string>());
  }
  return places;
}

struct Surroundings {
  std::string input = {};                   ///< on a pipe to standard input
  bool input_stays_open = false;            ///< the pipe does not end
  std::string output = {};                  ///< file for standard output; empty: it is caught
  bool output_is_closed = false;            ///< standard output is a pipe whose reader has gone
  std::optional<rlim_t> largest_file = {};  ///< bytes
  std::string command = LEADSCREW_COMMAND;
  std::vector<std::string> environment = {};  ///< NAME=value, besides ours without NO_COLOR
};

/// The command in bin/ of the folder, with the server of pages where there is one.
inline void install_command(const Folder& folder) {
  const std::filesystem::path command = LEADSCREW_COMMAND, server = command.parent_path() / "leadscrew-serve.so";
  std::filesystem::create_directories(folder.path() / "bin");
  std::filesystem::copy_file(command, folder.path() / "bin/leadscrew");
  if (std::filesystem::exists(server)) std::filesystem::copy_file(server, folder.path() / "bin/leadscrew-serve.so");
}

/// Of a command that has no page of the workbench beside it, as where none was built: its reports are its own pages.
inline Surroundings without_page(const Folder& folder) {
  const auto command = folder.path() / "alone/leadscrew";
  std::filesystem::create_directory(command.parent_path());
  std::filesystem::copy_file(LEADSCREW_COMMAND, command);
  return {.command = command.string()};
}

/// Waits until the condition holds; false if it does not within two minutes.
inline bool eventually(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// Has every process that was started in this folder ended?
inline bool is_left(const Folder& folder) {
  const auto here = std::filesystem::canonical(folder.path());
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    std::error_code gone;
    if (std::filesystem::read_symlink(process.path() / "cwd", gone) == here) return false;
  }
  return true;
}

/// The command while it runs.
class Running {
 public:
  Running(const Folder& folder, std::vector<std::string> arguments, const Surroundings& surroundings = {}) {
    output_ = ::memfd_create("output", MFD_CLOEXEC);
    errors_ = ::memfd_create("errors", MFD_CLOEXEC);
    int pipe[2];
    if (::pipe2(pipe, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    input_ = pipe[1];
    ::fcntl(input_, F_SETPIPE_SZ, 1 << 20);
    ::fcntl(input_, F_SETFL, O_NONBLOCK);
    const auto written = ::write(input_, surroundings.input.data(), surroundings.input.size());
    if (written != static_cast<ssize_t>(surroundings.input.size())) throw std::runtime_error("too long for a pipe");
    if (!surroundings.input_stays_open) close_input();

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[0], STDIN_FILENO);
    int closed[2] = {-1, -1};
    if (surroundings.output_is_closed) {
      if (::pipe2(closed, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
      ::close(closed[0]);
      posix_spawn_file_actions_adddup2(&actions, closed[1], STDOUT_FILENO);
    } else if (surroundings.output.empty()) {
      posix_spawn_file_actions_adddup2(&actions, output_, STDOUT_FILENO);
    } else {
      posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, surroundings.output.c_str(), O_WRONLY, 0);
    }
    posix_spawn_file_actions_adddup2(&actions, errors_, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());

    arguments.insert(arguments.begin(), surroundings.command);
    std::vector<std::string> environment = surroundings.environment;
    for (char** value = environ; *value != nullptr; ++value) {
      if (!std::string_view(*value).starts_with("NO_COLOR=")) environment.emplace_back(*value);
    }
    // The child takes over the limit that holds while it is made.
    rlimit before = {};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit = {surroundings.largest_file.value_or(before.rlim_cur), before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const int failed = ::posix_spawn(&process_, surroundings.command.c_str(), &actions, nullptr,
                                     pointers(arguments).data(), pointers(environment).data());
    ::setrlimit(RLIMIT_FSIZE, &before);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[0]);
    if (closed[1] >= 0) ::close(closed[1]);
    if (failed != 0) throw std::runtime_error("cannot start " + surroundings.command);
  }

  ~Running() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    close_input();
    ::close(output_);
    ::close(errors_);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Nothing where it has ended.
  void send(int signal) const {
    if (process_ > 0) ::kill(process_, signal);
  }
  /// To the one process that it has started.
  void send_to_child(int signal) const {
    std::ifstream children("/proc/" + std::to_string(process_) + "/task/" + std::to_string(process_) + "/children");
    pid_t child = 0;
    if (!(children >> child)) throw std::runtime_error("no child");
    ::kill(child, signal);
  }

  /// Does it handle the signal by now?
  bool handles(int signal) const {
    std::ifstream status("/proc/" + std::to_string(process_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("SigCgt:")) return ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) & 1) != 0;
    }
    return false;
  }

  bool has_ended() {
    if (process_ > 0 && ::waitpid(process_, &state_, WNOHANG) == process_) process_ = 0;
    return process_ == 0;
  }

  /// More for standard input, which was left open.
  void write(std::string_view text) const {
    const auto written = ::write(input_, text.data(), text.size());
    EXPECT_EQ(written, static_cast<ssize_t>(text.size()));
  }
  /// No more will come.
  void close_input() {
    if (input_ >= 0) ::close(input_);
    input_ = -1;
  }

  /// What was put into the pipe has been taken out of it: the command waits for more.
  bool is_reading() const {
    int left = 0;
    return ::ioctl(input_, FIONREAD, &left) == 0 && left == 0;
  }

  /// Holds it between two instructions; false if it has ended.
  bool stop() {
    send(SIGSTOP);
    if (::waitpid(process_, &state_, WUNTRACED) == process_ && WIFSTOPPED(state_)) return true;
    process_ = 0;
    return false;
  }

  void resume() const { send(SIGCONT); }

  /// What it has written until now.
  std::string output_by_now() const { return text_of(output_); }
  std::string errors_by_now() const { return text_of(errors_); }

  Outcome wait() {
    EXPECT_TRUE(eventually([&] { return has_ended(); })) << "does not end";
    Outcome outcome;
    if (process_ == 0 && WIFEXITED(state_)) outcome.status = WEXITSTATUS(state_);
    if (process_ == 0 && WIFSIGNALED(state_)) outcome.signal = WTERMSIG(state_);
    outcome.output = text_of(output_);
    outcome.errors = text_of(errors_);
    return outcome;
  }

 private:
  static std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
  }

  static std::string text_of(int descriptor) {
    std::string text;
    char buffer[65536];
    for (ssize_t got = 0; (got = ::pread(descriptor, buffer, sizeof buffer, static_cast<off_t>(text.size()))) > 0;)
      text.append(buffer, static_cast<std::size_t>(got));
    return text;
  }

  pid_t process_ = 0;
  int state_ = 0;
  int output_ = -1, errors_ = -1, input_ = -1;
};

inline Outcome leadscrew(const Folder& folder, std::vector<std::string> arguments,
                         const Surroundings& surroundings = {}) {
  return Running(folder, std::move(arguments), surroundings).wait();
}

/// Around a square of 1 mm again and again: 0.1 s of motion and some 45 bytes a block.
inline std::string long_program(int blocks) {
  std::ostringstream text;
  text << "G21 G90 G61.1 F6000\n";
  for (int i = 0; i < blocks; ++i) text << "G1 X" << i % 2 << " Y" << i / 2 % 2 << " (one corner after the other)\n";
  text << "M2\n";
  return text.str();
}

/// A machine file with the limits of all three axes.
inline std::string machine_text(double acceleration = 1000, double jerk = 20000) {
  std::ostringstream text;
  text << "name = \"other\"\nkinematics = \"cartesian\"\nperiod_us = 1000\ntolerance_mm = 0.01\nchord_error_mm = "
          "0.001\n";
  for (const char axis : {'X', 'Y', 'Z'}) {
    text << "[axis." << axis
         << "]\ntravel_mm = [-500, 500]\nmax_velocity_mm_s = 200\nmax_acceleration_mm_s2 = " << acceleration
         << "\nmax_jerk_mm_s3 = " << jerk << "\nblu_mm = 0.001\n";
  }
  return text.str();
}

/// The same with these lines in [axis.X], from line 12 on.
inline std::string with_screw(const std::string& lines) {
  std::string text = machine_text();
  const std::string last = "blu_mm = 0.001\n";
  return text.insert(text.find(last) + last.size(), lines);
}

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace leadscrew::cli::testing
