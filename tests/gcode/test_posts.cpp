// Programs as CAM posts and controllers' manuals write them, each in the dialect that its name begins with: all are read.

#include <filesystem>
#include <fstream>
#include <leadscrew/gcode/dialect.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_posts {

namespace fs = std::filesystem;

std::set<fs::path> posts() {
  std::set<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(fs::path(LEADSCREW_SOURCE_DIR) / "tests/programs" / "posts"))
    paths.insert(entry.path());
  return paths;
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Those that need codes which are not read.
std::set<std::string> not_read() {
  std::set<std::string> names;
  std::ifstream list(fs::path(LEADSCREW_SOURCE_DIR) / "tests/programs" / "posts-not-read.txt");
  for (std::string name; list >> name;) names.insert(name);
  return names;
}

/// By the longest name of a dialect that the name begins with.
std::optional<Dialect> dialect_of_post(const std::string& name) {
  std::optional<Dialect> found;
  for (std::size_t i = 0; i < index(Dialect::count); ++i) {
    const auto dialect = static_cast<Dialect>(i);
    const bool is_longer = !found || gcode::name(dialect).size() > gcode::name(*found).size();
    if (is_longer && name.starts_with(std::string(gcode::name(dialect)) + "-")) found = dialect;
  }
  return found;
}

/// Axes X Y Z A B C, without U V W: as machines have them that these programs are for.
machine::Machine six_axes() {
  machine::Machine machine = nine_axes();
  for (const base::Axis axis : {base::Axis::U, base::Axis::V, base::Axis::W}) machine.axes[base::index(axis)].reset();
  return machine;
}

TEST(Posts, AreManyOfAllDialects) {
  std::set<std::optional<Dialect>> dialects;
  for (const fs::path& path : posts()) dialects.insert(dialect_of_post(path.filename().string()));
  EXPECT_GE(posts().size(), 60u);
  EXPECT_EQ(dialects.size(), index(Dialect::count));
}

TEST(Posts, AreRead) {
  for (const fs::path& path : posts()) {
    const std::string name = path.filename().string();
    const auto dialect = dialect_of_post(name);
    ASSERT_TRUE(dialect) << name;
    Conditions conditions;
    conditions.machine = six_axes();
    conditions.options.file = name;
    conditions.options.dialect = *dialect;
    const Reading reading = read(text_of(path), conditions);
    if (not_read().contains(name)) {
      EXPECT_GT(reading.errors, 0) << name << " is read: take it off the list";
      continue;
    }
    for (const base::Diagnostic& problem : reading.diagnostics) {
      if (problem.severity != base::Severity::error) continue;
      ADD_FAILURE() << name << ":" << problem.place.line << ": " << problem.message << " [" << problem.code << "]\n    "
                    << problem.source;
    }
    EXPECT_GT(reading.moves.size(), 1u) << name;
  }
}

}  // namespace test_posts
}  // namespace leadscrew::gcode
