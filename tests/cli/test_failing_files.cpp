// Files that vanish, change or cannot be written, and runs that are broken off: the status says so and nothing is left.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_failing_files {

namespace fs = std::filesystem;

/// Some seconds of work when its words are written.
constexpr int long_blocks = 200'000;

/// A trace has been begun.
bool is_moving(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::error_code gone;
    if (entry.path().filename().string().starts_with(".leadscrew-") && entry.file_size(gone) > 0 && !gone) return true;
  }
  return false;
}

std::vector<std::string> run_with_every_output(const std::string& program) {
  return {"run", program, "--trace", "t.csv", "--report", "r.html", "--picture", "p.svg"};
}

TEST(Inputs, ThatDoNotExistAreInputOutput) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("t.csv", "t,X\n0,0\n");
  const std::vector<std::vector<std::string>> commands = {
      {"run", "none", "--trace", "made.csv"}, {"check", "none"},
      {"verify", "none", "part.ngc"},         {"verify", "t.csv", "none"},
      {"run", "part.ngc", "--tools", "none"}, {"run", "part.ngc", "--machine", "none", "--trace", "made.csv"}};
  for (const auto& command : commands) {
    const auto outcome = leadscrew(folder, command);
    EXPECT_EQ(outcome.status, 4);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(contains(outcome.errors, "none: error: cannot open: ")) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, " [io-open]\n")) << outcome.errors;
  }
  EXPECT_EQ(folder.names(), (Names{"part.ngc", "t.csv"}));
}

TEST(Outputs, ThatAreLinksStayLinks) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("there.csv", "old");
  fs::create_symlink("there.csv", folder.path() / "link.csv");
  fs::create_symlink("not-yet.csv", folder.path() / "dangling.csv");
  for (const auto& [link, target] : {std::pair("link.csv", "there.csv"), {"dangling.csv", "not-yet.csv"}}) {
    EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", link}).status, 0);
    EXPECT_TRUE(fs::is_symlink(folder.path() / link));
    EXPECT_FALSE(fs::is_symlink(folder.path() / target));
    EXPECT_TRUE(folder.read(target).starts_with("t,line,s,feed,X,Y,Z\n"));
  }
}

TEST(Inputs, ThatAreFoldersAreInputOutput) {
  const Folder folder;
  for (const char* command : {"run", "check"}) {
    const auto outcome = leadscrew(folder, {command, "."});
    EXPECT_EQ(outcome.status, 4);
    EXPECT_TRUE(contains(outcome.errors, ".: error: is a directory [io-open]\n")) << outcome.errors;
  }
}

TEST(Inputs, ThatAreRemovedWhileTheyAreReadAreReadToTheirEnd) {
  const Folder folder, quiet_folder;
  const std::string program = long_program(8'000);
  quiet_folder.write("part.ngc", program);
  ASSERT_EQ(leadscrew(quiet_folder, {"run", "part.ngc", "--trace", "t.csv"}).status, 0);
  folder.write("part.ngc", program);
  Running running(folder, {"run", "part.ngc", "--trace", "t.csv"});
  ASSERT_TRUE(eventually([&] { return is_moving(folder.path()) || running.has_ended(); }));
  ASSERT_TRUE(running.stop());
  ASSERT_TRUE(is_moving(folder.path()));
  fs::remove(folder.path() / "part.ngc");
  running.resume();
  EXPECT_EQ(running.wait().status, 0);
  EXPECT_EQ(folder.names(), Names{"t.csv"});
  EXPECT_TRUE(folder.read("t.csv") == quiet_folder.read("t.csv"));
}

/// Does something to the program in the middle of a run that would write every file.
Outcome disturbed_run(const Folder& folder, const std::function<void(const fs::path&)>& disturb) {
  folder.write("part.ngc", long_program(20'000));
  Running running(folder, run_with_every_output("part.ngc"));
  EXPECT_TRUE(eventually([&] { return is_moving(folder.path()) || running.has_ended(); }));
  EXPECT_TRUE(running.stop() && is_moving(folder.path()));
  disturb(folder.path() / "part.ngc");
  running.resume();
  return running.wait();
}

TEST(Inputs, ThatShrinkWhileTheyAreReadAreInputOutput) {
  const Folder folder;
  const auto run = disturbed_run(folder, [](const fs::path& program) { fs::resize_file(program, 100); });
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.errors, " [program-changed]\n")) << run.errors;
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST(Inputs, ThatAreWrittenOverWhileTheyAreReadAreInputOutput) {
  const Folder folder;
  const auto run = disturbed_run(folder, [](const fs::path& program) {
    std::fstream file(program, std::ios::in | std::ios::out);
    file.seekp(-5, std::ios::end) << "(";
  });
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.errors, " [program-changed]\n")) << run.errors;
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST(Inputs, ThatGrowWhileTheyAreReadAreInputOutput) {
  const Folder folder;
  const auto run =
      disturbed_run(folder, [](const fs::path& program) { std::ofstream(program, std::ios::app) << "G0 X400\n"; });
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.errors, " [program-changed]\n")) << run.errors;
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST(FullDisk, EndsARunThatWritesToIt) {
  const Folder folder;
  folder.write("part.ngc", square);
  const std::map<std::string, std::string> outputs = {
      {"--trace", "other.csv"}, {"--report", "other.html"}, {"--picture", "other.svg"}};
  for (const auto& [option, unused] : outputs) {
    std::vector<std::string> arguments = {"run", "part.ngc"};
    for (const auto& [other, name] : outputs)
      arguments.insert(arguments.end(), {other, other == option ? "/dev/full" : name});
    const auto run = leadscrew(folder, arguments);
    EXPECT_EQ(run.status, 4) << option;
    EXPECT_EQ(run.output, "") << option;
    EXPECT_EQ(run.errors, "/dev/full: error: cannot write: No space left on device [io-write]\n") << option;
    EXPECT_EQ(folder.names(), Names{"part.ngc"}) << option;
  }
}

