#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <leadscrew/serve/http/connection.hpp>

namespace leadscrew::serve {

namespace {

using namespace std::chrono_literals;

constexpr auto first_byte_patience = 1s, request_patience = 10s, write_patience = 10s;
constexpr int look = 100;  // ms between two looks whether the server stops

}  // namespace

const short Connection::for_reading = POLLIN;
const short Connection::for_writing = POLLOUT;

Connection::~Connection() {
  ::shutdown(socket_, SHUT_RDWR);
  ::close(socket_);
}

bool Connection::is_ready(int milliseconds, short events) const {
  pollfd asked = {socket_, events, 0};
  return ::poll(&asked, 1, milliseconds) > 0;
}

bool Connection::await(short events, Clock::time_point deadline) const {
  while (!stops_ && Clock::now() < deadline) {
    if (is_ready(look, events)) return true;
  }
  return false;
}

bool Connection::has_request() {
  return await(for_reading, begun_ + first_byte_patience);
}

bool Connection::fill() {
  while (await(for_reading, begun_ + request_patience)) {
    const ssize_t got = ::recv(socket_, buffer_.data(), buffer_.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    begin_ = 0;
    end_ = static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    return got > 0;
  }
  return false;
}

ssize_t Connection::read(char* to, size_t size) {
  if (begin_ == end_ && !fill()) return -1;
  const std::size_t count = std::min(size, end_ - begin_);
  std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), count, to);
  begin_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t Connection::write(const char* from, size_t size) {
  while (await(for_writing, Clock::now() + write_patience)) {
    const ssize_t sent = ::send(socket_, from, size, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent >= 0 || (errno != EAGAIN && errno != EINTR)) return sent;
  }
  return -1;
}

}  // namespace leadscrew::serve
