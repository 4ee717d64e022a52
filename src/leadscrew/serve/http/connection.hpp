#pragma once
// A connection as cpp-httplib asks for one. It never waits for longer than a tenth of a second without looking whether the
// server stops, and gives up whoever sends or takes nothing for too long.

#include <httplib.h>

#include <array>
#include <atomic>
#include <chrono>
#include <string>

namespace leadscrew::serve {

class Connection : public httplib::Stream {
 public:
  /// Of an open socket, which is closed with this; `stops` outlives it.
  Connection(int socket, const std::atomic<bool>& stops) : socket_(socket), stops_(stops) {}
  ~Connection() override;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Has the first byte of a request come, within a second?
  bool has_request();

  bool is_readable() const override { return begin_ < end_ || is_ready(0, for_reading); }
  /// Of now, without waiting.
  bool is_writable() const override { return is_ready(0, for_writing); }
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override { told(ip, port); }
  void get_local_ip_and_port(std::string& ip, int& port) const override { told(ip, port); }
  socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;
  static const short for_reading, for_writing;

  /// Nobody asks: it is this machine.
  static void told(std::string& ip, int& port) {
    ip = "127.0.0.1";
    port = 0;
  }
  bool is_ready(int milliseconds, short events) const;
  bool await(short events, Clock::time_point deadline) const;
  bool fill();

  const int socket_;
  const std::atomic<bool>& stops_;
  const Clock::time_point begun_ = Clock::now();
  std::array<char, 4096> buffer_{};
  std::size_t begin_ = 0, end_ = 0;  ///< of what was received and not read
};

}  // namespace leadscrew::serve
