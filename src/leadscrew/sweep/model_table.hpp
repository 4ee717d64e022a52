#pragma once
// What the model says of a sweep that was done.

#include <leadscrew/base/result.hpp>
#include <leadscrew/options/quantity.hpp>
#include <leadscrew/sweep/model.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::sweep {

/// "1,2,4@2,10000": ranks, and how many processors they share; each its own where that is not told.
options::Parsed<std::vector<ModelSetup>> parse_model_setups(std::string_view text);

/// A row for each of them, by the time of the processor that the tasks in the folder took, repeated in turn until there are
/// `tasks` (0: as they are); and from the first task to the last, as it was. Errors: those of shards; `sweep-tasks`.
base::Result<std::string> model_table(const std::string& folder, const std::vector<ModelSetup>& setups,
                                      std::int64_t tasks);

}  // namespace leadscrew::sweep
