// What a function can reach, read from the machine code of a program: follows direct calls and jumps from function to
// function, prints what it finds, and fails where that leads out of the program to anything that is not on a short
// list, or nobody can say where.
//
//   reached PROGRAM MANGLED_NAME
//
// Needs objdump, x86-64 and an executable with its symbols. Nothing in the code tells the jump through a switch's table
// from a call through a pointer in the last place of a function, so neither may be there.

#include <cctype>
#include <cstdio>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

/// Pure functions of their arguments, and what ends the process where the stack has been overwritten.
const std::set<std::string> allowed = {"sin",  "cos",    "sincos",  "sqrt",   "hypot",  "floor",
                                       "ceil", "memcpy", "memmove", "memset", "memcmp", "__stack_chk_fail"};

struct Function {
  std::set<std::string> targets;      ///< of calls and jumps to other functions
  std::vector<std::string> indirect;  ///< calls and jumps to where a register or memory says; calls of the system
};

using Program = std::map<std::string, Function>;

/// "<name>:" of "0000000000001139 <name>:", empty if the line is none such.
std::string heading(const std::string& line) {
  const std::size_t open = line.find('<');
  if (line.empty() || std::isxdigit(static_cast<unsigned char>(line[0])) == 0) return {};
  if (open == std::string::npos || line.size() < 2 || line.compare(line.size() - 2, 2, ">:") != 0) return {};
  return line.substr(open + 1, line.size() - open - 3);
}

/// "jne" and "1139 <name+0x12>" of "    1150:\tjne    1139 <name+0x12>".
struct Instruction {
  std::string name, operands;
};

Instruction instruction(const std::string& line) {
  const std::size_t tab = line.find(":\t");
  if (tab == std::string::npos) return {};
  std::string text = line.substr(tab + 2);
  for (const char* prefix : {"bnd ", "notrack ", "rep ", "repz ", "lock "}) {
    if (text.rfind(prefix, 0) == 0) text = text.substr(std::string(prefix).size());
  }
  const std::size_t space = text.find(' ');
  if (space == std::string::npos) return {text, ""};
  return {text.substr(0, space), text.substr(text.find_first_not_of(' ', space))};
}

/// The function that an address operand lies in: "name" of "1139 <name+0x12>".
std::string target_of(const std::string& operands) {
  const std::size_t open = operands.find('<'), close = operands.rfind('>');
  if (open == std::string::npos || close == std::string::npos) return {};
  const std::string place = operands.substr(open + 1, close - open - 1);
  return place.substr(0, place.rfind("+0x"));
}

void read(const Instruction& found, const std::string& in, Function& function) {
  if (found.name == "syscall" || found.name == "int" || found.name == "sysenter") {
    function.indirect.push_back(found.name);
    return;
  }
  const bool is_transfer =
      found.name.rfind("call", 0) == 0 || found.name[0] == 'j' || found.name.rfind("xbegin", 0) == 0;
  if (!is_transfer) return;
  const std::string target = found.operands[0] == '*' ? "" : target_of(found.operands);
  if (target.empty()) {
    function.indirect.push_back(found.name + " " + found.operands);
  } else if (target != in) {
    function.targets.insert(target);
  }
}

Program disassemble(const std::string& program) {
  Program functions;
  std::FILE* const pipe = popen(("objdump -d --no-show-raw-insn '" + program + "'").c_str(), "r");
  if (!pipe) return functions;
  std::string line, name;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    if (const std::string next = heading(line); !next.empty()) {
      name = next;
      functions[name];
    } else if (const Instruction found = instruction(line); !found.name.empty()) {
      read(found, name, functions[name]);
    }
    line.clear();
  }
  pclose(pipe);
  return functions;
}

bool is_outside(const std::string& name) {
  return name.find("@plt") != std::string::npos;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const Program program = disassemble(arguments[1]);
  if (program.count(arguments[2]) == 0) {
    std::cout << arguments[1] << " holds no " << arguments[2] << '\n';
    return 2;
  }
  std::set<std::string> reached = {arguments[2]};
  std::vector<std::string> open = {arguments[2]};
  int faults = 0;
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (is_outside(name)) {
      const bool is_allowed = allowed.count(name.substr(0, name.find('@'))) > 0;
      std::cout << (is_allowed ? "library    " : "FORBIDDEN  ") << name << '\n';
      faults += is_allowed ? 0 : 1;
      continue;
    }
    std::cout << "function   " << name << '\n';
    const auto function = program.find(name);
    if (function == program.end()) {
      std::cout << "UNKNOWN    " << name << '\n';
      ++faults;
      continue;
    }
    for (const std::string& place : function->second.indirect) std::cout << "INDIRECT   " << place << '\n';
    faults += static_cast<int>(function->second.indirect.size());
    for (const std::string& target : function->second.targets) {
      if (reached.insert(target).second) open.push_back(target);
    }
  }
  std::cout << reached.size() << " symbols reached, " << faults << " faults\n";
  return faults == 0 ? 0 : 1;
}
