#pragma once
// What a program says to people in its remarks, (MSG,…), (DEBUG,…) and (PRINT,…): as text, and kept for JSON.

#include <cstdint>
#include <functional>
#include <leadscrew/gcode/remark.hpp>
#include <string>
#include <vector>

namespace leadscrew::results {

/// "part.ngc:7: text" of a message, the text alone of PRINT, each with its line feed; empty of what log files get.
std::string text_of(const gcode::Remark& remark);

class Messages {
 public:
  /// So many are kept, of so many bytes together.
  static constexpr std::size_t most = 1000, most_bytes = 1 << 20;

  /// `say` shows each as text, by whichever thread reads the program.
  explicit Messages(std::function<void(const std::string&)> say) : say_(std::move(say)) {}

  /// Refers to this, which must stay where it is.
  gcode::RemarkSink sink();

  /// The first of them, in the order in which they were said.
  const std::vector<gcode::Remark>& kept() const { return kept_; }
  std::int64_t count() const { return count_; }

 private:
  std::function<void(const std::string&)> say_;
  std::vector<gcode::Remark> kept_;
  std::size_t bytes_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace leadscrew::results
