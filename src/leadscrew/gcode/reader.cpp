#include <algorithm>
#include <cstring>
#include <leadscrew/gcode/block_reader.hpp>
#include <leadscrew/gcode/interpreter.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <utility>

namespace leadscrew::gcode {

ByteSource text_source(std::string_view text) {
  return [text](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    const std::size_t count = std::min(buffer.size(), text.size());
    if (count > 0) std::memcpy(buffer.data(), text.data(), count);
    text.remove_prefix(count);
    return count;
  };
}

class Reader::Implementation {
 public:
  Implementation(ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
                 ReaderOptions options, DiagnosticSink sink)
      : options_(std::move(options)),
        lines_(std::move(source)),
        reporter_(options_.file, std::move(sink)),
        blocks_reader_(parameters_, frame_, reporter_, options_.dialect, options_.block_delete),
        interpreter_(Context{machine, tools, options_, parameters_, frame_, reporter_, modal_}) {}

  bool next(Move& move) {
    for (;;) {
      if (pending_ && interpreter_.next(move)) return true;
      pending_ = false;
      if (done_) return false;
      TextLine line;
      if (reporter_.full()) {
        done_ = true;
      } else if (!lines_.next(line)) {
        end_of_text();
      } else if (read(line, move)) {
        return true;
      }
    }
  }

  void reject(const Move& move, base::Diagnostic problem) {
    if (move.line == reporter_.line()) {
      reporter_.error(problem.code, block_.first_column, std::move(problem.message), std::move(problem.hint),
                      problem.subject);
    } else {
      reporter_.error_where_kept(problem.code, std::move(problem.message), std::move(problem.hint), problem.subject);
    }
  }

  void warn_of_feed(const Move& move, base::Diagnostic problem) {
    if (move.line == reporter_.line()) {
      const auto column = block_.has('F') ? block_.column_of('F') : block_.first_column;
      reporter_.warning(problem.code, column, std::move(problem.message), std::move(problem.hint));
    } else {
      reporter_.warning_where_kept(problem.code, std::move(problem.message), std::move(problem.hint));
    }
  }

  const Frame& frame() const { return frame_; }
  int system() const { return static_cast<int>(*parameters_.get(Parameters::current_system)); }
  std::int64_t blocks() const { return blocks_; }
  std::int64_t errors() const { return reporter_.errors(); }
  const std::optional<base::Diagnostic>& source_failure() const { return lines_.failure(); }

 private:
  enum class Delimiter : std::uint8_t { unknown, none, percent };  // whether the program stands between two %

  // Reads and executes a line; true if execute_plain() made a move of it. What else it made is pending.
  bool read(TextLine& line, Move& move) {
    reporter_.begin(line);
    if (line.too_long) {
      empty_ = false;
      return reporter_.error("line-too-long", static_cast<std::int64_t>(longest_line) + 1,
                             "this line is longer than " + std::to_string(longest_line) + " bytes",
                             "is this a part program?");
    }
    if (delimiter_ != Delimiter::none && !before_program(line)) return false;
    if (!block_is_read(line)) return false;
    const base::Line number{line.number};
    if (!reporter_.failed()) {
      const Interpreter::Plain plain = interpreter_.execute_plain(block_, number, move);
      if (plain != Interpreter::Plain::no) return plain == Interpreter::Plain::move;
    }
    interpreter_.execute(block_, number);
    pending_ = true;
    done_ = interpreter_.ended();
    return false;
  }

  bool block_is_read(const TextLine& line) {
    const bool any = blocks_reader_.read(line, block_);
    blocks_ += any;
    return any;
  }

  // Looks for the first line that is not blank, and for the line that ends a program between two %; false for lines
  // that are not part of the program.
  bool before_program(TextLine& line) {
    const char* p = line.begin;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (line.number == 1 && std::string_view(p, static_cast<std::size_t>(line.end - p)).starts_with(byte_order_mark)) {
      line.text = p += byte_order_mark.size();
    }
    skip_blanks(p);
    if (*p == '\n') return false;
    empty_ = false;
    if (*p == '%') {
      if (delimiter_ == Delimiter::percent) {
        interpreter_.end(base::Line{line.number});
        pending_ = done_ = true;
      }
      delimiter_ = Delimiter::percent;
      return false;
    }
    if (delimiter_ == Delimiter::unknown) delimiter_ = Delimiter::none;
    return true;
  }

  void end_of_text() {
    done_ = true;
    if (lines_.failure()) return;
    const base::Place place{reporter_.file(), std::max<std::int64_t>(lines_.lines(), 1), 1};
    if (empty_) {
      reporter_.report(base::Severity::error, "empty-program", place, "there is no program in this text",
                       "is this the right file?");
      return;
    }
    reporter_.report(base::Severity::note, "program-end", place, "the text ends without M2, M30 or %",
                     "end the program with M2");
    interpreter_.end(base::Line{lines_.lines()});
    pending_ = true;
  }

  ReaderOptions options_;
  LineSource lines_;
  Reporter reporter_;
  Parameters parameters_;
  Frame frame_;
  ModalState modal_;
  BlockReader blocks_reader_;
  Interpreter interpreter_;
  Block block_;
  std::int64_t blocks_ = 0;
  Delimiter delimiter_ = Delimiter::unknown;
  bool empty_ = true;     // nothing but blanks so far
  bool pending_ = false;  // the interpreter has moves of a block read before
  bool done_ = false;
};

Reader::Reader(ByteSource source, base::Borrowed<machine::Machine> machine, base::Borrowed<machine::ToolTable> tools,
               ReaderOptions options, DiagnosticSink sink)
    : implementation_(
          std::make_unique<Implementation>(std::move(source), *machine, *tools, std::move(options), std::move(sink))) {}
Reader::~Reader() = default;
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;

bool Reader::next(Move& move) {
  return implementation_->next(move);
}
void Reader::reject(const Move& move, base::Diagnostic problem) {
  implementation_->reject(move, std::move(problem));
}
void Reader::warn_of_feed(const Move& move, base::Diagnostic problem) {
  implementation_->warn_of_feed(move, std::move(problem));
}
const Frame& Reader::frame() const {
  return implementation_->frame();
}
int Reader::system() const {
  return implementation_->system();
}
std::int64_t Reader::blocks() const {
  return implementation_->blocks();
}
std::int64_t Reader::errors() const {
  return implementation_->errors();
}
const std::optional<base::Diagnostic>& Reader::source_failure() const {
  return implementation_->source_failure();
}

}  // namespace leadscrew::gcode
