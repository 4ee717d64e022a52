#include <fmt/format.h>

#include <leadscrew/serve/server.hpp>

namespace leadscrew::serve {

std::string Server::address() const {
  return fmt::format("http://127.0.0.1:{}/", port());
}

base::Diagnostic not_built(const std::string& why) {
  return base::problem("serve-not-built",
                       why.empty() ? "this build cannot serve pages" : "this build cannot serve pages: " + why,
                       "install libcpp-httplib-dev and pkgconf, and build it again");
}

}  // namespace leadscrew::serve
