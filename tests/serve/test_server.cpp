// The server, asked byte by byte: whom it answers, with what, and that no viewer can hold it up.

#include <gtest/gtest.h>

#include <http.hpp>
#include <leadscrew/serve/request.hpp>
#include <leadscrew/serve/server.hpp>
#include <mutex>
#include <optional>

#include "folder.hpp"

namespace leadscrew::serve {
namespace test_server {

using leadscrew::testing::answer_of;
using leadscrew::testing::ask;
using leadscrew::testing::http_request;
using leadscrew::testing::HttpAnswer;
using leadscrew::testing::HttpClient;
using leadscrew::testing::post;

std::unique_ptr<Server> started(const PageFolder& folder, std::optional<Live> live = std::nullopt) {
  auto page = Page::read(folder.page());
  if (!page) throw std::runtime_error(page.error().message);
  auto server = Server::open(std::move(*page), 0, std::move(live));
  if (!server) throw std::runtime_error(server.error().message);
  (*server)->start();
  return std::move(*server);
}

HttpAnswer ask_as(int port, const std::string& host, const std::string& lines = "") {
  HttpClient client(port);
  client.send(http_request("GET", "/", host, lines));
  return answer_of(client.read_until());
}

TEST(Server, GivesTheFilesOfThePage) {
  const PageFolder folder;
  const auto server = started(folder);
  const HttpAnswer page = ask(server->port(), "GET", "/?any=query");
  EXPECT_EQ(page.status, 200);
  EXPECT_NE(page.head.find("Content-Type: text/html; charset=utf-8\r\n"), std::string::npos) << page.head;
  EXPECT_NE(page.body.find("the page"), std::string::npos);
  EXPECT_EQ(page.body.find("leadscrew-live"), std::string::npos);
  EXPECT_EQ(ask(server->port(), "GET", "/assets/engine.wasm").body, std::string("\0asm", 4));
  const HttpAnswer head = ask(server->port(), "HEAD", "/assets/code.js");
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.body, "");
  EXPECT_EQ(ask(server->port(), "GET", "/live").status, 404);
}

TEST(Server, GivesNothingOutsideItsFolder) {
  const PageFolder folder;
  std::filesystem::create_symlink("../secret", folder.page() / "link");
  const auto server = started(folder);
  for (const char* path : {"/../secret", "/%2e%2e/secret", "/..%2fsecret", "/%2E%2E%2Fsecret", "/assets/../../secret",
                           "//secret", "/..\\secret", "/%252e%252e/secret", "/%c0%ae%c0%ae/secret", "/link",
                           "/index.html%00", "/etc/passwd", "/..%00/secret"}) {
    const HttpAnswer answer = ask(server->port(), "GET", path);
    EXPECT_GE(answer.status, 400) << path;
    EXPECT_EQ(answer.body.find("secret"), std::string::npos) << path;
  }
}

TEST(Server, AnswersToItsOwnNameAlone) {
  const PageFolder folder;
  const auto server = started(folder);
  const std::string port = ":" + std::to_string(server->port());
  EXPECT_EQ(ask_as(server->port(), "127.0.0.1" + port).status, 200);
  EXPECT_EQ(ask_as(server->port(), "localhost" + port).status, 200);
  for (const std::string& host :
       {std::string(), "evil.example" + port, "127.0.0.1" + port + ".evil.example", std::string("127.0.0.1:1"),
        std::string("127.0.0.1"), "127.0.0.1.evil.example" + port})
    EXPECT_EQ(ask_as(server->port(), host).status, 403) << host;
  EXPECT_EQ(ask_as(server->port(), "127.0.0.1" + port, "Host: evil.example\r\n").status, 403);
  EXPECT_EQ(ask_as(server->port(), "127.0.0.1" + port, "Origin: http://localhost" + port + "\r\n").status, 200);
  for (const std::string& origin :
       {std::string("http://evil.example"), std::string("null"), "https://127.0.0.1" + port})
    EXPECT_EQ(ask_as(server->port(), "127.0.0.1" + port, "Origin: " + origin + "\r\n").status, 403) << origin;
}

TEST(Server, ListensOnTheLoopbackAlone) {
  const PageFolder folder;
  const auto server = started(folder);
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(server->port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK + 1);  // 127.0.0.2 is this machine too
  EXPECT_NE(::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

TEST(Server, RefusesLongBodiesAndWhatItDoesNotKnow) {
  const PageFolder folder;
  Channel channel(4);
  const auto server = started(folder, Live{.channel = channel, .greeting = "", .token = "key"});
  const auto status = [&](const std::string& method, const std::string& lines) {
    return ask(server->port(), method, "/live/control", lines).status;
  };
  EXPECT_EQ(status("POST", "Content-Length: 4097\r\n"), 413);
  EXPECT_EQ(status("POST", "Content-Length: 99999999999999999999\r\n"), 413);
  EXPECT_EQ(status("GET", "Content-Length: 4097\r\n"), 413);
  EXPECT_EQ(status("POST", "Content-Length: -1\r\n"), 400);
  EXPECT_EQ(status("POST", "Content-Length: 1\r\nContent-Length: 2\r\n"), 400);
  EXPECT_EQ(status("POST", "Transfer-Encoding: chunked\r\n"), 411);
  EXPECT_EQ(status("POST", ""), 411);
  EXPECT_EQ(status("DELETE", ""), 405);
  EXPECT_EQ(status("OPTIONS", ""), 405);
  EXPECT_EQ(ask(server->port(), "GET", "/" + std::string(20'000, 'a')).status, 414);
  std::string ranges = "Range: bytes=0-";
  while (ranges.size() < 8000) ranges += ",1-";
  EXPECT_EQ(ask(server->port(), "GET", "/none", ranges + "\r\n").status, 404);
}

TEST(Server, RefusesAPortThatIsTaken) {
  const PageFolder folder;
  const auto server = started(folder);
  auto page = Page::read(folder.page());
  ASSERT_TRUE(page);
  const auto second = Server::open(std::move(*page), server->port());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, "io-listen");
}

/// Of a build without cpp-httplib, where Server::open() does nothing but say so.
TEST(Server, SaysWhatToInstallWhereItIsNotBuilt) {
  EXPECT_EQ(not_built().code, "serve-not-built");
  EXPECT_NE(not_built().hint.find("libcpp-httplib-dev"), std::string::npos);
}

/// Whoever sends half a request, or nothing, does not keep it from ending.
TEST(Server, EndsWhateverIsConnected) {
  const PageFolder folder;
  auto server = started(folder);
  const HttpClient silent(server->port());
  const HttpClient half(server->port());
  half.send("GET / HTTP/1.1\r\nHost: 127");
  server.reset();
}

TEST(Control, NeedsTheToken) {
  const PageFolder folder;
  Channel channel(4);
  std::mutex mutex;
  std::vector<std::string> wishes;
  const auto take = [&](std::string_view body) {
    const std::lock_guard lock(mutex);
    wishes.emplace_back(body);
    return body != "unknown";
  };
  const auto server = started(folder, Live{.channel = channel, .greeting = "", .token = "key", .control = take});
  const std::string key = "X-Leadscrew-Token: key\r\n";
  EXPECT_EQ(post(server->port(), "/live/control", "hold").status, 403);
  EXPECT_EQ(post(server->port(), "/live/control", "hold", "X-Leadscrew-Token: other\r\n").status, 403);
  EXPECT_EQ(post(server->port(), "/live/control?token=key", "hold").status, 403);
  EXPECT_EQ(post(server->port(), "/live/control", "hold", key + "Origin: http://evil.example\r\n").status, 403);
  EXPECT_EQ(post(server->port(), "/other", "hold", key).status, 404);
  EXPECT_TRUE(wishes.empty());
  EXPECT_EQ(post(server->port(), "/live/control", "hold", key).status, 204);
  EXPECT_EQ(post(server->port(), "/live/control", "unknown", key).status, 400);
  EXPECT_EQ(wishes, (std::vector<std::string>{"hold", "unknown"}));
}

TEST(Control, IsNobodysWithoutAToken) {
  const PageFolder folder;
  Channel channel(4);
  const auto server = started(folder, Live{.channel = channel, .greeting = ""});
  EXPECT_EQ(post(server->port(), "/live/control", "hold", "X-Leadscrew-Token: \r\n").status, 403);
}

TEST(Control, TokensAreOfChance) {
  EXPECT_EQ(new_secret().size(), 32);
  EXPECT_NE(new_secret(), new_secret());
  EXPECT_TRUE(is_same_secret("abc", "abc"));
  for (const char* other : {"", "ab", "abd", "abcd"}) EXPECT_FALSE(is_same_secret("abc", other)) << other;
}

TEST(Stream, GreetsAndGoesOnWithTheLatestEvent) {
  const PageFolder folder;
  Channel channel(8);
  channel.publish("event: old\ndata: 0\n\n");
  channel.publish("event: sample\ndata: 1\n\n");
  const auto server = started(folder, Live{.channel = channel,
                                           .greeting = "event: machine\ndata: m\n\n",
                                           .program = "G0 X1\n",
                                           .machine = "name = \"m\"\n",
                                           .tools = "T1 P1\n"});
  EXPECT_NE(ask(server->port(), "GET", "/").body.find("leadscrew-live"), std::string::npos);
  EXPECT_EQ(ask(server->port(), "GET", "/live/program").body, "G0 X1\n");
  EXPECT_EQ(ask(server->port(), "GET", "/live/machine").body, "name = \"m\"\n");
  EXPECT_EQ(ask(server->port(), "GET", "/live/tools").body, "T1 P1\n");
  HttpClient viewer(server->port());
  viewer.send(http_request("GET", "/live", "localhost:" + std::to_string(server->port())));
  EXPECT_NE(viewer.read_until("data: 1\n").find("event: machine\ndata: m\n\n"), std::string::npos);
  channel.publish("event: sample\ndata: 2\n\n");
  viewer.read_until("data: 2\n");
  channel.publish("event: end\ndata: {}\n\n");
  channel.close();
  const std::string all = viewer.read_until();
  EXPECT_NE(all.find("Content-Type: text/event-stream"), std::string::npos);
  EXPECT_NE(all.find("event: end"), std::string::npos);
  EXPECT_EQ(all.find("data: 0"), std::string::npos);
}

/// Events go on while it takes nothing, and once it reads it is told what it has missed.
TEST(Stream, TellsAViewerThatLagsHowMuchItHasMissed) {
  const PageFolder folder;
  Channel channel(4);
  const auto server = started(folder, Live{.channel = channel, .greeting = "event: machine\ndata: m\n\n"});
  HttpClient lagging(server->port(), 4096);
  lagging.send(http_request("GET", "/live", "127.0.0.1:" + std::to_string(server->port())));
  lagging.read_until("event: machine");
  HttpClient reading(server->port());
  reading.send(http_request("GET", "/live", "127.0.0.1:" + std::to_string(server->port())));
  reading.read_until("event: machine");
  constexpr int count = 120;
  const std::string padding(100'000, 'x');
  for (int number = 0; number < count; ++number) {  // 12 MB, more than lies in any socket
    channel.publish("data: " + padding + " " + std::to_string(number) + "\n\n");
    if (number % 4 == 0) reading.read_until(" " + std::to_string(number) + "\n");
  }
  channel.close();
  EXPECT_EQ(reading.read_until().find("event: missed"), std::string::npos);
  const std::string seen = lagging.read_until();
  const std::string told = "event: missed\ndata: {\"missed\": ";
  int missed = 0, events = 0;
  for (std::size_t at = 0; (at = seen.find(told, at)) != std::string::npos;)
    missed += std::stoi(seen.substr(at += told.size()));
  for (std::size_t at = 0; (at = seen.find("data: xxx", at)) != std::string::npos; ++at) ++events;
  EXPECT_GT(missed, 0);
  EXPECT_EQ(missed + events, count);
  EXPECT_NE(seen.find(" 119\n"), std::string::npos);
}

TEST(Stream, HasRoomForSomeViewersOnly) {
  const PageFolder folder;
  Channel channel(4);
  const auto server = started(folder, Live{.channel = channel, .greeting = "event: machine\n\n"});
  std::vector<std::unique_ptr<HttpClient>> viewers;
  for (int number = 0; number < most_viewers; ++number) {
    viewers.push_back(std::make_unique<HttpClient>(server->port()));
    viewers.back()->send(http_request("GET", "/live", "127.0.0.1:" + std::to_string(server->port())));
    viewers.back()->read_until("machine");
  }
  EXPECT_EQ(ask(server->port(), "GET", "/live").status, 503);
  EXPECT_EQ(ask(server->port(), "GET", "/").status, 200);
  channel.close();
}

}  // namespace test_server
}  // namespace leadscrew::serve
