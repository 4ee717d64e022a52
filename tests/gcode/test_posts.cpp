// Programs as CAM posts and controllers' manuals write them, each in the dialect that its name begins with: all are read.

#include <filesystem>
#include <fstream>
#include <leadscrew/gcode/dialect.hpp>
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

/// Axes X Y Z A B C, without U V W: as machines have them that these programs are for.
machine::Machine six_axes() {
  machine::Machine machine = nine_axes();
  for (const base::Axis axis : {base::Axis::U, base::Axis::V, base::Axis::W}) machine.axes[base::index(axis)].reset();
  return machine;
}

TEST(Posts, AreManyOfAllDialects) {
  std::set<std::string> dialects;
  for (const fs::path& path : posts()) {
    const std::string name = path.filename().string();
    dialects.insert(name.substr(0, name.find('-')));
  }
  EXPECT_GE(posts().size(), 60u);
  EXPECT_EQ(dialects.size(), index(Dialect::count));
}

TEST(Posts, AreRead) {
  for (const fs::path& path : posts()) {
    const std::string name = path.filename().string();
    const auto dialect = dialect_of(name.substr(0, name.find('-')));
    ASSERT_TRUE(dialect) << name;
    Conditions conditions;
    conditions.machine = six_axes();
    conditions.options.file = name;
    conditions.options.dialect = *dialect;
    const Reading reading = read(text_of(path), conditions);
    for (const base::Diagnostic& problem : reading.diagnostics) {
      if (problem.severity != base::Severity::error) continue;
      ADD_FAILURE() << name << ":" << problem.place.line << ": " << problem.message << " [" << problem.code << "]\n    "
                    << problem.source;
    }
    EXPECT_GT(reading.moves.size(), 1u) << name;
  }
}

TEST(Posts, ThatProbeGoOnFromWhereTheProbeTouches) {
  const struct {
    std::string name;
    double z;  ///< where they end, mm, machine coordinates
  } rows[] = {{"grbl-tool-setter.nc", -7 - 19.3 - 0.5},
              {"linuxcnc-tool-length-probe.nc", 20 + (-7 - 12.5)},
              {"mach3-probe-plate.nc", -7 + 30 - 19.05},
              {"haas-probe-z.nc", 0}};
  for (const auto& [name, z] : rows) {
    Conditions conditions = in_dialect(*dialect_of(name.substr(0, name.find('-'))));
    conditions.machine = six_axes();
    conditions.machine.probe.emplace().planes[base::index(base::Axis::Z)] = -7;
    const Reading reading = read(text_of(fs::path(LEADSCREW_SOURCE_DIR) / "tests/programs/posts" / name), conditions);
    EXPECT_EQ(reading.errors, 0) << name << ": " << reading.problems();
    EXPECT_NEAR(at(reading.lines().back().end, base::Axis::Z), z, 1e-9) << name;
  }
}

}  // namespace test_posts
}  // namespace leadscrew::gcode
