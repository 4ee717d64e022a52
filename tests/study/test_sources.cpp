// Where every published figure stands: a list, for whoever holds the papers.

#include <gtest/gtest.h>

#include <iostream>
#include <leadscrew/study/studies.hpp>
#include <set>
#include <string>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_sources {

/// Of the studies with published figures; of the others, the test below and their own tests see that they have none.
const Rows& published_rows() {
  static const Rows rows = [] {
    Rows all;
    for (const auto& make :
         {table_1_rows, orders_rows, half_circle_rows, feed_code_rows, fpga_rows, lecture_rows, closed_loop_rows,
          real_time_rows, feed_fluctuation_rows, digital_integrals_rows, five_axes_rows}) {
      for (const Row& row : make({})) {
        if (row.published) all.push_back(row);
      }
    }
    return all;
  }();
  return rows;
}

TEST(PublishedFigures, AreOfOneOfThePapersAtAPlaceInIt) {
  std::set<Paper> papers;
  for (const Row& row : published_rows()) {
    const Source& source = row.published->source;
    const Citation citation = study::citation(source.paper);
    EXPECT_FALSE(citation.authors.empty() || citation.title.empty()) << row.what;
    EXPECT_FALSE(source.where.empty()) << row.what;
    papers.insert(source.paper);
    std::cout << decimal(row.published->value, row.scale.decimals) << ' ' << row.scale.unit << " | " << row.group
              << ": " << row.what << " | " << citation.authors << ", " << citation.title << ": " << source.where
              << '\n';
  }
  EXPECT_EQ(papers.size(), 5u);
}

/// So that none is added or lost unseen.
TEST(PublishedFigures, AreSoMany) {
  EXPECT_EQ(published_rows().size(), 103u);
}

/// Solved from the figure: an acceleration, a DDA's preload or order, the form of remainders.
TEST(PublishedFigures, ThatParametersWereSolvedFromAreFitted) {
  std::multiset<std::string> fitted;
  for (const Row& row : published_rows()) {
    if (row.verdict == Verdict::fitted) fitted.insert(decimal(row.published->value, row.scale.decimals));
  }
  EXPECT_EQ(fitted, (std::multiset<std::string>{"8", "8", "0.385", "0.385", "10.1", "10.4", "3.5", "10001"}));
}

/// Its curve, depths and limits are of no paper.
TEST(PublishedFigures, AreNoneOfAdaptiveControl) {
  expect_none_published(adaptive_rows({}));
}

}  // namespace test_sources
}  // namespace leadscrew::study::testing
