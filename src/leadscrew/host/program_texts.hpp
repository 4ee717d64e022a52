#pragma once
// The text of a part program and those of its subprograms, held in memory: each subprogram is asked for once, and every
// pass over the program reads the same. What one pass finds of surfaces is kept beside it for those that follow.

#include <cstdint>
#include <functional>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <map>
#include <memory>
#include <string>

namespace leadscrew::host {

/// The text of a subprogram that the program does not hold itself, by the name in `o<name> call`, in small letters, or
/// the number in `M98 P` and `o100 call`. Errors: `missing-sub` where there is none.
using SubprogramText = std::function<base::Result<std::string>(const std::string& name)>;

class ProgramTexts {
 public:
  /// `subprogram` may be empty: then there are none beside the program.
  ProgramTexts(std::string program, SubprogramText subprogram)
      : program_(std::move(program)), subprogram_(std::move(subprogram)) {}

  const std::string& program() const { return program_; }
  const std::shared_ptr<gcode::SurfaceDrafts>& surface_drafts() const { return surface_drafts_; }

  /// A text from a byte of it on, 0 … its length; an empty name is the program's own. This must outlive the source.
  /// Errors: `missing-sub`, others that `subprogram` returns.
  base::Result<base::OpenedText> open(const std::string& name, std::int64_t offset);

 private:
  base::Result<const std::string*> text_of(const std::string& name);

  std::string program_;
  SubprogramText subprogram_;
  std::map<std::string, std::string> subprograms_;  // by their names
  std::shared_ptr<gcode::SurfaceDrafts> surface_drafts_ = gcode::new_surface_drafts();
};

}  // namespace leadscrew::host
