#pragma once
// Which block comes next: loops, conditions, subprograms and jumps (LinuxCNC manual, "O Codes" and "Fanuc-Style
// Programs"; Fanuc's "Custom Macro B").
//
//     lines ──▶ Flow ──▶ blocks            A statement is executed as it is met. What it leads to is looked for in the
//       ▲         │                        text the first time and remembered. Open loops and conditions are a stack,
//       └─ go to ─┘                        calls another; a jump is a place of the text that the lines go on from.
//
// Lines that are read in loops and subprograms are counted: ReaderOptions::fuel of them, and reading ends
// (fuel-exhausted). Lines looked through count as well, and 500 more where text has to be opened anew. Structure that
// cannot be followed ends reading too. At most 64 calls are under way, 9 in LinuxCNC's dialect, and at most 100 loops and
// conditions open.

#include <cstdint>
#include <leadscrew/gcode/block.hpp>
#include <leadscrew/gcode/parameters.hpp>
#include <leadscrew/gcode/part.hpp>
#include <leadscrew/gcode/predefined.hpp>
#include <leadscrew/gcode/program_text.hpp>
#include <leadscrew/gcode/statement.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace leadscrew::gcode {

class Flow {
 public:
  static constexpr std::size_t most_calls = 64;
  static constexpr std::size_t most_calls_of_linuxcnc = 9;
  static constexpr std::size_t most_modal_calls = 4;      ///< G66, one within another (Fanuc)
  static constexpr std::size_t most_open = 100;           ///< loops and conditions
  static constexpr std::size_t most_remembered = 65'536;  ///< places, of each kind

  /// What the reader does next.
  enum class Next : std::uint8_t {
    block,        ///< what stands from TextLine::text on is a block
    line,         ///< the next line
    stop,         ///< nothing more: an error has been reported
    program_end,  ///< the program ends here
  };

  /// All of it must outlive this.
  Flow(ProgramText& text, const Context& context, const Predefined& predefined);

  /// Whether take() must see the line; false of most blocks.
  bool may_take(const TextLine& line) const { return statements_.may_be(line); }
  /// Executes the line if it is a statement. The reporter has begun with it.
  [[gnu::noinline]] Next take(TextLine& line);
  /// Executes the M97, M98 or M99 of a block; `line` is the block's.
  [[gnu::noinline]] Next execute(const Block& block, const TextLine& line);
  /// Calls the subroutine `number` that a lathe cycle has for its contour; `at`: the column of the number.
  [[gnu::cold]] Next call_contour(double number, std::uint32_t at, const TextLine& line);
  /// Calls the blocks P to Q of the program that a lathe cycle has for its contour.
  [[gnu::cold]] Next call_profile(const Block& cycle, const TextLine& line);
  /// Calls the subprogram P that a pocket has for its contour: from the block of that number on, or a program.
  [[gnu::cold]] Next call_pocket(const Block& cycle, const TextLine& line);
  /// The number of the block that ends the contour.
  bool is_end_of_profile(const Block& block) const {
    return !calls_.empty() && calls_.back().kind == CallKind::profile && block.has('N') &&
           block['N'] == static_cast<double>(calls_.back().name);
  }
  /// Behind that block.
  [[gnu::cold]] Next end_profile();
  /// Behind a block that has moved, where ModalState::calls_macro: the macro of G66; `line` is the block's.
  [[gnu::noinline]] Next call_modal(const TextLine& line);
  /// G67, in that column.
  [[gnu::noinline]] Next end_modal_call(std::uint32_t column);
  /// The text has ended: what is still open is reported. `stop` where there is any.
  [[gnu::noinline]] Next end_of_text();

  /// Counts a line; false where there have been too many, which is then reported.
  bool count_line() { return !counts_ || fuel_-- > 0 || out_of_fuel(); }
  /// The text could not be read where control was to go.
  const std::optional<base::Diagnostic>& failure() const { return failure_; }

 private:
  enum class CallKind : std::uint8_t { o_word, program, macro, block_number, profile };

  struct Sub {
    TextPlace body;
    bool is_program = false;  // begins with a program number, ends with M99
    bool is_met = false;      // passed over, or called before
  };
  struct Call {
    CallKind kind = CallKind::o_word;
    StatementName name = 0;
    TextPlace return_to;
    TextPlace body;
    TextPlace program;      // where the program begins that its block numbers are of
    std::int64_t left = 1;  // how many times it is still to be executed, this one included
    std::size_t open = 0;   // loops and conditions outside it
    std::vector<double> arguments;
    bool is_modal = false;  // by G66
    bool goes_on = false;   // of a profile: behind it, and not behind the call
  };
  struct Open {
    Keyword keyword = Keyword::if_;  // if_, while_, do_, repeat, macro_do
    StatementName name = 0;
    TextPlace place;        // of the line that opens it
    TextPlace body;         // repeat: the line behind
    std::int64_t left = 0;  // repeat: passes, this one included
  };
  struct Label {
    TextPlace place;
    std::vector<TextPlace> loops;  // around it, outermost first
  };
  using Keywords = std::uint32_t;
  static constexpr Keywords bit(Keyword keyword) { return Keywords{1} << static_cast<unsigned>(keyword); }

