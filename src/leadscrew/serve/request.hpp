#pragma once
// Which requests are answered: of this machine's own browser, for this server by its own name, with little behind them.
//
// A page of any other site can have a browser ask 127.0.0.1. It must name itself then (Origin), and where it leads the
// browser astray by a name of its own that is resolved to 127.0.0.1, it must name that (Host).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::serve {

/// Bytes behind a request, at most.
inline constexpr std::size_t largest_body = 4096;

struct Request {
  std::string method;                 ///< "GET"
  std::string path;                   ///< decoded, without its query
  std::string host;                   ///< empty: none was given
  std::optional<std::string> origin;  ///< the page that asks
  std::optional<std::string> length;  ///< of the body, as it was given
  bool is_in_pieces = false;          ///< a body of no told length: Transfer-Encoding
};

struct Refusal {
  int status = 400;
  std::string_view text;
};

/// Why the request is not answered: 403 of another host or origin, 405 of a method but GET, HEAD and POST, 411 of a body
/// whose length is not told, 413 of one above largest_body, 400 of a length that is no number. None: it is answered.
std::optional<Refusal> refusal_of(const Request& request, int port);

/// Are they the same, in a time that does not tell how much of them is?
bool is_same_secret(std::string_view a, std::string_view b);

/// 32 digits of chance, from the system. Empty where it gives none.
std::string new_secret();

}  // namespace leadscrew::serve
