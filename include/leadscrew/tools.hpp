#pragma once
/// \file
/// Tool tables, and their text in LinuxCNC's format.

#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/machine/tool_table.hpp>
