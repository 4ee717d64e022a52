// The file that --state keeps: where it may lie, and what is not believed of it.

#include <gtest/gtest.h>
#include <unistd.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_state {

const std::string part = "G21 G90 G94\nG1 X2 F3000\nY1\nM2\n";

/// Of a drive to the end of the part, as if it had been stopped on its way.
Json stopped_state(const Folder& folder) {
  folder.write("part.ngc", part);
  const auto outcome = leadscrew(folder, {"drive", "part.ngc", "--state", "state", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  Json state = Json::parse(folder.read("state"));
  state["state"] = "stopped";
  return state;
}

Outcome resumed(const Folder& folder, const Json& state) {
  folder.write("state", state.dump());
  return leadscrew(folder, {"drive", "part.ngc", "--resume", "state", "--json"});
}

TEST(DriveState, ThatWasChangedByHandIsRefused) {
  const Folder folder;
  const Json state = stopped_state(folder);
  for (const auto& [key, value] : std::initializer_list<std::pair<const char*, Json>>{
           {"path_length", -1},
           {"path_length", nullptr},
           {"path_length", 1},     // where the path is elsewhere
           {"path_length", 1000},  // longer than it is
           {"word", -5},
           {"line", "two"},
           {"axes", {1, 2}},
           {"axes", {2, 0.9, 0, 0, 0, 0, 0, 0, 0}},  // not at the place of axes_path_length
           {"axes_path_length", 2},                  // before the last word
           {"axes_path_length", 1000},
           {"axes", {9000, 0, 0, 0, 0, 0, 0, 0, 0}},       // beyond the travel
           {"axes", {0, 0, 0, 30, 0, 0, 0, 0, 0}},         // of no axis there is
           {"position", {0, -9000, 0, 0, 0, 0, 0, 0, 0}},  //
           {"state", "asleep"}}) {
    Json changed = state;
    changed[key] = value;
    const auto outcome = resumed(folder, changed);
    EXPECT_EQ(outcome.status, 3) << changed;
    EXPECT_EQ(outcome.json()["diagnostics"][0]["code"], "resume-state") << changed;
  }
}

TEST(DriveState, NamesTheMachineFileAsItWas) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write("mill.toml", machine_text());
  const std::vector<std::string> with_mill = {"drive", "part.ngc", "--machine", "mill.toml", "--quiet"};
  auto first = with_mill, second = with_mill;
  first.insert(first.end(), {"--state", "state"});
  second.insert(second.end(), {"--resume", "state", "--json"});
  ASSERT_EQ(leadscrew(folder, first).status, 0);
  EXPECT_EQ(leadscrew(folder, second).json()["diagnostics"][0]["code"], "resume-ended");
  folder.write("mill.toml", machine_text() + "\n# another screw\n");
  EXPECT_EQ(leadscrew(folder, second).json()["diagnostics"][0]["code"], "resume-machine");
}

TEST(Drive, TellsThatItDidNotPauseWhereNobodyCouldSayWhenToGoOn) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X1 F3000\nM0\nG1 X2\nM2\n");
  const auto outcome = leadscrew(folder, {"drive", "part.ngc", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const Json figures = outcome.json();
  std::set<std::string> codes;
  for (const Json& told : figures["diagnostics"]) codes.insert(told["code"]);
  EXPECT_EQ(codes.count("pause-passed"), 1u);
}

TEST(DriveState, ReplacesNothingButAnEarlierOne) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write("other.ngc", part);
  const auto refused = leadscrew(folder, {"drive", "part.ngc", "--state", "other.ngc", "--json"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_EQ(refused.json()["diagnostics"][0]["code"], "state-other");
  EXPECT_EQ(folder.read("other.ngc"), part);
  for (int times = 0; times < 2; ++times)
    EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--state", "state", "--quiet"}).status, 0);
}

TEST(DriveState, LeavesNothingElseAndGoesWhereALinkLeads) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write("state.tmp", "of somebody else");
  ASSERT_EQ(::symlink("behind", (folder.path() / "link").c_str()), 0);
  EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--state", "link", "--quiet"}).status, 0);
  EXPECT_EQ(folder.names(), (Names{"behind", "link", "part.ngc", "state.tmp"}));
  EXPECT_EQ(Json::parse(folder.read("behind"))["state"], "ended");
  EXPECT_EQ(folder.read("state.tmp"), "of somebody else");
  const auto into_folder = leadscrew(folder, {"drive", "part.ngc", "--state", ".", "--json"});
  EXPECT_EQ(into_folder.json()["diagnostics"][0]["code"], "io-open");
  EXPECT_EQ(folder.names(), (Names{"behind", "link", "part.ngc", "state.tmp"}));
}

}  // namespace test_drive_state
}  // namespace leadscrew::cli::testing
