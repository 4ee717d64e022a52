#pragma once
// Looking rows of a study up by what they say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/study/row.hpp>
#include <optional>
#include <string_view>

namespace leadscrew::study::testing {

/// The one row of this group with this text; an empty row, and a failed test, where there is none or another.
inline Row found(const Rows& rows, std::string_view group, std::string_view what) {
  const auto is_meant = [&](const Row& row) { return row.group == group && row.what == what; };
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(), is_meant), 1) << group << ": " << what;
  const auto row = std::find_if(rows.begin(), rows.end(), is_meant);
  return row == rows.end() ? Row{} : *row;
}

inline double ours(const Rows& rows, std::string_view group, std::string_view what) {
  const Row row = found(rows, group, what);
  EXPECT_TRUE(row.ours.has_value()) << group << ": " << what << ": " << row.why;
  return row.ours.value_or(NAN);
}

/// The value alone.
inline std::optional<double> published(const Row& row) {
  return row.published ? std::optional(row.published->value) : std::nullopt;
}

/// What is expected of these rows is of no paper.
inline void expect_none_published(const Rows& rows) {
  EXPECT_FALSE(rows.empty());
  for (const Row& row : rows) EXPECT_FALSE(row.published.has_value()) << row.group << ": " << row.what;
}

inline std::string_view verdict(const Rows& rows, std::string_view group, std::string_view what) {
  return name(found(rows, group, what).verdict);
}

}  // namespace leadscrew::study::testing
