// Random programs of loops, conditions and subprograms do what a direct execution of their structure does, however their
// text comes; random lines of statements end.

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_random_flow {

// One statement of a program: its text, and what it does to #100 and to X.
struct Node {
  enum class Kind { step, branch, loop, do_loop, repeat, leave, go_on, call } kind = Kind::step;
  int label = 0;
  int value = 0;  // what is added, compared with, how often
  std::vector<std::unique_ptr<Node>> body, otherwise;
};
using Nodes = std::vector<std::unique_ptr<Node>>;

class RandomProgram {
 public:
  explicit RandomProgram(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < subs_count; ++i) subs_.push_back(nodes(2, {}, i));
    main_ = nodes(3, {}, subs_count);
    write_subs_first_ = pick(2) == 0;
  }

  std::string text() {
    text_ = "#100=0\n";
    if (write_subs_first_) write_subs();
    write(main_);
    text_ += "m2\n";
    if (!write_subs_first_) write_subs();
    return text_;
  }

  std::vector<double> expected() {
    execute(main_);
    return xs_;
  }

 private:
  static constexpr int subs_count = 3;
  enum class Way { on, leave, go_on };

  int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }

  // callable: subprograms below this number, so that calls end.
  Nodes nodes(int depth, const std::vector<int>& loops, int callable) {
    Nodes made;
    for (int count = 1 + pick(4); count > 0; --count) made.push_back(node(depth, loops, callable));
    return made;
  }

  std::unique_ptr<Node> node(int depth, std::vector<int> loops, int callable) {
    auto made = std::make_unique<Node>();
    made->label = ++labels_;
    made->value = 1 + pick(5);
    const int choice = pick(depth > 0 ? 9 : 2);
    if (choice < 2 || (choice == 8 && callable == 0)) return made;
    if (choice == 8) {
      made->kind = Node::Kind::call;
      made->label = pick(callable);
      return made;
    }
    if (choice == 7 && !loops.empty()) {
      made->kind = pick(2) == 0 ? Node::Kind::leave : Node::Kind::go_on;
      made->label = loops[static_cast<std::size_t>(pick(static_cast<int>(loops.size())))];
      return made;
    }
    if (choice <= 3 || choice == 7) {
      made->kind = Node::Kind::branch;
      made->otherwise = nodes(depth - 1, loops, callable);
    } else {
      made->kind = choice == 4 ? Node::Kind::loop : choice == 5 ? Node::Kind::do_loop : Node::Kind::repeat;
      loops.push_back(made->label);
    }
    made->body = nodes(depth - 1, loops, callable);
    return made;
  }

  void write_subs() {
    for (int i = 0; i < subs_count; ++i) {
      const std::string name = "o<sub " + std::to_string(i) + "> ";
      text_ += name + "sub\n";
      write(subs_[static_cast<std::size_t>(i)]);
      text_ += name + "endsub\n";
    }
  }

  void write(const Nodes& nodes) {
    for (const auto& node : nodes) write(*node);
  }

  // A loop of its own counter: #(200 + label).
  void write(const Node& node) {
    const std::string o = "o" + std::to_string(node.label) + " ";
    const std::string value = std::to_string(node.value);
    const std::string counter = "#<_c" + std::to_string(node.label) + ">";
    switch (node.kind) {
      case Node::Kind::step:
        text_ += "#100=[[#100+" + value + "] mod 400]\ng0 x#100\n";
        break;
      case Node::Kind::branch:
        text_ += o + "if [#100 mod 7 lt " + value + "]\n";
        write(node.body);
        text_ += o + "else\n";
        write(node.otherwise);
        text_ += o + "endif\n";
        break;
      case Node::Kind::loop:
        text_ +=
            counter + "=0\n" + o + "while [" + counter + " lt " + value + "]\n" + counter + "=[" + counter + "+1]\n";
        write(node.body);
        text_ += o + "endwhile\n";
        break;
      case Node::Kind::do_loop:
        text_ += counter + "=0\n" + o + "do\n" + counter + "=[" + counter + "+1]\n";
        write(node.body);
        text_ += o + "while [" + counter + " lt " + value + "]\n";
        break;
      case Node::Kind::repeat:
        text_ += o + "repeat [" + value + "]\n";
        write(node.body);
        text_ += o + "endrepeat\n";
        break;
      case Node::Kind::leave:
        text_ += o + "break\n";
        break;
      case Node::Kind::go_on:
        text_ += o + "continue\n";
        break;
      case Node::Kind::call:
        text_ += "o<sub" + std::to_string(node.label) + "> call\n";
        break;
    }
  }

  Way execute(const Nodes& nodes) {
    for (const auto& node : nodes) {
      const Way way = execute(*node);
      if (way != Way::on) return way;
    }
    return Way::on;
  }

  Way execute(const Node& node) {
    switch (node.kind) {
      case Node::Kind::step: {
        const int before = x_;
        x_ = (x_ + node.value) % 400;
        if (x_ != before) xs_.push_back(x_);
        return Way::on;
      }
      case Node::Kind::branch:
        return execute(x_ % 7 < node.value ? node.body : node.otherwise);
      case Node::Kind::leave:
        target_ = node.label;
        return Way::leave;
      case Node::Kind::go_on:
        target_ = node.label;
        return Way::go_on;
      case Node::Kind::call:
        return execute(subs_[static_cast<std::size_t>(node.label)]);
      default:
        for (int i = 0; i < node.value; ++i) {
          const Way way = execute(node.body);
          if (way == Way::on) continue;
          if (target_ != node.label) return way;
          if (way == Way::leave) break;
        }
        return Way::on;
    }
  }

  std::mt19937_64 random_;
  int labels_ = 0;
  std::vector<Nodes> subs_;
  Nodes main_;
  bool write_subs_first_ = true;
  std::string text_;
  int x_ = 0, target_ = 0;
  std::vector<double> xs_;
};

