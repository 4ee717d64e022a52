#include <chrono>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/console/diagnostic_log.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <thread>

namespace leadscrew::cli {

namespace {

constexpr std::string_view serve_examples =
    "Examples:\n"
    "  leadscrew serve                            http://127.0.0.1:8737/, until ^C\n"
    "  leadscrew serve --port 0                   at any port that is free; it is printed\n"
    "\n"
    "Other machines are not answered, nor pages of other sites. script/web builds the pages.\n";

Parsed<int> parse_port(std::string_view text) {
  const auto number = parse_number(text);
  if (number && *number >= 0 && *number <= 65535 && *number == static_cast<int>(*number))
    return static_cast<int>(*number);
  return wrong("is no port from 0 to 65535, 0 for any that is free");
}

base::Result<std::unique_ptr<serve::Server>> open_workbench(int port) {
  return serve::page_folder()
      .and_then([](const auto& folder) { return serve::Page::read(folder); })
      .and_then([&](auto page) { return serve::Server::open(std::move(page), port); });
}

}  // namespace

void describe_serve(Command& command, Arguments& arguments) {
  command.value("--port", "PORT", "Where on 127.0.0.1; 0 for any that is free (default: 8737)", arguments.serve.port,
                parse_port);
  add_color(command, arguments);
  command.help(std::string(serve_examples));
}

void add_serve(Command& command, Arguments& arguments) {
  ServeArguments& asked = arguments.serve;
  command.optional_value<std::optional<int>>(
      "--serve", "PORT", "Show it to browsers on 127.0.0.1, at port 8737 or this one; 0 for any that is free",
      asked.port, serve::usual_port, parse_port);
  command.flag("--control", "Of --serve: whoever knows the token that is printed may hold, resume and stop it",
               asked.control);
  command.only_with("--serve", {"--control"});
}

Status serve(const Arguments& arguments, Console& console) {
  DiagnosticLog log(console);
  auto server = open_workbench(arguments.serve.port.value_or(serve::usual_port));
  if (!server) {
    log.add(server.error());
    return server.error().code == "serve-not-built" ? Status::usage : log.status();
  }
  (*server)->start();
  if (const Status written = write_output(console, (*server)->address() + "\n"); written != Status::done)
    return written;
  while (!files::interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  log.add(files::interruption());
  return log.status();
}

}  // namespace leadscrew::cli
