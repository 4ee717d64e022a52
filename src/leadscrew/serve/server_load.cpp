#include <dlfcn.h>

#include <leadscrew/files/beside_command.hpp>
#include <leadscrew/serve/server.hpp>
#include <utility>

namespace leadscrew::serve {

base::Result<std::unique_ptr<Server>> Server::open(Page page, int port, std::optional<Live> live) {
  const auto path = files::beside_command({"leadscrew-serve.so", LEADSCREW_INSTALLED_SERVER});
  if (!path) return base::failure(not_built());
  // It stays loaded: the server's code is in it, and what its errors say.
  void* const module = ::dlopen(path->c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) return base::failure(not_built(::dlerror()));
  const auto open_server = reinterpret_cast<OpenServer>(::dlsym(module, open_server_name));
  if (open_server == nullptr) return base::failure(not_built(path->string() + " has no " + open_server_name));
  base::Result<std::unique_ptr<Server>> opened;
  open_server(page, port, live, opened);
  return opened;
}

}  // namespace leadscrew::serve
