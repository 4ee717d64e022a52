// A drive that browsers look upon: its words are what they are without, it is seen as it moves, and who has the token may hold it.

#include <gtest/gtest.h>

#include <http.hpp>
#include <memory>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_serve {

using leadscrew::testing::ask;
using leadscrew::testing::http_request;
using leadscrew::testing::HttpClient;
using leadscrew::testing::post;

/// Folder with the command in bin/ and a page where installation puts it.
class Installed : public Folder {
 public:
  Installed() {
    std::filesystem::create_directories(path() / "share/leadscrew/web");
    write("share/leadscrew/web/index.html", "<html><head></head></html>");
    install_command(*this);
  }
  Surroundings surroundings() const { return {.command = (path() / "bin/leadscrew").string()}; }
};

/// A line that the command has written, whole.
std::string line_with(const Running& running, const std::string& part) {
  std::string line;
  EXPECT_TRUE(eventually([&] {
    const std::string errors = running.errors_by_now();
    const std::size_t begin = errors.find(part), end = errors.find('\n', begin);
    if (begin == std::string::npos || end == std::string::npos) return false;
    line = errors.substr(begin, end - begin);
    return true;
  })) << running.errors_by_now();
  return line;
}

int port_of(const Running& running) {
  const std::string start = "live at http://127.0.0.1:", line = line_with(running, start);
  return line.starts_with(start) ? std::stoi(line.substr(start.size())) : 0;
}

/// The line of a token, as a header has it.
std::string token_of(const Running& running) {
  const std::string line = line_with(running, "live at"), start = ", token ";
  const std::size_t at = line.find(start);
  EXPECT_NE(at, std::string::npos) << line;
  return "X-Leadscrew-Token: " + (at == std::string::npos ? "" : line.substr(at + start.size())) + "\r\n";
}

/// Nobody is answered before the drives are there.
std::unique_ptr<HttpClient> viewer_of(int port, int received = 0) {
  auto viewer = std::make_unique<HttpClient>(port, received);
  viewer->send(http_request("GET", "/live", "127.0.0.1:" + std::to_string(port)));
  return viewer;
}

/// Data of the events of this name.
std::vector<Json> data_of(const std::string& stream, const std::string& name) {
  std::vector<Json> data;
  const std::string start = "event: " + name + "\ndata: ";
  for (std::size_t at = 0; (at = stream.find(start, at)) != std::string::npos;) {
    at += start.size();
    data.push_back(Json::parse(stream.substr(at, stream.find('\n', at) - at), nullptr, false));
  }
  return data;
}

TEST(DriveServe, MakesTheWordsOfRunWithTenViewersOneOfWhichReadsNothing) {
  const Installed folder;
  folder.write("part.ngc", part);
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv"}).status, 0);
  Running drive(
      folder,
      {"drive", "part.ngc", "--trace", "driven.csv", "--look-ahead", "60s", "--lead", "2s", "--json", "--serve", "0"},
      folder.surroundings());
  const int port = port_of(drive);
  std::vector<std::unique_ptr<HttpClient>> viewers;
  while (viewers.size() < 10) viewers.push_back(viewer_of(port, viewers.empty() ? 2048 : 0));
  for (std::size_t i = 1; i < viewers.size(); ++i) viewers[i]->read_until("event: end");
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.json()["starvations"], 0);
  EXPECT_EQ(folder.read("driven.csv"), folder.read("run.csv"));
  const auto words = rows_of(folder.read("run.csv"));
  for (std::size_t i = 1; i < viewers.size(); ++i) {
    const std::string stream = viewers[i]->read_until();
    const auto samples = data_of(stream, "sample");
    EXPECT_GT(samples.size(), 50);
    // What is shown are words of run.
    for (const Json& sample : samples) {
      const auto tick = static_cast<std::size_t>(std::lround(sample["t"].get<double>() * 1e3));
      ASSERT_LT(tick, words.size());
      EXPECT_EQ(sample["position"], words[tick].q);
    }
    EXPECT_EQ(samples.back()["position"], words.back().q);
    EXPECT_EQ(data_of(stream, "machine").front()["may_control"], false);
  }
}

TEST(DriveServe, ObeysWhoHasTheToken) {
  const Installed folder;
  folder.write("part.ngc", part);
  Running drive(folder, {"drive", "part.ngc", "--serve", "0", "--control", "--json"}, folder.surroundings());
  const int port = port_of(drive);
  const std::string token = token_of(drive);
  const auto viewer = viewer_of(port);
  viewer->read_until("\"state\":\"moving\"");
  EXPECT_EQ(ask(port, "GET", "/live/program").body, part);
  EXPECT_EQ(post(port, "/live/control", R"({"hold": true})").status, 403);
  EXPECT_EQ(post(port, "/live/control", R"({"hold": true, "override": 0.5})", token).status, 204);
  viewer->read_until("\"state\":\"held\"");
  EXPECT_EQ(post(port, "/live/control", R"({"jump": true})", token).status, 400);
  EXPECT_EQ(post(port, "/live/control", R"({"hold": false})", token).status, 204);
  EXPECT_EQ(post(port, "/live/control", R"({"stop": true})", token).status, 204);
  const auto samples = data_of(viewer->read_until(), "sample");
  EXPECT_EQ(samples.back()["state"], "stopping");
  EXPECT_EQ(samples.back()["override"], 0.5);
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 130) << outcome.errors;
  EXPECT_EQ(outcome.json()["end"], "stopped");
}