TEST(FullDisk, UnderStandardOutputIsInputOutput) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("bad.ngc", "G123\n");
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv"}).status, 0);
  const std::vector<std::vector<std::string>> commands = {{"run", "part.ngc"},
                                                          {"run", "part.ngc", "--json"},
                                                          {"check", "part.ngc"},
                                                          {"verify", "t.csv", "part.ngc"},
                                                          {"--help"},
                                                          {"run", "--help"},
                                                          {"--version"},
                                                          {"check", "bad.ngc", "--json"}};
  for (const auto& command : commands) {
    const auto outcome = leadscrew(folder, command, {.output = "/dev/full"});
    EXPECT_EQ(outcome.status, 4) << command[0];
    EXPECT_TRUE(contains(outcome.errors, "No space left on device [io-write]\n")) << outcome.errors;
  }
}

TEST(FullDisk, MetInTheMiddleLeavesNothing) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const char* trace : {"t.csv", "t.npy"}) {
    const auto run =
        leadscrew(folder, {"run", "part.ngc", "--trace", trace, "--report", "r.html"}, {.largest_file = rlim_t{65536}});
    EXPECT_EQ(run.status, 4);
    EXPECT_EQ(run.signal, 0);
    EXPECT_EQ(run.errors, std::string(trace) + ": error: cannot write: File too large [io-write]\n");
    EXPECT_EQ(folder.names(), Names{"part.ngc"});
  }
}

TEST(FullDisk, LeavesTheFileThatWouldHaveBeenReplaced) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("t.csv", "older");
  const auto run = leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv"}, {.largest_file = rlim_t{65536}});
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(folder.read("t.csv"), "older");
  EXPECT_EQ(folder.names(), (Names{"part.ngc", "t.csv"}));
}

/// Every option that writes a file, with a command for it and an ending that it has.
struct Output {
  std::vector<std::string> command;
  std::string option, ending;
};

std::vector<Output> every_output() {
  std::vector<Output> outputs;
  const std::vector<std::string> run = {"run", "part.ngc"}, drive = {"drive", "part.ngc", "--quiet"},
                                 simulate = {"simulate", "part.ngc"}, pulse = {"pulse", "--line", "--end", "3,4"};
  for (const auto& command : {run, simulate}) {
    outputs.insert(outputs.end(), {{command, "--trace", ".npy"},
                                   {command, "--report", ".html"},
                                   {command, "--report", ".htm"},
                                   {command, "--picture", ".svg"},
                                   {command, "--events", ".csv"}});
  }
  for (const char* option : {"--trace", "--axes", "--events", "--sink"}) outputs.push_back({drive, option, ".csv"});
  outputs.insert(outputs.end(), {{run, "--pulses", ".vcd"},
                                 {run, "--blocks", ".csv"},
                                 {pulse, "--vcd", ".vcd"},
                                 {pulse, "--svg", ".svg"},
                                 {{"study", "real-time-vs-offline"}, "--picture", ".svg"}});
  return outputs;
}

