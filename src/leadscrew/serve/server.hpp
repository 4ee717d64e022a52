#pragma once
// The workbench on 127.0.0.1, and beside it, where a machine is driven, what the machine does:
//
//   GET /…              a file of the page
//   GET /live           events of the channel, as server-sent events; at most `most_viewers` at a time
//   GET /live/program   the text of the program that is driven; /live/machine and /live/tools that of its machine file and
//                       tool table, both empty of what there is none
//   POST /live/control  a wish, of whoever knows the token (header X-Leadscrew-Token)
//
// Modules, in the order of the data:
//   page             the files, in memory        request       which requests are answered
//   channel          events for viewers          live_events   what of a drive is told
//   http/            this, by cpp-httplib: leadscrew-serve.so, a module that is built where that is installed
//   server_load      loads it when pages are to be served
//   drive_stream     a drive that is looked upon: events out, wishes in

#include <functional>
#include <leadscrew/base/result.hpp>
#include <leadscrew/serve/channel.hpp>
#include <leadscrew/serve/page.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::serve {

inline constexpr int usual_port = 8737, most_viewers = 16;

/// A machine that is driven. What it refers to outlives the server.
struct Live {
  Channel& channel;
  std::string greeting;                                          ///< the event that each viewer gets first
  std::string program = {}, machine = {}, tools = {};            ///< texts
  std::optional<std::string> token = {};                         ///< none: nobody may control it
  std::function<bool(std::string_view body)> control = nullptr;  ///< false: that is no wish. From any thread
};

class Server {
 public:
  /// Stops: no more requests, and the viewers are let go within a second or two.
  virtual ~Server() = default;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Takes the port, 0 for any that is free; nobody is answered before start(). Errors: `io-listen`; `serve-not-built`
  /// where the module is missing, or cannot be loaded.
  static base::Result<std::unique_ptr<Server>> open(Page page, int port, std::optional<Live> live = std::nullopt);

  /// Answers from now on, by threads of its own.
  virtual void start() = 0;
  virtual int port() const = 0;
  /// "http://127.0.0.1:8737/".
  std::string address() const;

 protected:
  Server() = default;
};

/// The function in leadscrew-serve.so that opens a server, as Server::open() does.
inline constexpr const char* open_server_name = "leadscrew_open_server";
using OpenServer = void (*)(Page& page, int port, std::optional<Live>& live,
                            base::Result<std::unique_ptr<Server>>& opened);

/// `serve-not-built`. `why`: what the system says of the module; empty where there is none.
base::Diagnostic not_built(const std::string& why = {});

}  // namespace leadscrew::serve
