#pragma once
// Values whose memory is not touched before one of them is written: of a great array most is then never mapped.

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace leadscrew::realtime {

/// Of `count` values. One may be read when it has been written; before, what is read is undetermined. Holds no pointers: it may lie
/// in memory that two processes share.
template <class Value, std::size_t count>
class UntouchedArray {
  static_assert(std::is_trivially_copyable_v<Value>);

 public:
  UntouchedArray() noexcept {}  // NOLINT(modernize-use-equals-default): a defaulted one would let `T()` set all to zero

  /// `index` < count.
  void write(std::size_t index, const Value& value) noexcept {
    std::memcpy(bytes_.data() + index * sizeof(Value), &value, sizeof(Value));
  }
  /// The same.
  void read(std::size_t index, Value& value) const noexcept {
    std::memcpy(&value, bytes_.data() + index * sizeof(Value), sizeof(Value));
  }

 private:
  alignas(Value) std::array<std::byte, count * sizeof(Value)> bytes_;
};

}  // namespace leadscrew::realtime
