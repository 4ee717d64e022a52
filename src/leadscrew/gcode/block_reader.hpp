#pragma once
// From a line of text to a block: words, comments, parameter settings, modal groups (NIST IR 6556, 3.3 and 3.4).

#include <leadscrew/gcode/block.hpp>
#include <leadscrew/gcode/expression.hpp>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/remarks.hpp>
#include <vector>

namespace leadscrew::gcode {

class BlockReader {
 public:
  BlockReader(const Context& context, const Predefined& predefined)
      : parameters_(context.parameters),
        reporter_(context.reporter),
        values_(context.parameters, predefined, context.reporter, context.options),
        remarks_(context, predefined),
        dialect_(context.options.dialect),
        block_delete_(context.options.block_delete) {}

  /// Reads the line and then sets its parameters; false where it holds no word. Problems are reported; the words before
  /// them are in the block.
  bool read(const TextLine& line, Block& block);

 private:
  struct Assignment {
    ExpressionReader::ParameterName name;
    double value = 0;
    std::int64_t column = 0;
  };

  bool word(const char*& p, unsigned letter, Block& block);
  /// Whether the dialect has polar words, and `$`, which spindle it is (LinuxCNC).
  bool has_marked_words() const;
  [[gnu::cold]] bool begins_spindle_number(const char* p) const;
  [[gnu::cold]] bool marked_word(const char*& p, Block& block);
  bool g_word(double value, std::uint32_t column, Block& block);
  bool code_word(char letter, Code code, double value, std::uint32_t column, Block& block);
  bool m_word(double value, std::uint32_t column, Block& block);
  // What is wrong with a word, told apart from reading it: most blocks have nothing of the kind.
  [[gnu::cold]] bool refuse_o_word(const char* begin, Block& block);
  [[gnu::cold]] bool refuse_value(unsigned letter, double value, std::uint32_t column);
  [[gnu::cold]] bool refuse_repeated(unsigned letter, std::uint32_t column);
  [[gnu::cold]] bool refuse_unknown(char letter, double value, std::uint32_t column);
  [[gnu::cold]] static void set_side(Block& block);
  [[gnu::cold]] bool refuse_code(Code code, std::uint32_t column, Block& block);
  /// What begins with neither a letter nor a remark: forms that some dialects have (text_forms.cpp).
  [[gnu::cold]] bool other(const char*& p, const TextLine& line);
  bool program_name(const char*& p);
  bool checksum(const char*& p, const TextLine& line);
  bool controller_command(const char*& p);
  bool assignment(const char*& p);
  /// Whether the parameter may be set to this value; reports why not. `rest`: of the line, behind the value.
  bool can_assign(const Assignment& assignment, const char* rest);
  [[gnu::cold]] bool can_assign_macro(const Assignment& assignment, const char* rest);
  [[gnu::cold]] bool refuse_assignment(const Assignment& assignment);
  void set_number(int number, double value);
  bool comment(const char*& p);
  [[gnu::cold]] bool nested_comment(const char* open, const char*& p);
  void note_remark(const char* begin, const char* end);
  void assign(Block& block);
  [[gnu::cold]] void set_of_system(const Assignment& assignment, Block& block);

  Parameters& parameters_;
  Reporter& reporter_;
  ExpressionReader values_;
  Remarks remarks_;
  std::vector<Assignment> assignments_;
  std::string message_;      // of #3006
  std::string_view remark_;  // of the line, that asks for something; null for none
  Dialect dialect_;
  bool block_delete_;
};

}  // namespace leadscrew::gcode
