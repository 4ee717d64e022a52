#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <leadscrew/serve/request.hpp>

namespace leadscrew::serve {

namespace {

bool is_own_name(std::string_view name, int port) {
  for (const std::string_view own : {"127.0.0.1", "localhost"}) {
    // Browsers leave the port of the protocol out.
    if (name == fmt::format("{}:{}", own, port) || (port == 80 && name == own)) return true;
  }
  return false;
}

std::optional<Refusal> refusal_of_body(const Request& request) {
  if (request.is_in_pieces) return Refusal{411, "tell the length of the body"};
  if (!request.length) {
    if (request.method == "POST") return Refusal{411, "tell the length of the body"};
    return std::nullopt;
  }
  std::uint64_t length = 0;
  const char* const end = request.length->data() + request.length->size();
  const auto [last, error] = std::from_chars(request.length->data(), end, length);
  if (error == std::errc::result_out_of_range) return Refusal{413, "the body is too long"};
  if (error != std::errc() || last != end) return Refusal{400, "the length of the body is no number"};
  return length > largest_body ? std::optional(Refusal{413, "the body is too long"}) : std::nullopt;
}

}  // namespace

std::optional<Refusal> refusal_of(const Request& request, int port) {
  if (!is_own_name(request.host, port))
    return Refusal{403, "this server is asked by the name that it was started with"};
  constexpr std::string_view protocol = "http://";
  if (request.origin) {
    const std::string_view origin = *request.origin;
    if (!origin.starts_with(protocol) || !is_own_name(origin.substr(protocol.size()), port))
      return Refusal{403, "only the pages of this server may ask it"};
  }
  if (request.method != "GET" && request.method != "HEAD" && request.method != "POST")
    return Refusal{405, "GET, HEAD and POST are answered"};
  return refusal_of_body(request);
}

bool is_same_secret(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

std::string new_secret() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  std::string digits;
  for (const unsigned char byte : bytes) digits += fmt::format("{:02x}", byte);
  return digits;
}

}  // namespace leadscrew::serve
