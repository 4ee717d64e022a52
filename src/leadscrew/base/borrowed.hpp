#pragma once
// A parameter that is kept by reference.

namespace leadscrew::base {

/// A reference to what must outlive whoever takes it: a named object, never a temporary.
template <class T>
class Borrowed {
 public:
  Borrowed(const T& value) : value_(value) {}
  Borrowed(const T&&) = delete;

  operator const T&() const { return value_; }
  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

 private:
  const T& value_;
};

}  // namespace leadscrew::base
