#include <fmt/format.h>

#include <charconv>
#include <leadscrew/sweep/key.hpp>

namespace leadscrew::sweep {

std::string text_of(const Key& key) {
  return fmt::format("{:016x}{:016x}", key.high, key.low);
}

std::optional<Key> key_of_text(std::string_view text) {
  constexpr std::size_t half = 16;
  if (text.size() != 2 * half) return std::nullopt;
  Key key;
  const auto read = [&](std::size_t at, std::uint64_t& value) {
    const char* const end = text.data() + at + half;
    const auto [stopped, error] = std::from_chars(text.data() + at, end, value, 16);
    return error == std::errc{} && stopped == end;
  };
  if (!read(0, key.high) || !read(half, key.low)) return std::nullopt;
  return key;
}

void KeyMaker::add(std::string_view part) {
  const std::string length = fmt::format("{};", part.size());
  for (base::Hash* hash : {&first_, &second_}) {
    hash->add(length);
    hash->add(part);
  }
}

}  // namespace leadscrew::sweep
