#pragma once
// What a drive has come to, as text and as JSON.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/drive/figures.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/style.hpp>
#include <string>

namespace leadscrew::results {

Json json_of_drive(const std::string& program, const machine::Machine& machine, const drive::Figures& figures,
                   const Diagnostics& diagnostics);
std::string drive_summary(const std::string& program, const machine::Machine& machine, const drive::Figures& figures,
                          const Style& style);

}  // namespace leadscrew::results