  // flow.cpp: going and looking
  bool out_of_fuel();
  bool go(const TextPlace& place, bool is_visit);
  bool return_to_line(TextLine& line);
  template <class Look>
  bool scan(TextLine& line, Statement& statement, Look&& look);
  bool skip_to(TextLine& line, Keyword opener, StatementName name, Keywords wanted, Statement& found);
  Next error(const Statement& at, std::string_view code, std::string message, std::string hint);
  static void skip_remarks(const char*& p);
  bool at_end(const char* p);
  bool bracketed_value(const char*& p, double& value);
  bool condition(const char*& p, bool& holds);
  std::string shown(Keyword keyword, StatementName name) const;

  // flow_loops.cpp
  Next execute(const Statement& statement, TextLine& line);
  Next begin_if(const Statement& statement, TextLine& line);
  Next skip_branches(StatementName name, TextLine& line);
  Next leave_branch(const Statement& statement, TextLine& line);
  Next at_while(const Statement& statement, TextLine& line);
  Next end_of_do(const Statement& statement);
  Next begin_do(const Statement& statement, const TextLine& line);
  Next begin_repeat(const Statement& statement, TextLine& line);
  Next end_loop(const Statement& statement, Keyword opener);
  Next repeat_again();
  Next break_loop(const Statement& statement, TextLine& line, bool goes_on);
  bool open(const Statement& statement, Keyword keyword, const TextLine& line, std::int64_t left = 0);
  bool label_is_new(const Statement& statement, const TextLine& line);
  Open* innermost();
  Next unmatched(const Statement& statement);

  // flow_calls.cpp
  Next define(const Statement& statement, TextLine& line);
  Next call(const Statement& statement, TextLine& line);
  Next return_from(const Statement& statement);
  Next program_number(const Statement& statement);
  Next end_call(std::optional<StatementName> block_number, const Statement& at);
  Next begin_call(Call call, const Statement& at);
  Next call_program(const Block& block, const TextLine& line);
  Next return_program(const Block& block, const TextLine& line);
  const Sub* find_sub(StatementName name, bool is_program, TextLine& line);
  const Sub* known_sub(StatementName name) const;
  bool index_subs(int file, TextLine& line);
  bool add_sub(StatementName name, const Sub& sub, const Statement& at);
  bool meet_sub(const Statement& statement);
  const Sub* open_sub(StatementName name, bool is_program, TextLine& line);
  std::optional<std::int64_t> repeats(const Block& block);

  // flow_macros.cpp
  Next macro(const Statement& statement, TextLine& line);
  Next macro_if(const Statement& statement, TextLine& line);
  Next macro_while(const Statement& statement, TextLine& line);
  Next macro_end(const Statement& statement);
  Next macro_call(const Statement& statement, TextLine& line);
  bool macro_arguments(const Statement& statement, std::vector<double>& arguments, double& program, double& repeats);
  Next go_to_value(const char* p, TextLine& line, const Statement& at);
  Next go_to_block(std::int64_t number, TextLine& line, const Statement& at);
  bool pass_to_contour(const TextPlace& begin, TextLine& line, bool& goes_on);
  bool find_label(std::int64_t number, TextLine& line, const Statement& at, Label& label);
  bool scan_label(std::int64_t number, const TextPlace& from, Label& label, int& count);

  // flow_profiles.cpp: call_profile(), end_profile(), call_pocket()

  // flow_modal_calls.cpp
  Next begin_modal_call(Call call, const Statement& at);
  void activate_modal_calls(std::size_t count);
  Next modal_call_inside(const Statement& at);

  TextPlace program_begin() const { return calls_.empty() ? TextPlace{} : calls_.back().program; }
  std::size_t first_open() const { return calls_.empty() ? 0 : calls_.back().open; }

  ProgramText& text_;
  Parameters& parameters_;
  ModalState& modal_;
  Reporter& reporter_;
  const ReaderOptions& options_;
  ExpressionReader values_;
  StatementReader statements_;

  std::vector<Call> calls_;
  std::vector<Open> open_;
  std::vector<Call> modal_calls_;       // of G66; the one given last is called first
  std::size_t active_modal_calls_ = 0;  // what moves within the macro of one calls those before it
  bool counts_ = false;                 // control has gone back, or to a subprogram
  std::int64_t fuel_;
  std::int64_t visits_ = 0;
  std::optional<base::Diagnostic> failure_;

  // By a file and a place or a name in it.
  using Key = std::uint64_t;
  static Key key(int file, std::uint64_t of_file) { return static_cast<Key>(file) << 52 ^ of_file; }
  static Key key(const TextPlace& place) { return key(place.file, static_cast<std::uint64_t>(place.offset)); }
  std::unordered_map<Key, TextPlace> matches_;  // of a line that skips others: the one it leads to
  std::unordered_map<Key, Sub> subs_;
  std::unordered_map<StatementName, int> files_;  // of subprograms in files of their own
  std::vector<bool> indexed_;                     // files whose subprograms are known
  // By the beginning of the program or subroutine, and a name or number in it.
  using LabelKey = std::tuple<int, std::int64_t, std::uint64_t>;
  std::map<LabelKey, std::int64_t> label_lines_;  // LinuxCNC: a label stands for one line
  std::map<LabelKey, Label> labels_;
};

}  // namespace leadscrew::gcode
