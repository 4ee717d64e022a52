// The calls of leadscrew.h that look at a program and do not move it, and what options ask of all of them.

#include <algorithm>
#include <leadscrew/config/tool_file.hpp>
#include <leadscrew/host/program_check.hpp>
#include <leadscrew/language/explanation.hpp>
#include <string>
#include <utility>

#include "handles.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

namespace {

int read_tools(const leadscrew_options& given, machine::ToolTable& tools, leadscrew_error* error) {
  const auto take = [&](machine::ToolTable read) { tools = std::move(read); };
  if (given.tools != nullptr) return with_read(config::read_tools({given.tools, given.tools_length}, {}), error, take);
  if (given.tools_file != nullptr) return with_read(config::load_tools(given.tools_file), error, take);
  return LEADSCREW_OK;
}

leadscrew_checked checked_of(const host::CheckedProgram& from) {
  leadscrew_checked checked{};
  checked.size = sizeof checked;
  checked.blocks = from.blocks;
  checked.moves = from.moves;
  checked.bound = from.bound_s;
  std::copy(from.least.begin(), from.least.end(), checked.least);
  std::copy(from.greatest.begin(), from.greatest.end(), checked.greatest);
  return checked;
}

}  // namespace

int leadscrew::capi::read_options(const leadscrew_options* given, const machine::Machine& machine,
                                  leadscrew_options& asked, host::MotionOptions& options, leadscrew_error* error) {
  leadscrew_options none{};
  none.size = sizeof none;
  const auto understood = known(given == nullptr ? &none : given);
  if (!understood)
    return misuse(error, "the size of the options is none that a version had, or they ask for what is not known");
  asked = *understood;
  if (asked.tools != nullptr && (asked.tools_file != nullptr || !is_text(asked.tools, asked.tools_length)))
    return misuse(error, "tools are given twice, or the length of their text is none that memory holds");
  auto made = options_of(asked, machine);
  if (!made) return rejected(error, made.error());
  options = std::move(*made);
  return read_tools(asked, options.tools, error);
}

int leadscrew_program_check(const leadscrew_machine* machine, const char* text, size_t length,
                            const leadscrew_options* options, leadscrew_checked* checked, leadscrew_error* error) {
  if (machine == nullptr || !is_text(text, length))
    return misuse(error, "the machine or the text is NULL, or its length is none that memory holds");
  if (checked != nullptr && !fill(checked, checked_of({})))
    return misuse(error, "the size of what is checked is none that a version had");
  return guarded(error, [&] {
    leadscrew_options asked{};
    host::MotionOptions reading;
    if (const int code = read_options(options, machine->machine, asked, reading, error); code != LEADSCREW_OK)
      return code;
    const auto found = host::check_program(machine->machine, std::string(text, length), reading, sink_of(asked));
    if (!found) return rejected(error, found.error());
    fill(checked, checked_of(*found));
    return found->error ? rejected(error, *found->error) : static_cast<int>(LEADSCREW_OK);
  });
}

size_t leadscrew_explain(const leadscrew_machine* machine, const char* block, char* text, size_t length) {
  if (machine == nullptr || block == nullptr) return 0;
  const auto found = language::explanation(block, machine->machine.dialect);
  if (!found) return 0;
  if (text != nullptr && length > 0) text[found->copy(text, length - 1)] = '\0';
  return found->size();
}
