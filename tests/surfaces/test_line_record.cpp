// Lines of a draft, kept in bounded memory.

#include <gtest/gtest.h>

#include <leadscrew/surfaces/pass_lines.hpp>
#include <memory>
#include <vector>

#include "patches.hpp"

namespace leadscrew::surfaces {
namespace test_line_record {

/// A constant that holds so many bytes.
class Constant : public AcrossFunction {
 public:
  explicit Constant(std::size_t bytes) : bytes_(bytes) {}
  numeric::Jet<3> at(double) const override { return numeric::Jet<3>(0.5); }
  std::vector<double> breaks(double, double) const override { return {}; }
  std::size_t bytes() const override { return bytes_; }

 private:
  std::size_t bytes_;
};

/// So many passes of two parts each, which share a function; at the end the log may fail.
class Parts : public PassLines {
 public:
  Parts(std::size_t count, std::size_t bytes, bool fails = false) : left_(count), bytes_(bytes), fails_(fails) {}
  std::vector<Line> next(PassLog& log) override {
    if (left_ == 0) {
      if (fails_) log.fail(PassFailure::Kind::gouge, 0.25, 0.75);
      return {};
    }
    const double at = static_cast<double>(--left_);
    const auto function = std::make_shared<const Constant>(bytes_);
    return {{Direction::u, 0, 0.4, at, function}, {Direction::u, 0.6, 1, at, function}};
  }

 private:
  std::size_t left_, bytes_;
  bool fails_;
};

/// What is told of lines, from the first to none.
std::vector<std::vector<Line>> told(PassLines& lines, PassLog& log) {
  std::vector<std::vector<Line>> all;
  for (std::vector<Line> pass = lines.next(log); !pass.empty(); pass = lines.next(log)) all.push_back(pass);
  return all;
}

struct Recorded {
  std::shared_ptr<LineRecord> record = std::make_shared<LineRecord>();
  std::vector<std::vector<Line>> passes;
};
Recorded recorded(std::unique_ptr<PassLines> lines, const Machining* machining = nullptr) {
  Recorded result;
  PassLog log;
  log.machining = machining;
  const std::unique_ptr<PassLines> kept = recorded_lines(std::move(lines), result.record);
  result.passes = told(*kept, log);
  return result;
}

TEST(LineRecord, TellsTheSameAgain) {
  const Recorded once = recorded(std::make_unique<Parts>(7, 1000));
  ASSERT_TRUE(once.record->is_complete);
  EXPECT_EQ(once.passes.size(), 7u);
  for (int again = 0; again < 2; ++again) {
    PassLog log;
    const std::unique_ptr<PassLines> known = known_lines(once.record);
    const std::vector<std::vector<Line>> passes = told(*known, log);
    ASSERT_EQ(passes.size(), once.passes.size());
    for (std::size_t k = 0; k < passes.size(); ++k) {
      ASSERT_EQ(passes[k].size(), 2u);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(passes[k][i].from, once.passes[k][i].from);
        EXPECT_EQ(passes[k][i].to, once.passes[k][i].to);
        EXPECT_EQ(passes[k][i].across, once.passes[k][i].across);
        EXPECT_EQ(passes[k][i].function, once.passes[k][i].function);
      }
    }
  }
  PassLog failed;
  failed.fail(PassFailure::Kind::link, 0, 0);
  EXPECT_TRUE(known_lines(once.record)->next(failed).empty());
}

TEST(LineRecord, IsNotCompleteBeforeTheEndOrAfterAFailure) {
  const auto record = std::make_shared<LineRecord>();
  PassLog log;
  const std::unique_ptr<PassLines> lines = recorded_lines(std::make_unique<Parts>(2, 10), record);
  for (int k = 0; k < 2; ++k) {
    lines->next(log);
    EXPECT_FALSE(record->is_complete);
  }
  lines->next(log);
  EXPECT_TRUE(record->is_complete);
  EXPECT_FALSE(recorded(std::make_unique<Parts>(2, 10, true)).record->is_complete);
}

TEST(LineRecord, HoldsNoMoreThanItsBytes) {
  constexpr std::size_t of_function = 10'000, of_lines = sizeof(std::vector<Line>) + 2 * sizeof(Line),
                        fit = LineRecord::most_bytes / (of_function + of_lines);
  const Recorded all = recorded(std::make_unique<Parts>(fit, of_function)),
                 more = recorded(std::make_unique<Parts>(fit + 1, of_function));
  EXPECT_TRUE(all.record->is_complete);
  EXPECT_EQ(all.record->passes.size(), fit);
  EXPECT_FALSE(more.record->is_complete);
  EXPECT_TRUE(more.record->passes.empty());
  EXPECT_EQ(more.passes.size(), fit + 1);
  // Lines without a function.
  Machining machining = test::ball_on(test::plane());
  machining.scallop = 0;
  machining.is_draft = true;
  for (const bool fits : {true, false}) {
    machining.step = 30 * (fits ? 1.05 : 0.95) * (of_lines - sizeof(Line)) / LineRecord::most_bytes;
    PassLog log;
    log.machining = &machining;
    const Recorded kept = recorded(lines_of(log), &machining);
    EXPECT_EQ(kept.record->is_complete, fits);
    EXPECT_EQ(kept.record->passes.size(), fits ? kept.passes.size() : 0u);
  }
}

}  // namespace test_line_record
}  // namespace leadscrew::surfaces
