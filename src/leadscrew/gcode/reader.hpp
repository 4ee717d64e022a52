#pragma once
// From the text of a part program to moves (RS274/NGC, as NIST IR 6556 defines it and LinuxCNC extends it).

#include <cstdint>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace leadscrew::gcode {

/// Fills the buffer with the next bytes of the text and returns how many; 0 at the end of the text.
using ByteSource = std::function<base::Result<std::size_t>(std::span<char>)>;

/// A source over text that outlives it.
ByteSource text_source(std::string_view text);

/// Called once for each problem, in the order of the text.
using DiagnosticSink = std::function<void(const base::Diagnostic&)>;

struct ReaderOptions {
  std::string file;                  ///< name for diagnostics
  base::AxisVector start{};          ///< machine coordinates, mm or degrees, where the program begins
  bool block_delete = true;          ///< skip blocks that begin with '/'
  std::optional<PathMode> path_mode;  ///< overrides G61, G61.1 and G64
  std::optional<double> tolerance;    ///< mm; overrides P of G64; ≥ 0
};

/// Reads a part program block by block. Memory does not grow with the program. A block with a problem yields a diagnostic and
/// no move, and reading goes on, so that one pass reports every problem of a program; whoever moves a machine first reads the
/// whole program and moves only if it has no error. The machine and the tool table must outlive the reader.
class Reader {
 public:
  Reader(ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools, ReaderOptions options,
         DiagnosticSink sink);
  ~Reader();
  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;

  /// The next move; false at the program's end (M2, M30, the closing %, the end of the text, or a source that failed).
  bool next(Move& move);

  std::int64_t blocks() const;  ///< blocks read so far: lines that hold at least one word
  std::int64_t errors() const;  ///< diagnostics of severity error so far
  /// Set when the source failed; the diagnostic is the source's.
  const std::optional<base::Diagnostic>& source_failure() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace leadscrew::gcode
