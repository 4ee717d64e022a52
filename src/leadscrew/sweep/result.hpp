#pragma once
// What a task found, as JSON: the same for whoever finds it.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/judged_run.hpp>
#include <vector>

namespace leadscrew::sweep {

/// The figures by which promises are judged: worst ratios of limits, deviation and end in mm; and words, with a hash.
std::vector<json::Json::Member> judged_figures(const JudgedRun& run);
/// Of a program that was run: "kept", or "not-kept" where a limit or tolerance was not.
json::Json json_of(const JudgedRun& run);
/// Of one that was not: "unreadable" where the file cannot be read, else "rejected"; with its first error and how many it has.
json::Json json_of(const base::Diagnostic& first_error, std::int64_t errors);

}  // namespace leadscrew::sweep
