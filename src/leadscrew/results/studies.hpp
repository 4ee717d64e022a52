#pragma once
// Published experiments made again, as a table and as JSON.

#include <leadscrew/results/style.hpp>
#include <leadscrew/study/row.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::results {

/// Rows under their headings, in columns. With a width (of a terminal, in characters), what does not fit goes on below.
std::string study_table(const study::Rows& rows, std::optional<int> width, const Style& style);
std::string study_json(std::string_view name, const study::Rows& rows);

/// Which studies there are.
std::string study_list(const Style& style);
std::string study_list_json();

}  // namespace leadscrew::results