TEST(Outputs, AppearInFoldersThatAreMade) {
  const std::string short_line = "G21 G90 G61.1\nG1 X0.5 F6000\nM2\n";
  for (Output& output : every_output()) {
    const Folder folder;
    folder.write("part.ngc", short_line);
    const std::string name = "a/new folder/made" + output.ending;
    output.command.insert(output.command.end(), {output.option, name});
    const auto made = leadscrew(folder, output.command);
    // Where the system is busy, drives may get a word too late, and say so.
    EXPECT_LE(made.status, output.command.front() == "drive" ? 1 : 0)
        << output.command.front() << output.option << made.errors;
    EXPECT_GT(folder.read(name).size(), 0U);
  }
  const Folder folder;
  folder.write("part.ngc", short_line);
  EXPECT_LE(leadscrew(folder, {"drive", "part.ngc", "--quiet", "--state", "a/new folder/state"}).status, 1);
  EXPECT_GT(folder.read("a/new folder/state").size(), 0U);
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--quiet", "--out", "one/more"}).status, 0);
  EXPECT_GT(folder.read("one/more/part.html").size(), 0U);
}

TEST(Outputs, OfAnEndingThatCannotBeWrittenAreMisuse) {
  for (const Output& output : every_output()) {
    const Folder folder;
    folder.write("part.ngc", square);
    for (const std::string name : {"made.pdf", "made", "made/", "html", ".html", "made.html.txt"}) {
      auto words = output.command;
      words.insert(words.end(), {output.option, name});
      const auto refused = leadscrew(folder, words);
      EXPECT_EQ(refused.status, 2) << output.command.front() << output.option << name;
      EXPECT_TRUE(contains(refused.errors, "error: " + output.option + " " + name + ": ")) << refused.errors;
      EXPECT_TRUE(contains(refused.errors, output.ending)) << refused.errors;
      EXPECT_EQ(folder.names(), Names{"part.ngc"});
    }
  }
  const Folder folder;
  folder.write("part.ngc", square);
  const auto pdf = leadscrew(folder, {"run", "part.ngc", "--report", "x.pdf"});
  EXPECT_EQ(pdf.errors,
            "leadscrew run: error: --report x.pdf: ends in neither .html nor .htm; the ending says the format\n"
            "    hint: leadscrew run --help\n");
  const auto picture = leadscrew(folder, {"run", "part.ngc", "--report", "x.SVG"});
  EXPECT_TRUE(contains(picture.errors, "; --picture is for .svg\n")) << picture.errors;
}

TEST(Outputs, OfWhomNobodyReadsOnEndInSilence) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("wrong.ngc", "G1 X\n");
  folder.write("short.ngc", "G21 G90 G61.1\nG1 X0.5 F6000\nM2\n");
  using Line = std::vector<std::string>;
  const Line line = {"pulse", "--line", "--end", "300,40"};
  std::vector<Line> lines = {{"--help"},
                             {"--version", "--json"},
                             {"help", "--man", "run"},
                             {"completion", "bash"},
                             {"study", "list"},
                             {"study", "list", "--json"},
                             {"run", "part.ngc"},
                             {"run", "part.ngc", "part.ngc", "--json"},
                             {"run", "part.ngc", "part.ngc", "--threads", "2"},
                             {"check", "part.ngc", "--json"},
                             {"verify", "part.csv", "part.ngc"},
                             {"simulate", "part.ngc", "--json"},
                             {"drive", "short.ngc"},
                             {"design", "--timer", "--clock", "1024", "--delays", "2,4,8"}};
  for (const Line& more : {Line{"--path", "--json"}, {"--table"}, {"--vcd", "/dev/stdout", "--quiet"}}) {
    lines.push_back(line);
    lines.back().insert(lines.back().end(), more.begin(), more.end());
  }
  for (const std::string option : {"--trace", "--report", "--picture", "--events", "--blocks"})
    lines.push_back({"run", "part.ngc", "--quiet", option, "/dev/stdout"});
  lines.push_back({"drive", "short.ngc", "--quiet", "--sink", "/dev/stdout"});
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "part.csv", "--quiet"}).status, 0);
  const Names before = folder.names();
  for (const Line& words : lines) {
    std::string shown;
    for (const std::string& word : words) shown += word + " ";
    const auto outcome = leadscrew(folder, words, {.output_is_closed = true});
    // A drive may warn of a system that is not permitted to be on time.
    EXPECT_FALSE(contains(outcome.errors, words.front() == "drive" ? "[io-" : "\n")) << shown << outcome.errors;
    EXPECT_EQ(outcome.status, 4) << shown;
    EXPECT_EQ(folder.names(), before) << shown;
  }
  // What is wrong with the program is told all the same.
  EXPECT_TRUE(contains(leadscrew(folder, {"check", "wrong.ngc"}, {.output_is_closed = true}).errors, "bad-number"));
}

