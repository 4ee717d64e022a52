// The server by cpp-httplib, in a module of its own (server_load.cpp). Everything is settled before its own routing, and by a connection of ours.

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/serve/http/connection.hpp>
#include <leadscrew/serve/http/threads.hpp>
#include <leadscrew/serve/http/viewer.hpp>
#include <leadscrew/serve/request.hpp>
#include <leadscrew/serve/server.hpp>
#include <mutex>
#include <thread>
#include <utility>

namespace leadscrew::serve {

namespace {

constexpr const char* own_host = "127.0.0.1";
constexpr std::size_t most_threads = most_viewers + 8;
constexpr std::chrono::seconds longest_farewell(2);

Request request_of(const httplib::Request& given) {
  const auto header = [&](const char* name) {
    return given.has_header(name) ? std::optional(given.get_header_value(name)) : std::nullopt;
  };
  // Of two of them, another than ours may be believed elsewhere.
  const bool names_one_host = given.get_header_value_count("Host") == 1;
  Request request{given.method,
                  given.path,
                  names_one_host ? given.get_header_value("Host") : "",
                  header("Origin"),
                  header("Content-Length"),
                  given.has_header("Transfer-Encoding")};
  if (given.get_header_value_count("Content-Length") > 1) request.length = "two";
  return request;
}

class HttpServer : public Server, private httplib::Server {
 public:
  HttpServer(Page page, std::optional<Live> live) : page_(std::move(page)), live_(std::move(live)) {
    if (live_) page_.mark_live();
    new_task_queue = [] { return new Threads(most_threads); };
    set_address_family(AF_INET);
    set_keep_alive_max_count(1);
    set_payload_max_length(largest_body);
    // Without SO_REUSEPORT, which would let two servers have the same port.
    set_socket_options([](int socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      return answer(request, response) ? HandlerResponse::Handled : HandlerResponse::Unhandled;
    });
    Post("/live/control", [this](const httplib::Request& request, httplib::Response& response) {
      if (live_->control && live_->control(request.body)) return end(response, 204, "");
      end(response, 400, "no wish that is known");
    });
  }
  ~HttpServer() override { stop_all(); }

  base::Result<void> bind(int port) {
    errno = 0;
    port_ = port == 0 ? bind_to_any_port(own_host) : (bind_to_port(own_host, port) ? port : -1);
    if (port_ > 0) return {};
    auto problem = files::system_failure("io-listen", "cannot listen", fmt::format("{}:{}", own_host, port), errno);
    problem.hint = "another program may have the port: 0 takes one that is free";
    return base::failure(problem);
  }

  void start() override {
    listener_ = std::thread([this] { listen_after_bind(); });
    while (!is_running()) std::this_thread::yield();
  }
  int port() const override { return port_; }

 private:
  bool process_and_close_socket(socket_t socket) override {
    Connection connection(socket, stops_);
    if (!connection.has_request()) return false;
    bool is_closed = false;
    return process_request(connection, true, is_closed, nullptr);
  }

  static void end(httplib::Response& response, int status, std::string_view text) {
    response.status = status;
    response.set_content(text.data(), text.size(), "text/plain; charset=utf-8");
  }

  /// False: a body is to be read first.
  bool answer(const httplib::Request& request, httplib::Response& response) {
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cache-Control", "no-cache");
    response.set_header("Content-Security-Policy", "frame-ancestors 'none'");
    if (const auto refusal = refusal_of(request_of(request), port_)) {
      end(response, refusal->status, refusal->text);
    } else if (request.method == "POST") {
      return answer_wish(request, response);
    } else if (live_ && request.path == "/live") {
      answer_viewer(request, response);
    } else if (const std::string* text = text_at(request.path)) {
      give(response, *text, "text/plain; charset=utf-8");
    } else if (const PageFile* file = page_.find(request.path)) {
      give(response, file->text, file->type);
    } else {
      end(response, 404, "there is no such page");
    }
    return true;
  }

  /// Of what is driven; null where there is no such text.
  const std::string* text_at(const std::string& path) const {
    if (!live_) return nullptr;
    if (path == "/live/program") return &live_->program;
    if (path == "/live/machine") return &live_->machine;
    return path == "/live/tools" ? &live_->tools : nullptr;
  }

  bool answer_wish(const httplib::Request& request, httplib::Response& response) {
    const bool is_known = live_ && request.path == "/live/control";
    if (is_known && live_->token && is_same_secret(request.get_header_value("X-Leadscrew-Token"), *live_->token))
      return false;
    end(response, is_known ? 403 : 404,
        is_known ? (live_->token ? "the token is another" : "this machine is only shown") : "there is no such page");
    return true;
  }

  /// From memory that outlives the response, uncompressed.
  static void give(httplib::Response& response, const std::string& text, std::string_view type) {
    if (text.empty()) return response.set_content("", std::string(type));
    response.set_content_provider(text.size(), std::string(type),
                                  [&text](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                    if (offset > text.size() || length > text.size() - offset) return false;
                                    return sink.write(text.data() + offset, length);
                                  });
  }

  void answer_viewer(const httplib::Request& request, httplib::Response& response) {
    if (request.method == "HEAD") return end(response, 405, "events are for GET");
    if (!enter()) return end(response, 503, "too many look on");
    const auto viewer = std::make_shared<Viewer>(live_->channel, live_->greeting, stops_);
    response.set_chunked_content_provider(
        "text/event-stream", [viewer](std::size_t, httplib::DataSink& sink) { return viewer->feed(sink); },
        [this](bool) { leave(); });
  }

  bool enter() {
    const std::lock_guard lock(mutex_);
    if (is_leaving_ || viewers_ >= most_viewers) return false;
    ++viewers_;
    return true;
  }
  void leave() {
    const std::lock_guard lock(mutex_);
    --viewers_;
    left_.notify_all();
  }

  /// Viewers get the last events first.
  void stop_all() {
    if (live_) {
      live_->channel.close();
      std::unique_lock lock(mutex_);
      is_leaving_ = true;
      left_.wait_for(lock, longest_farewell, [this] { return viewers_ == 0; });
    }
    stops_ = true;
    if (is_running()) stop();
    if (const socket_t left = svr_sock_.exchange(INVALID_SOCKET); left != INVALID_SOCKET)
      ::close(left);  // never started
    if (listener_.joinable()) listener_.join();
  }

  Page page_;
  const std::optional<Live> live_;
  int port_ = -1;
  std::atomic<bool> stops_{false};
  std::mutex mutex_;
  std::condition_variable left_;
  int viewers_ = 0;
  bool is_leaving_ = false;
  std::thread listener_;
};

}  // namespace

}  // namespace leadscrew::serve

extern "C" void leadscrew_open_server(leadscrew::serve::Page& page, int port,
                                      std::optional<leadscrew::serve::Live>& live,
                                      leadscrew::base::Result<std::unique_ptr<leadscrew::serve::Server>>& opened) {
  auto server = std::make_unique<leadscrew::serve::HttpServer>(std::move(page), std::move(live));
  if (auto bound = server->bind(port); !bound)
    opened = leadscrew::base::failure(bound.error());
  else
    opened = std::move(server);
}
