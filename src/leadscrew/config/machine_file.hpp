#pragma once
// Machine files: a machine::Machine from TOML, or everything that is wrong with the file, each problem with its place.
//
//   text ──text_limits──▶ TOML ──machine_keys──▶ machine::Machine ──machine::validate()──▶ problems
//                           └─── places of values, by base::Subject ──────────────────────────┘
//
// The keys are those of machine_keys.hpp. Outside [axis.…] each has a default; an axis gives its limits, and what it
// leaves out of its screw and its drive is as machine::ScrewErrors and machine::AxisDrive say.

#include <cstddef>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace leadscrew::config {

/// A machine that machine::validate() finds sound, or one problem or more in the order of the file.
using MachineOrProblems = tl::expected<machine::Machine, std::vector<base::Diagnostic>>;

/// Bytes of a machine file, so that a hostile one is parsed in well under a second: tables that are defined again and
/// again take the parser time that grows with the square of their number, at this size 0.3 s.
inline constexpr std::size_t largest_machine_file = 1 << 19;

/// Problems that are told of one file; then `too-many-problems` ends the list.
inline constexpr std::size_t most_machine_problems = 100;

/// `file` is for places; a machine without a name has the file's, less its ending. Codes: `input-too-large`;
/// `machine-nesting` (text_limits.hpp), `machine-syntax`, `machine-key` (not known), `machine-type`, `machine-missing`,
/// those of read_rotary_chain() and machine::validate(), `too-many-problems`.
MachineOrProblems read_machine(std::string_view text, const std::string& file);

/// The file at `path`. Codes: `io-open`, `io-read`, and those of read_machine().
MachineOrProblems load_machine(const std::string& path);

/// Of a machine file that is larger than it may be.
base::Diagnostic too_large(const std::string& file);

}  // namespace leadscrew::config
