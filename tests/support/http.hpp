#pragma once
// Requests to a server of this machine, byte by byte as they are written here: no library stands between.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace leadscrew::testing {

class HttpClient {
 public:
  /// Connects to 127.0.0.1; `received` bytes at most wait to be read, 0 for as many as usual.
  explicit HttpClient(int port, int received = 0) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (received > 0) ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &received, sizeof received);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw std::runtime_error("nobody listens");
  }
  ~HttpClient() { ::close(socket_); }
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  void send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

  /// What has come until the server closed, or until this text has come; for two minutes at most.
  std::string read_until(std::string_view text = {}) {
    std::size_t looked = 0;  // until there it has not come
    const auto has_come = [&] {
      if (text.empty() || all_.find(text, looked) != std::string::npos) return !text.empty();
      looked = all_.size() - std::min(all_.size(), text.size());
      return false;
    };
    pollfd ready = {socket_, POLLIN, 0};
    char buffer[65536];
    while (!has_come() && ::poll(&ready, 1, 120'000) > 0) {
      const ssize_t got = ::recv(socket_, buffer, sizeof buffer, 0);
      if (got <= 0) break;
      all_.append(buffer, static_cast<std::size_t>(got));
    }
    return all_;
  }

 private:
  int socket_;
  std::string all_;
};

struct HttpAnswer {
  int status = 0;
  std::string head, body;
};

inline HttpAnswer answer_of(const std::string& text) {
  const std::size_t end = text.find("\r\n\r\n");
  if (!text.starts_with("HTTP/1.1 ") || end == std::string::npos) return {};
  return {std::stoi(text.substr(9, 3)), text.substr(0, end + 2), text.substr(end + 4)};
}

/// A request with these header lines, each with its end, beside Host, where `host` is not empty.
inline std::string http_request(const std::string& method, const std::string& target, const std::string& host,
                                const std::string& lines = "", const std::string& body = "") {
  return method + " " + target + " HTTP/1.1\r\n" + (host.empty() ? "" : "Host: " + host + "\r\n") + lines + "\r\n" +
         body;
}

/// Asks under the server's own name.
inline HttpAnswer ask(int port, const std::string& method, const std::string& target, const std::string& lines = "",
                      const std::string& body = "") {
  HttpClient client(port);
  client.send(http_request(method, target, "127.0.0.1:" + std::to_string(port), lines, body));
  return answer_of(client.read_until());
}

inline HttpAnswer post(int port, const std::string& target, const std::string& body, const std::string& lines = "") {
  return ask(port, "POST", target, "Content-Length: " + std::to_string(body.size()) + "\r\n" + lines, body);
}

}  // namespace leadscrew::testing