TEST(Outputs, BehindAFileAreInputOutput) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const auto& [option, name] : {std::pair("--trace", "made.csv"), {"--report", "made.html"}}) {
    const auto run = leadscrew(folder, {"run", "part.ngc", option, std::string("part.ngc/") + name});
    EXPECT_EQ(run.status, 4);
    EXPECT_TRUE(contains(run.errors, "part.ngc: error: cannot make the folder: ")) << run.errors;
    EXPECT_EQ(folder.names(), Names{"part.ngc"});
  }
}

class Interruption : public ::testing::TestWithParam<int> {};

TEST_P(Interruption, InTheMiddleOfARunLeavesNothing) {
  const Folder folder;
  folder.write("part.ngc", long_program(long_blocks));
  auto arguments = run_with_every_output("part.ngc");
  arguments.emplace_back("--json");
  Running running(folder, arguments);
  ASSERT_TRUE(eventually([&] { return is_moving(folder.path()) || running.has_ended(); }));
  ASSERT_FALSE(running.has_ended());
  running.send(GetParam());
  const auto run = running.wait();
  EXPECT_EQ(run.status, 130);
  EXPECT_EQ(run.signal, 0);
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(run.errors, "");
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST_P(Interruption, KeepsWhatEarlierProgramsHaveWritten) {
  const Folder folder;
  folder.write("a.ngc", square);
  folder.write("b.ngc", long_program(long_blocks));
  folder.write("c.ngc", square);
  Running running(folder, {"run", "a.ngc", "b.ngc", "c.ngc", "--out", "made", "--threads", "1"});
  const fs::path made = folder.path() / "made";
  ASSERT_TRUE(eventually([&] { return (fs::exists(made / "a.csv") && is_moving(made)) || running.has_ended(); }));
  ASSERT_FALSE(running.has_ended());
  running.send(GetParam());
  EXPECT_EQ(running.wait().status, 130);
  EXPECT_EQ(folder.names(), (Names{"a.ngc", "b.ngc", "c.ngc", "made", "made/a.csv", "made/a.html", "made/a.svg"}));
}

TEST_P(Interruption, EndsWaitingForStandardInput) {
  const Folder folder;
  for (const char* command : {"run", "check"}) {
    Running running(folder, {command, "-"}, {.input = "G21\n", .input_stays_open = true});
    ASSERT_TRUE(eventually([&] { return running.is_reading() || running.has_ended(); }));
    // Again and again: a signal just before read() begins is seen only when read() ends.
    EXPECT_TRUE(eventually([&] {
      if (!running.has_ended()) running.send(GetParam());
      return running.has_ended();
    }));
    EXPECT_EQ(running.wait().status, 130);
  }
}

/// Not again and again, but once, at any instant: nothing waits for long without a look.
TEST_P(Interruption, EndsWaitingForAPipeAtOnce) {
  const Folder folder;
  folder.write("part.ngc", long_program(long_blocks));
  for (const char* pipe : {"in", "out"}) ASSERT_EQ(::mkfifo((folder.path() / pipe).c_str(), 0600), 0);
  const std::vector<std::vector<std::string>> commands = {
      {"run", "-"}, {"check", "in"}, {"run", "part.ngc", "--trace", "out"}, {"check", "in", "in", "--threads", "2"}};
  for (const auto& command : commands) {
    for (const int milliseconds : {100, 130, 160}) {
      Running running(folder, command, {.input = "G21\n", .input_stays_open = true});
      ASSERT_TRUE(eventually([&] { return running.handles(GetParam()) || running.has_ended(); }));
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      ASSERT_FALSE(running.has_ended()) << command[1];
      running.send(GetParam());
      EXPECT_EQ(running.wait().status, 130) << command[1];
    }
  }
}

/// Somebody has opened it and reads nothing.
TEST_P(Interruption, EndsWaitingForAFullPipe) {
  const Folder folder;
  folder.write("part.ngc", long_program(long_blocks));
  const std::string pipe = folder.path() / "out";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  Running running(folder, {"run", "part.ngc", "--trace", "out"});
  const int idle = ::open(pipe.c_str(), O_RDONLY);
  int waiting = 0;
  ASSERT_TRUE(eventually([&] { return ::ioctl(idle, FIONREAD, &waiting) == 0 && waiting > 32'768; }));
  running.send(GetParam());
  EXPECT_EQ(running.wait().status, 130);
  ::close(idle);
}

INSTANTIATE_TEST_SUITE_P(Both, Interruption, ::testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGINT ? "Int" : "Term"; });

}  // namespace test_failing_files
}  // namespace leadscrew::cli::testing
