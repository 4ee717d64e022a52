#include <bit>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/waves/value_changes.hpp>

namespace leadscrew::waves {
namespace {

using markup::put;

/// Short names of printable characters, ! … ~.
std::string identifier_of(std::size_t number) {
  constexpr std::size_t letters = 94;
  std::string identifier;
  for (;; number = number / letters - 1) {
    identifier += static_cast<char>('!' + number % letters);
    if (number < letters) return identifier;
  }
}

/// A reader fills up with zeros on the left, so a negative number has all its digits.
void put_digits(std::string& out, std::int64_t value, int width) {
  const auto bits = static_cast<std::uint64_t>(value);
  const int digits = value < 0 ? width : std::max(1, static_cast<int>(std::bit_width(bits)));
  for (int place = digits - 1; place >= 0; --place) out += ((bits >> place) & 1) != 0 ? '1' : '0';
}

}  // namespace

VcdWriter::VcdWriter(base::ByteSink sink, const std::string& timescale, const std::vector<std::string>& comments,
                     const std::vector<VcdScope>& scopes)
    : text_(std::move(sink)) {
  std::string& header = text_.text();
  for (const std::string& comment : comments) put(header, "$comment ", comment, " $end\n");
  put(header, "$version leadscrew $end\n$timescale ", timescale, " $end\n");
  for (const VcdScope& scope : scopes) {
    put(header, "$scope module ", scope.name, " $end\n");
    for (const VcdSignal& signal : scope.signals) {
      const std::string identifier = identifier_of(signals_.size());
      const std::string range = signal.width > 1 ? " [" + std::to_string(signal.width - 1) + ":0]" : "";
      const auto declare = [&](const std::string& name) {
        put(header, "$var wire ", std::to_string(signal.width), " ", identifier, " ", name, range, " $end\n");
      };
      declare(signal.name);
      for (const std::string& name : signal.also) declare(name);
      signals_.push_back({identifier, signal.width, 0});
    }
    header += "$upscope $end\n";
  }
  header += "$enddefinitions $end\n";
}

void VcdWriter::put_value(const Known& signal) {
  std::string& text = text_.text();
  if (signal.width > 1) text += 'b';
  put_digits(text, signal.value, signal.width);
  if (signal.width > 1) text += ' ';
  put(text, signal.identifier, "\n");
}

base::Result<void> VcdWriter::write(std::int64_t time, std::span<const std::int64_t> values) {
  if (!text_.state()) return text_.state();
  std::string& text = text_.text();
  const bool is_first = !has_begun_;
  bool is_stamped = is_first;
  if (is_first) put(text, "#", std::to_string(time), "\n$dumpvars\n");
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    if (!is_first && signals_[i].value == values[i]) continue;
    if (!is_stamped) put(text, "#", std::to_string(time), "\n");
    is_stamped = true;
    signals_[i].value = values[i];
    put_value(signals_[i]);
  }
  if (is_first) text += "$end\n";
  has_begun_ = true;
  return text_.flush_if_full();
}

base::Result<void> VcdWriter::finish(std::int64_t time) {
  put(text_.text(), "#", std::to_string(time), "\n");
  return text_.flush();
}

}  // namespace leadscrew::waves
