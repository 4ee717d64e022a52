// `leadscrew serve`: the installed page on 127.0.0.1 until it is interrupted.

#include <gtest/gtest.h>

#include <http.hpp>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_serve {

using leadscrew::testing::ask;

/// The command in bin/ of the folder.
Surroundings installed(const Folder& folder) {
  std::filesystem::create_directories(folder.path() / "share/leadscrew/web");
  install_command(folder);
  return {.command = (folder.path() / "bin/leadscrew").string()};
}

TEST(Serve, GivesTheInstalledPageUntilItIsInterrupted) {
  const Folder folder;
  const Surroundings surroundings = installed(folder);
  folder.write("share/leadscrew/web/index.html", "the page");
  Running server(folder, {"serve", "--port", "0"}, surroundings);
  const std::string start = "http://127.0.0.1:";
  ASSERT_TRUE(eventually([&] { return server.output_by_now().ends_with("/\n"); }));
  const std::string address = server.output_by_now();
  ASSERT_TRUE(address.starts_with(start)) << address;
  const int port = std::stoi(address.substr(start.size()));
  EXPECT_EQ(ask(port, "GET", "/").body, "the page");
  const auto second = leadscrew(folder, {"serve", "--port", std::to_string(port)}, surroundings);
  EXPECT_EQ(second.status, 4);
  EXPECT_TRUE(contains(second.errors, "[io-listen]")) << second.errors;
  server.send(SIGINT);
  const Outcome outcome = server.wait();
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.errors, "");
}

TEST(Serve, SaysThatThePageIsNotThere) {
  const Folder folder;
  const auto outcome = leadscrew(folder, {"serve", "--port", "0"}, installed(folder));
  EXPECT_EQ(outcome.status, 4);
  EXPECT_TRUE(contains(outcome.errors, "[io-no-page]") && contains(outcome.errors, "script/web builds it"))
      << outcome.errors;
  EXPECT_EQ(outcome.output, "");
}

/// The server is a module that the command loads; without one, or with another file of its name, it says so.
TEST(Serve, SaysThatItsServerIsNotThere) {
  const Folder folder;
  const Surroundings surroundings = installed(folder);
  folder.write("share/leadscrew/web/index.html", "the page");
  std::filesystem::remove(folder.path() / "bin/leadscrew-serve.so");
  const auto missing = leadscrew(folder, {"serve", "--port", "0"}, surroundings);
  EXPECT_EQ(missing.status, 2);
  EXPECT_TRUE(contains(missing.errors, "this build cannot serve pages [serve-not-built]")) << missing.errors;
  folder.write("bin/leadscrew-serve.so", "no module");
  const auto broken = leadscrew(folder, {"serve", "--port", "0"}, surroundings);
  EXPECT_EQ(broken.status, 2);
  EXPECT_TRUE(contains(broken.errors, "leadscrew-serve.so") && contains(broken.errors, "[serve-not-built]"))
      << broken.errors;
}

TEST(Serve, WantsAPort) {
  const Folder folder;
  for (const char* port : {"-1", "65536", "80.5", "http", ""})
    EXPECT_EQ(leadscrew(folder, {"serve", "--port", port}).status, 2) << port;
}

}  // namespace test_serve
}  // namespace leadscrew::cli::testing
