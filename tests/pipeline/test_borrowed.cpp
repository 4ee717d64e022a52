#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <type_traits>

using namespace leadscrew;

namespace test_borrowed {

// A reference to a temporary would dangle: it does not compile.
template <class... Arguments>
constexpr bool makes_program = std::is_constructible_v<pipeline::Program, gcode::ByteSource, Arguments...,
                                                       const gcode::ReaderOptions&, gcode::DiagnosticSink>;
static_assert(makes_program<const machine::Machine&, const machine::ToolTable&>);
static_assert(!makes_program<machine::Machine, const machine::ToolTable&>);
static_assert(!makes_program<const machine::Machine&, machine::ToolTable>);
static_assert(!std::is_constructible_v<planner::Planner, machine::Machine, geometry::Point>);
static_assert(!std::is_constructible_v<toolpath::Builder, machine::Machine>);

}  // namespace test_borrowed
