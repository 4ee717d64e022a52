#include <algorithm>
#include <cstring>
#include <leadscrew/gcode/block_reader.hpp>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/flow.hpp>
#include <leadscrew/gcode/foreign_language.hpp>
#include <leadscrew/gcode/interpreter.hpp>
#include <leadscrew/gcode/printer_commands.hpp>
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
        text_(std::move(source), options_.opener, options_.file),
        reporter_(options_.file, std::move(sink)),
        tools_(tools),
        context_{machine, tools_, options_, parameters_, frame_, reporter_, modal_},
        predefined_(context_),
        blocks_reader_(context_, predefined_),
        interpreter_(context_),
        flow_(text_, context_, predefined_),
        forms_(context_),
        printer_(reporter_),
        has_printer_commands_(has_form(options_.dialect, Form::printer_commands)) {
    predefined_.before_rotary([this] {
      if (!interpreter_.keeps_back()) return;
      interpreter_.settle();
      pending_ = true;
    });
  }

  bool next(Move& move) {
    for (;;) {
      if (pending_ && interpreter_.next(move)) return true;
      pending_ = false;
      if (held_) {
        if (execute_read(*std::exchange(held_, std::nullopt), move)) return true;
        continue;
      }
      if (done_) return finish();
      TextLine line;
      if (unread_) {
        if (read(*std::exchange(unread_, std::nullopt), move)) return true;
      } else if (reporter_.full()) {
        done_ = true;
      } else if (options_.is_dry && settles_in_drought()) {
        continue;
      } else if (!text_.next(line)) {
        end_of_text();
      } else if (read(line, move)) {
        return true;
      }
    }
  }

  void reject(const Move& move, base::Diagnostic problem) {
    if (const KeptPlace* const place = interpreter_.place_of(move.line)) {
      const AtKeptPlace there(reporter_, *place);
      reporter_.error(problem.code, place->column, std::move(problem.message), std::move(problem.hint),
                      problem.subject);
    } else if (move.line == reporter_.line()) {
      reporter_.error(problem.code, block_.first_column, std::move(problem.message), std::move(problem.hint),
                      problem.subject);
    } else {
      reporter_.error_where_kept(problem.code, std::move(problem.message), std::move(problem.hint), problem.subject);
    }
  }

  void warn_of_feed(const Move& move, base::Diagnostic problem) {
    warn_at(block_.has('F') ? block_.column_of('F') : block_.first_column, move, std::move(problem));
  }
  void warn(const Move& move, base::Diagnostic problem) { warn_at(block_.first_column, move, std::move(problem)); }
  void warn_at(std::uint32_t column, const Move& move, base::Diagnostic problem) {
    if (const KeptPlace* const place = interpreter_.place_of(move.line)) {
      const AtKeptPlace there(reporter_, *place);
      reporter_.warning(problem.code, place->column, std::move(problem.message), std::move(problem.hint));
    } else if (move.line == reporter_.line()) {
      reporter_.warning(problem.code, column, std::move(problem.message), std::move(problem.hint));
    } else {
      reporter_.warning_where_kept(problem.code, std::move(problem.message), std::move(problem.hint));
    }
  }

  void input_is(double value) { interpreter_.input_is(value); }
  void probed(const Probed& result) { interpreter_.probed(result); }

  const Frame& frame() const { return frame_; }
  int system() const { return modal_.system; }
  const ModalState& modal() const { return modal_; }
  const MachinedMove& machined() const { return interpreter_.machined(); }
  std::vector<std::shared_ptr<const surfaces::SurfaceForm>> surfaces() const { return interpreter_.surfaces(); }
  std::int64_t blocks() const { return blocks_; }
  std::int64_t errors() const { return reporter_.errors(); }
  const std::optional<base::Diagnostic>& source_failure() const {
    return flow_.failure() ? flow_.failure() : text_.failure();
  }
  const std::vector<std::string>& files() const { return text_.names(); }

 private:
  /// There are no more moves.
  bool finish() {
    if (interpreter_.ended() && reporter_.errors() == 0 && options_.parameters_at_end) {
      if (modal_.system <= Parameters::numbered_systems) parameters_.set(Parameters::current_system, modal_.system);
      std::exchange(options_.parameters_at_end, nullptr)(parameters_.persistent());
    }
    return false;
  }

  /// Lines that are kept back do not wait for whoever writes the next.
  [[gnu::cold]] bool settles_in_drought() {
    if (!interpreter_.keeps_back() || text_.has_line() || !options_.is_dry()) return false;
    interpreter_.settle();
    pending_ = true;
    return true;
  }

  enum class Delimiter : std::uint8_t { unknown, none, percent };  // whether the program stands between two %

  // Reads and executes a line; true if execute_plain() made a move of it. What else it made is pending.
  bool read(TextLine line, Move& move) {
    reporter_.begin(line);
    if (interpreter_.leaves_calls()) return leave_calls(line);
    if (line.too_long) {
      empty_ = false;
      return reporter_.error("line-too-long", static_cast<std::int64_t>(longest_line) + 1,
                             "this line is longer than " + std::to_string(longest_line) + " bytes",
                             "is this a part program?");
    }
    if ((delimiter_ != Delimiter::none || *line.begin == '%') && !is_of_program(line)) return false;
    if (!flow_.count_line()) {
      done_ = true;
      return false;
    }
    if (flow_.may_take(line) && !is_block(line)) return false;
    if (has_printer_commands_ && printer_.take(line)) return false;
    if (!block_is_read(line)) return false;
    if (interpreter_.waits(block_)) return hold(line);
    return execute_read(line, move);
  }

  // What a line says is read in the modes that come back before it.
  [[gnu::cold]] bool leave_calls(const TextLine& line) {
    if (interpreter_.leaving_waits() && !std::exchange(is_settled_, true)) {
      interpreter_.settle();
    } else {
      is_settled_ = false;
      interpreter_.leave_calls();
    }
    unread_ = line;
    pending_ = true;
    return false;
  }

  // A block that asks where rotary axes are waits until all lines before it have been handed out.
  [[gnu::cold]] bool hold(const TextLine& line) {
    interpreter_.settle();
    held_ = line;
    pending_ = true;
    return false;
  }

  bool execute_read(const TextLine& line, Move& move) {
    if (!reporter_.failed()) {
      const Interpreter::Plain plain = interpreter_.execute_plain(block_, line.id, move);
      if (plain != Interpreter::Plain::no) return plain == Interpreter::Plain::move;
      // Nothing but parameters that are set, as in loops that compute.
      if (((block_.words & ~letter_bit('N')) | block_.groups) == 0 && !modal_.in_profile) return false;
    }
    if (block_.has(Group::call)) return call(line);
    execute(line);
    if (const Block* const cycle = interpreter_.contour()) follow_contour(*cycle, line);
    if (modal_.calls_macro || block_.has(Group::modal_call)) call_modal(line);
    return false;
  }

  // The subprogram of a lathe cycle, or its blocks of the program, are the contour until they end.
  [[gnu::cold]] void follow_contour(const Block& cycle, const TextLine& line) {
    if (contour_calls_ == 0) {
      contour_calls_ = modal_.calls + 1;
      follow(cycle.is(Code::G150) ? flow_.call_pocket(cycle, line)
             : modal_.in_profile  ? flow_.call_profile(cycle, line)
                                  : flow_.call_contour(cycle['Q'], cycle.column_of('Q'), line),
             line.id);
    } else if (flow_.is_end_of_profile(block_)) {
      follow(flow_.end_profile(), line.id);
    }
  }

  // G67, and the macro of G66 behind a block that has moved.
  [[gnu::cold]] void call_modal(const TextLine& line) {
    if (reporter_.failed() || interpreter_.ended()) return;
    if (block_.has(Group::modal_call)) follow(flow_.end_modal_call(block_.column_of(Group::modal_call)), line.id);
    const bool has_place = block_.words & (axis_letter_bits | letter_bit('I') | letter_bit('J') | letter_bit('K'));
    if (!done_ && modal_.to_do != Code::none && has_place) follow(flow_.call_modal(line), line.id);
  }

  void execute(const TextLine& line) {
    forms_.rewrite(block_, line);
    if (block_.is(Code::G47)) note_remark(line);
    interpreter_.execute(block_, line.id);
    pending_ = true;
    done_ = done_ || interpreter_.ended();
  }

  // The first remark of a line, which has been read without error.
  [[gnu::cold]] void note_remark(const TextLine& line) {
    const char* const open = std::find(line.text, line.end, '(');
    const char* const close = std::find(open, line.end, ')');
    interpreter_.set_remark(open < close ? std::string_view(open + 1, static_cast<std::size_t>(close - open - 1))
                                         : std::string_view());
  }

  // Whether the line holds a block; if not, what it says of the flow is done.
  [[gnu::noinline]] bool is_block(TextLine& line) {
    const Flow::Next next = flow_.take(line);
    if (next == Flow::Next::block) return true;
    ++blocks_;
    follow(next, line.id);
    return false;
  }

  // M97, M98 or M99: what else stands in the block is executed before.
  [[gnu::noinline]] bool call(const TextLine& line) {
    const Block calling = block_;
    block_.groups &= ~bit(Group::call);
    block_.words &= ~row(calling.code(Group::call)).words.bits;
    execute(line);
    if (!reporter_.failed() && !interpreter_.ended()) follow(flow_.execute(calling, line), line.id);
    return false;
  }

  void follow(Flow::Next next, base::Line line) {
    if (modal_.calls < contour_calls_) {
      contour_calls_ = 0;
      interpreter_.end_contour();
      pending_ = true;
    }
    if (next == Flow::Next::program_end) interpreter_.end(line);
    pending_ = pending_ || next == Flow::Next::program_end;
    done_ = done_ || next == Flow::Next::stop || next == Flow::Next::program_end;
  }

  bool block_is_read(const TextLine& line) {
    const bool any = blocks_reader_.read(line, block_);
    blocks_ += any;
    return any;
  }

  bool is_of_program(TextLine& line) {
    if (base::file(line.id) != 0) return *line.begin != '%' || delimiter_of_file(line);
    return delimiter_ == Delimiter::none || before_program(line);
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
      if (p[1] == '_') reporter_.refuse_foreign();
      if (delimiter_ == Delimiter::percent) {
        if (flow_.end_of_text() == Flow::Next::program_end) interpreter_.end(line.id);
        pending_ = done_ = true;
      }
      delimiter_ = Delimiter::percent;
      return false;
    }
    if (delimiter_ == Delimiter::unknown) delimiter_ = Delimiter::none;
    return true;
  }

  // A subprogram's file may stand between two % as well.
  [[gnu::cold]] bool delimiter_of_file(const TextLine& line) {
    if (line.number > 1) end_of_text();
    return false;
  }

  void end_of_text() {
    done_ = true;
    if (source_failure()) return;
    const base::Place place{reporter_.file(), std::max<std::int64_t>(text_.lines(), 1), 1};
    if (empty_) {
      reporter_.report(base::Severity::error, "empty-program", place, "there is no program in this text",
                       "is this the right file?");
      return;
    }
    if (flow_.end_of_text() == Flow::Next::stop) return;
    const bool may_end = has_form(options_.dialect, Form::end_of_text);
    reporter_.report(may_end ? base::Severity::note : base::Severity::error, "program-end", place,
                     "the text ends without M2, M30 or %", "end the program with M2");
    interpreter_.end(base::line_at(text_.lines(), base::file(reporter_.line()), base::visit(reporter_.line())));
    pending_ = true;
  }

  ReaderOptions options_;
  ProgramText text_;
  Reporter reporter_;
  Parameters parameters_;
  Frame frame_;
  ModalState modal_;
  machine::ToolTable tools_;
  Context context_;
  Predefined predefined_;
  BlockReader blocks_reader_;
  Interpreter interpreter_;
  Flow flow_;
  DialectForms forms_;
  PrinterCommands printer_;
  bool has_printer_commands_;
  Block block_;
  std::int64_t blocks_ = 0;
  std::size_t contour_calls_ = 0;  // calls under way within the contour of a lathe cycle; 0 without one
  Delimiter delimiter_ = Delimiter::unknown;
  std::optional<TextLine> held_;    // read, and not yet executed
  bool is_settled_ = false;         // what is kept back has been, before modes come back
  std::optional<TextLine> unread_;  // taken from the text, and not yet read
  bool empty_ = true;               // nothing but blanks so far
  bool pending_ = false;            // the interpreter has moves of a block read before
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
void Reader::warn(const Move& move, base::Diagnostic problem) {
  implementation_->warn(move, std::move(problem));
}
void Reader::warn_of_feed(const Move& move, base::Diagnostic problem) {
  implementation_->warn_of_feed(move, std::move(problem));
}
void Reader::input_is(double value) {
  implementation_->input_is(value);
}
void Reader::probed(const Probed& result) {
  implementation_->probed(result);
}
const Frame& Reader::frame() const {
  return implementation_->frame();
}
int Reader::system() const {
  return implementation_->system();
}
const ModalState& Reader::modal() const {
  return implementation_->modal();
}
const MachinedMove& Reader::machined() const {
  return implementation_->machined();
}
std::vector<std::shared_ptr<const surfaces::SurfaceForm>> Reader::surfaces() const {
  return implementation_->surfaces();
}
std::int64_t Reader::blocks() const {
  return implementation_->blocks();
}
std::int64_t Reader::errors() const {
  return implementation_->errors();
}
const std::vector<std::string>& Reader::files() const {
  return implementation_->files();
}
const std::optional<base::Diagnostic>& Reader::source_failure() const {
  return implementation_->source_failure();
}

}  // namespace leadscrew::gcode
