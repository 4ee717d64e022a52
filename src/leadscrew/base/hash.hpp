#pragma once
// XXH64 (Yann Collet's xxHash, 64 bits, seed 0): tells texts apart that differ by accident. It is no proof against
// somebody who looks for two texts of one sum.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace leadscrew::base {

/// Of bytes that come in parts of any size; the parts do not matter.
class Hash {
 public:
  void add(std::string_view bytes);

  /// Of all bytes so far.
  std::uint64_t value() const;
  /// How many there were.
  std::uint64_t count() const { return count_; }

 private:
  static constexpr std::uint64_t prime_1 = 0x9E3779B185EBCA87, prime_2 = 0xC2B2AE3D27D4EB4F,
                                 prime_3 = 0x165667B19E3779F9, prime_4 = 0x85EBCA77C2B2AE63,
                                 prime_5 = 0x27D4EB2F165667C5;
  static constexpr std::size_t stripe = 32;  // bytes: a word for each lane

  template <class Word>
  static std::uint64_t little_endian(const char* bytes) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i)
      word |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return word;
  }
  static std::uint64_t round(std::uint64_t lane, std::uint64_t word) {
    return std::rotl(lane + word * prime_2, 31) * prime_1;
  }
  void take_stripe(const char* bytes) {
    for (std::size_t i = 0; i < lanes_.size(); ++i)
      lanes_[i] = round(lanes_[i], little_endian<std::uint64_t>(bytes + 8 * i));
  }
  std::uint64_t merged_lanes() const;

  std::array<std::uint64_t, 4> lanes_ = {prime_1 + prime_2, prime_2, 0, 0 - prime_1};
  std::array<char, stripe> rest_{};  // of a stripe that is not full
  std::uint64_t count_ = 0;
};

inline void Hash::add(std::string_view bytes) {
  std::size_t filled = count_ % stripe;
  count_ += bytes.size();
  if (filled > 0) {
    const std::size_t taken = std::min(bytes.size(), stripe - filled);
    std::copy_n(bytes.begin(), taken, rest_.begin() + filled);
    bytes.remove_prefix(taken);
    if (filled + taken < stripe) return;
    take_stripe(rest_.data());
  }
  for (; bytes.size() >= stripe; bytes.remove_prefix(stripe)) take_stripe(bytes.data());
  std::copy(bytes.begin(), bytes.end(), rest_.begin());
}

inline std::uint64_t Hash::merged_lanes() const {
  if (count_ < stripe) return prime_5;
  std::uint64_t value =
      std::rotl(lanes_[0], 1) + std::rotl(lanes_[1], 7) + std::rotl(lanes_[2], 12) + std::rotl(lanes_[3], 18);
  for (const std::uint64_t lane : lanes_) value = (value ^ round(0, lane)) * prime_1 + prime_4;
  return value;
}

inline std::uint64_t Hash::value() const {
  std::uint64_t value = merged_lanes() + count_;
  const char* at = rest_.data();
  const char* const end = at + count_ % stripe;
  for (; end - at >= 8; at += 8)
    value = std::rotl(value ^ round(0, little_endian<std::uint64_t>(at)), 27) * prime_1 + prime_4;
  for (; end - at >= 4; at += 4)
    value = std::rotl(value ^ little_endian<std::uint32_t>(at) * prime_1, 23) * prime_2 + prime_3;
  for (; at != end; ++at) value = std::rotl(value ^ little_endian<unsigned char>(at) * prime_5, 11) * prime_1;
  value = (value ^ value >> 33) * prime_2;
  value = (value ^ value >> 29) * prime_3;
  return value ^ value >> 32;
}

}  // namespace leadscrew::base
