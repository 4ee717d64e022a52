#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/base/digits.hpp>
#include <leadscrew/results/block_writer.hpp>

namespace leadscrew::results {

namespace {

void put(std::string& text, double value) {
  char digits[base::digits_room];
  text.append(digits, static_cast<std::size_t>(base::write_digits(digits, value) - digits));
}

void put_quoted(std::string& text, std::string_view block) {
  text += '"';
  for (const char c : block) text.append(c == '"' ? 2 : 1, c);
  text += '"';
}

}  // namespace

BlockWriter::BlockWriter(base::ByteSink sink, const files::InputFile& program, const machine::Machine& machine)
    : rows_(std::move(sink), 1024), program_(program) {
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) axes_.push_back(axis);
  }
  std::string& text = rows_.text();
  text = "line,text";
  for (const char* end : {",from ", ",to "}) {
    for (const base::Axis axis : axes_) text += end + std::string(1, base::letter(axis));
  }
  text += ",length,feed_asked,feed_reached,time,least_time,time_lost,cause,file,visit\n";
}

void BlockWriter::write(const pipeline::BlockTime& block) {
  if (!rows_.state()) return;
  std::string& text = rows_.text();
  text += std::to_string(base::number(block.line)) + ',';
  put_quoted(text, text_of(block.line));
  for (const base::AxisVector* end : {&block.from, &block.to}) {
    for (const base::Axis axis : axes_) text += ',', put(text, (*end)[base::index(axis)]);
  }
  text += ',', put(text, block.length);
  text += ',';
  if (std::isinf(block.feed_asked)) {
    text += "rapid";
  } else if (block.feed_asked > 0) {
    put(text, block.feed_asked);
  }
  for (const double figure : {block.feed_reached, block.seconds, block.least_seconds, block.lost()})
    text += ',', put(text, figure);
  text += ',';
  if (block.lost() > 0) text += pipeline::name(block.cause);
  text += ',';
  const files::InputFile* const file = program_.text_of(base::file(block.line));
  if (file != nullptr && file != &program_) put_quoted(text, file->name());
  text += ',' + std::to_string(base::visit(block.line)) + '\n';
  static_cast<void>(rows_.flush_if_full());
}

std::string BlockWriter::text_of(base::Line line) {
  const int file = base::file(line);
  auto text = texts_.find(file);
  if (text == texts_.end()) {
    const files::InputFile* const opened = program_.text_of(file);
    if (opened == nullptr) return {};
    text = texts_.emplace(file, opened->source()).first;
  }
  return text->second.line(base::number(line));
}

std::string PassedLines::line(std::int64_t number) {
  constexpr std::size_t most_kept = 10'000;
  while (line_ < number && read_line()) {
    ++line_;
    before_.push_back(text_);
    if (before_.size() > most_kept) before_.pop_front();
  }
  const std::int64_t back = line_ - number;
  if (back < 0 || back >= static_cast<std::int64_t>(before_.size())) return {};
  return before_[before_.size() - 1 - static_cast<std::size_t>(back)];
}

/// The next line into text_, without its end; false behind the last.
bool PassedLines::read_line() {
  std::size_t end = 0;
  while ((end = read_.find('\n', next_)) == std::string::npos && !has_ended_) {
    read_.erase(0, next_);
    next_ = 0;
    std::array<char, 65536> bytes;
    const auto count = source_(bytes);
    has_ended_ = !count || *count == 0;
    if (!has_ended_) read_.append(bytes.data(), *count);
  }
  end = std::min(end, read_.size());
  if (next_ >= end && next_ >= read_.size()) return false;
  text_ = read_.substr(next_, end - next_);
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  next_ = end + 1;
  return true;
}

}  // namespace leadscrew::results
