#pragma once
// `leadscrew study`: the published experiments made again, as a table or as JSON.

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/status.hpp>
#include <leadscrew/study/row.hpp>
#include <optional>
#include <string>

namespace leadscrew::cli {

/// Makes the experiment that the arguments name, or lists all. `not_kept` where a limit was passed or an experiment
/// could not be made.
Status study(const Arguments& arguments, Console& console);

/// Rows under their headings, in columns. With a width (of a terminal, in characters), what does not fit goes on below.
std::string study_table(const study::Rows& rows, std::optional<int> width, const Style& style);

}  // namespace leadscrew::cli
