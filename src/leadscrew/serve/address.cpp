#include <fmt/format.h>

#include <leadscrew/serve/server.hpp>

namespace leadscrew::serve {

std::string Server::address() const {
  return fmt::format("http://127.0.0.1:{}/", port());
}

base::Diagnostic not_built() {
  return base::problem("serve-not-built", "this build cannot serve pages",
                       "install libcpp-httplib-dev and pkgconf, and build it again");
}

}  // namespace leadscrew::serve