/// A thread goes on as it is programmed, which is told; so is that a program forbids to hold.
TEST(DriveServe, TellsThatAHoldWaitsForTheEndOfAThread) {
  const Installed folder;
  folder.write("part.ngc", "G21 G90 G94\nS600 M3\nG33 Z-20 K1\nG1 X5 F600\nM53 P0\nG1 X500 F3000\nM2\n");
  Running drive(folder, {"drive", "part.ngc", "--serve", "0", "--control", "--json"}, folder.surroundings());
  const int port = port_of(drive);
  const std::string token = token_of(drive);
  const auto viewer = viewer_of(port);
  viewer->read_until("\"state\":\"moving\"");
  EXPECT_EQ(post(port, "/live/control", R"({"hold": true})", token).status, 204);
  viewer->read_until("\"state\":\"hold_waits\"");
  viewer->read_until("\"state\":\"held\"");
  EXPECT_EQ(post(port, "/live/control", R"({"hold": false})", token).status, 204);
  viewer->read_until("\"line\":6,");
  EXPECT_EQ(post(port, "/live/control", R"({"hold": true})", token).status, 204);
  viewer->read_until("\"state\":\"hold_refused\"");
  EXPECT_EQ(post(port, "/live/control", R"({"stop": true})", token).status, 204);
  const auto samples = data_of(viewer->read_until(), "sample");
  for (const Json& sample : samples) EXPECT_TRUE(sample["state"] != "held" || sample["position"][2] == -20) << sample;
  EXPECT_EQ(drive.wait().status, 130);
}

/// Without a terminal it is the page that lets motion go on, each pause by itself.
TEST(DriveServe, WaitsAtPausesForWhoHasTheToken) {
  const Installed folder;
  folder.write("part.ngc", "G21 G90 F6000\nG1 X1\nM0\nG1 X2\nM1\nX3\nM2\n");
  Running drive(folder, {"drive", "part.ngc", "--serve", "0", "--control", "--json", "--trace", "driven.csv"},
                folder.surroundings());
  const int port = port_of(drive);
  const std::string token = token_of(drive);
  const auto viewer = viewer_of(port);
  for (const char* line : {"3", "5"}) {
    const std::string stream = viewer->read_until(std::string("\"pause_line\":") + line);
    EXPECT_EQ(data_of(stream, "end").size(), 0);
    EXPECT_EQ(post(port, "/live/control", R"({"go_on": true})", token).status, 204);
  }
  const auto samples = data_of(viewer->read_until("event: end"), "sample");
  EXPECT_EQ(samples.back()["position"][0], 3);
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.json()["end"], "done");
  EXPECT_FALSE(places_of(outcome.json()["diagnostics"]).contains("0:0 pause-passed"));
}

TEST(DriveServe, PassesPausesWhereNobodyMayControl) {
  const Installed folder;
  folder.write("part.ngc", "G21 G90 F6000\nG1 X1\nM0\nG1 X2\nM2\n");
  const Outcome outcome = leadscrew(folder, {"drive", "part.ngc", "--serve", "0", "--json"}, folder.surroundings());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(places_of(outcome.json()["diagnostics"]).contains("0:0 pause-passed")) << outcome.output;
}

TEST(DriveServe, OnlyShowsWithoutControl) {
  const Installed folder;
  folder.write("part.ngc", part);
  Running drive(folder, {"drive", "part.ngc", "--serve", "0"}, folder.surroundings());
  const int port = port_of(drive);
  EXPECT_FALSE(contains(drive.errors_by_now(), "token"));
  viewer_of(port)->read_until("event: sample");
  EXPECT_EQ(post(port, "/live/control", R"({"stop": true})", "X-Leadscrew-Token: \r\n").status, 403);
  drive.send(SIGINT);
  EXPECT_EQ(drive.wait().status, 130);
}

TEST(DriveServe, TellsWhereTheTipIs) {
  const Installed folder;
  folder.write("part.ngc", "G21 G90 G94 F3000\nG43.4\nG1 X10 A10 C20\nG1 X20 A5\nM2\n");
  Running drive(folder,
                {"drive", "part.ngc", "--serve", "0", "--sink", "words.csv", "--machine",
                 (source_folder / "machines/table-table-ac.toml").string()},
                folder.surroundings());
  const auto viewer = viewer_of(port_of(drive));
  const auto samples = data_of(viewer->read_until(), "sample");
  EXPECT_EQ(drive.wait().status, 0);
  ASSERT_FALSE(samples.empty());
  const auto rows = rows_of(folder.read("words.csv"));  // columns 5 to 10: the tip and the direction
  for (const Json& sample : samples) {
    const auto tick = static_cast<std::size_t>(std::lround(sample["t"].get<double>() * 1e3));
    ASSERT_LT(tick, rows.size());
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(sample["tip"][i].get<double>(), rows[tick].q[5 + i], 1e-12);
      EXPECT_NEAR(sample["direction"][i].get<double>(), rows[tick].q[8 + i], 1e-12);
    }
  }
}

TEST(DriveServe, MovesNothingWhereItCannotBeServed) {
  const Installed folder;
  folder.write("part.ngc", part);
  std::filesystem::remove(folder.path() / "share/leadscrew/web/index.html");
  const auto none =
      leadscrew(folder, {"drive", "part.ngc", "--serve", "0", "--trace", "words.csv"}, folder.surroundings());
  EXPECT_EQ(none.status, 4);
  EXPECT_TRUE(contains(none.errors, "[io-no-page]")) << none.errors;
  EXPECT_FALSE(exists(folder, "words.csv"));
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--serve", "part.ngc"}, {"--serve", "65536"}, {"--control"}}) {
    std::vector<std::string> arguments = {"drive", "part.ngc"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(leadscrew(folder, arguments).status, 2) << wrong.front();
  }
}

}  // namespace test_drive_serve
}  // namespace leadscrew::cli::testing
