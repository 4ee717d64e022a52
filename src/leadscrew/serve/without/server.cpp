#include <leadscrew/serve/server.hpp>

namespace leadscrew::serve {

base::Result<std::unique_ptr<Server>> Server::open(Page, int, std::optional<Live>) {
  return base::failure(not_built());
}

}  // namespace leadscrew::serve