std::vector<double> xs_of(const Reading& reading) {
  std::vector<double> xs;
  for (const Move& move : reading.lines()) xs.push_back(at(move.end, base::Axis::X));
  return xs;
}

// In pieces of a few bytes.
ByteSource in_pieces(std::string_view text, std::size_t most) {
  return [source = text_source(text), most](std::span<char> buffer) mutable {
    return source(buffer.first(std::min(buffer.size(), most)));
  };
}

TEST(RandomFlow, DoesWhatItsStructureSays) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    RandomProgram program(seed);
    const std::string text = program.text();
    const std::vector<double> expected = program.expected();
    const Reading reading = read(text);
    ASSERT_EQ(reading.problems(), "") << "seed " << seed << "\n" << text;
    ASSERT_EQ(xs_of(reading), expected) << "seed " << seed << "\n" << text;
    ASSERT_EQ(xs_of(read_source(in_pieces(text, 7), {})), expected) << "seed " << seed;
    Conditions opened;
    opened.options.opener = [&](const std::string&, std::int64_t offset) -> base::Result<base::OpenedText> {
      return base::OpenedText{text_source(std::string_view(text).substr(static_cast<std::size_t>(offset))), ""};
    };
    ASSERT_EQ(xs_of(read(text, opened)), expected) << "seed " << seed;
  }
}

TEST(RandomFlow, OfAnyLinesEnds) {
  const std::vector<std::string> lines = {"o1 if [#1 lt 3]",
                                          "o1 else",
                                          "o1 elseif [#1]",
                                          "o1 endif",
                                          "o2 while [#1 lt 9]",
                                          "o2 endwhile",
                                          "o3 do",
                                          "o3 while [#2]",
                                          "o4 repeat [3]",
                                          "o4 endrepeat",
                                          "o2 break",
                                          "o4 continue",
                                          "o5 sub",
                                          "o5 endsub [#1]",
                                          "o5 return",
                                          "o5 call [#1]",
                                          "o6 sub",
                                          "o6 endsub",
                                          "o6 call",
                                          "#1=[#1+1]",
                                          "#2=[#2 eq 0]",
                                          "g91 g0 x0.1",
                                          "g91 g0 x-0.1",
                                          "m98 p7 l2",
                                          "o7",
                                          "m99",
                                          "m2",
                                          "N5 g0 y0.1",
                                          "N6",
                                          "GOTO 5",
                                          "GOTO #1",
                                          "IF[#1 LT 5]GOTO6",
                                          "WHILE[#1 LT 5]DO1",
                                          "END1",
                                          "DO2",
                                          "END2",
                                          "G65 P7 A1",
                                          "M97 P5",
                                          "M99 P6",
                                          "%",
                                          "IF[#1 EQ 2]THEN#1=3",
                                          "(remark)"};
  std::mt19937_64 random(2026);
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (std::size_t count = 1 + random() % 40; count > 0; --count) text += lines[random() % lines.size()] + "\n";
    Conditions conditions;
    conditions.options.fuel = 5000;
    constexpr Dialect dialects[] = {Dialect::leadscrew, Dialect::linuxcnc, Dialect::fanuc, Dialect::haas};
    conditions.options.dialect = dialects[round % 4];
    conditions.options.repeats = round % 3 == 0;
    const Reading reading = read(text, conditions);
    ASSERT_LE(reading.moves.size(), 6000u) << text;
    ASSERT_FALSE(reading.moves.empty() && reading.diagnostics.empty()) << text;
    const Reading pieces = read_source(in_pieces(text, 5), conditions);
    ASSERT_EQ(pieces.problems(), reading.problems()) << text;
    ASSERT_EQ(pieces.moves.size(), reading.moves.size()) << text;
  }
}

}  // namespace test_random_flow
}  // namespace leadscrew::gcode
