#pragma once
// What determines a task, in 128 bits: two tasks of one key give one result, and are done once.

#include <compare>
#include <cstdint>
#include <leadscrew/base/hash.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::sweep {

struct Key {
  std::uint64_t high = 0, low = 0;

  friend auto operator<=>(const Key&, const Key&) = default;
};

/// 32 hexadecimal digits.
std::string text_of(const Key& key);
/// Of such a text; empty where it is none.
std::optional<Key> key_of_text(std::string_view text);

/// Of parts that are added one by one, each told apart from its neighbours. XXH64 twice, of the parts and of the parts behind
/// another beginning: texts that differ by accident have one key once in 2^128.
class KeyMaker {
 public:
  KeyMaker() { second_.add("second"); }

  void add(std::string_view part);
  /// Of the part that is added in pieces.
  void add_more(std::string_view piece) {
    first_.add(piece);
    second_.add(piece);
  }
  Key key() const { return {first_.value(), second_.value()}; }

 private:
  base::Hash first_, second_;
};

}  // namespace leadscrew::sweep
