#include <fmt/format.h>

#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/messages.hpp>

namespace leadscrew::results {

std::string text_of(const gcode::Remark& remark) {
  switch (remark.kind) {
    case gcode::Remark::Kind::message:
      return fmt::format("{}:{}: {}\n", remark.place.file, remark.place.line, printable(remark.text));
    case gcode::Remark::Kind::print:
      return printable(remark.text) + '\n';
    default:
      return {};
  }
}

gcode::RemarkSink Messages::sink() {
  return [this](const gcode::Remark& remark) {
    const std::string text = text_of(remark);
    if (text.empty()) return;
    say_(text);
    ++count_;
    bytes_ += text.size();
    if (kept_.size() < most && bytes_ <= most_bytes) kept_.push_back(remark);
  };
}

}  // namespace leadscrew::results
