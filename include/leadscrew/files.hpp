#pragma once
/// \file
/// Machines and tool tables from files. With leadscrew::config.

#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/config/tool_file.hpp>
