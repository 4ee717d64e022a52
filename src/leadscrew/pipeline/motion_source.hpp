#pragma once
// From text to motion: reader, tool path and planner joined, a chunk a call, in constant memory.

#include <functional>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <optional>

namespace leadscrew::pipeline {

/// A program that has an error must not be moved: read it whole first. The machine and the tool table must outlive
/// this.
class MotionSource {
 public:
  MotionSource(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
               gcode::ReaderOptions options, gcode::DiagnosticSink diagnostics)
      : reader_(std::move(source), machine, tools, options, std::move(diagnostics)), planner_(machine, options.start) {}

  /// Called with what passes on its way to the planner.
  std::function<void(const gcode::Move&)> on_move;
  std::function<void(const toolpath::Element&)> on_element;

  /// Reads and plans as far as the next chunk needs; none at the program's end, or while motion is held.
  std::optional<planner::Chunk> next();

  const gcode::Reader& reader() const { return reader_; }
  /// To change what is planned, between two chunks.
  planner::Planner& planner() { return planner_; }
  /// Has the whole program been read?
  bool has_read_all() const { return !reading_; }

 private:
  gcode::Reader reader_;
  toolpath::Builder builder_;
  planner::Planner planner_;
  bool reading_ = true;
};

}  // namespace leadscrew::pipeline
