#pragma once
// The first of the values that options may not have, as a diagnostic: "damping is -1", "0 or more".

#include <leadscrew/base/diagnostic.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::servo {

class Refusal {
 public:
  /// `code` of the diagnostic, and `what` below, which becomes the field of its subject: in static storage.
  explicit Refusal(std::string_view code) : code_(code) {}

  /// Finite and above 0.
  void unless_positive(std::string_view what, double value);
  /// Finite and 0 or more.
  void unless_not_negative(std::string_view what, double value);
  /// Above 0; infinite where there is none.
  void unless_limit(std::string_view what, double value);
  void unless_within(std::string_view what, double value, double low, double high);

  /// The first that was refused; empty when all is well.
  const std::optional<base::Diagnostic>& found() const { return found_; }

 private:
  void refuse(std::string_view what, double value, std::string hint);

  std::string_view code_;
  std::optional<base::Diagnostic> found_;
};

}  // namespace leadscrew::servo
