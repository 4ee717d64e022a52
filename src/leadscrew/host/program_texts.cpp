#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/host/program_texts.hpp>
#include <string_view>
#include <utility>

namespace leadscrew::host {

base::Result<const std::string*> ProgramTexts::text_of(const std::string& name) {
  if (name.empty()) return &program_;
  if (const auto known = subprograms_.find(name); known != subprograms_.end()) return &known->second;
  if (!subprogram_) {
    return base::failure(base::problem("missing-sub", "there is no subprogram " + name + " in the program",
                                       "give its text where the motion is made"));
  }
  base::Result<std::string> text = subprogram_(name);
  if (!text) return base::failure(text.error());
  return &subprograms_.emplace(name, std::move(*text)).first->second;
}

base::Result<base::OpenedText> ProgramTexts::open(const std::string& name, std::int64_t offset) {
  const base::Result<const std::string*> text = text_of(name);
  if (!text) return base::failure(text.error());
  return base::OpenedText{gcode::text_source(std::string_view(**text).substr(static_cast<std::size_t>(offset))), name};
}

}  // namespace leadscrew::host
