#pragma once
// How a host's program is read: its text in pieces, between which somebody may end it.

#include <functional>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/host/motion.hpp>
#include <memory>
#include <string_view>

namespace leadscrew::host {

/// The diagnostic `interrupted`.
base::Diagnostic interruption();

/// The text in small pieces, `share` of it so far; before each it is asked whether to go on, where goes_on is not empty. The
/// text must outlive the source. Errors: `interrupted`.
gcode::ByteSource asking_source(std::string_view text, std::function<bool(double)> goes_on,
                                std::shared_ptr<double> share);

gcode::ReaderOptions reading_of(const machine::Machine& machine, const MotionOptions& options,
                                const std::shared_ptr<ProgramTexts>& texts);

}  // namespace leadscrew::host
