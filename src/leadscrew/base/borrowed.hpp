#pragma once
// A parameter that is kept by reference.

namespace leadscrew::base {

/// A reference to what must outlive whoever takes it: a named object, never a temporary.
template <class T>
class Borrowed {
 public:
  /// Of a named object.
  Borrowed(const T& value) : value_(value) {}
  /// Of no temporary.
  Borrowed(const T&&) = delete;

  /// The object.
  operator const T&() const { return value_; }
  /// The object.
  const T& operator*() const { return value_; }
  /// The object.
  const T* operator->() const { return &value_; }

 private:
  const T& value_;
};

}  // namespace leadscrew::base
