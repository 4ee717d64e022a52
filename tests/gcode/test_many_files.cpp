// Subprograms in more files than a line can tell apart.

#include <leadscrew/base/line.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_many_files {

TEST(Files, OfSubprogramsAreBounded) {
  Conditions conditions;
  conditions.options.opener = [](const std::string& name, std::int64_t) -> base::Result<base::OpenedText> {
    // Each file is a subprogram of its own name, which does nothing.
    auto text = std::make_shared<std::string>("o<" + name + "> sub\no<" + name + "> endsub\n");
    return base::OpenedText{
        [text, source = text_source(*text)](std::span<char> buffer) mutable { return source(buffer); }, name + ".ngc"};
  };
  std::string program;
  for (int i = 1; i <= 4100; ++i) program += "o<f" + std::to_string(i) + "> call\n";
  const std::string beginning = program;
  conditions.options.opener = [of_files = conditions.options.opener, &beginning](
                                  const std::string& name, std::int64_t offset) -> base::Result<base::OpenedText> {
    if (!name.empty()) return of_files(name, offset);
    return base::OpenedText{text_source(std::string_view(beginning).substr(static_cast<std::size_t>(offset))),
                            "main.ngc"};
  };
  const Reading reading = read(program, conditions);
  ASSERT_EQ(reading.errors, 1);
  EXPECT_EQ(reading.diagnostics.at(0).code, "too-many-files");
  EXPECT_EQ(reading.diagnostics.at(0).place.line, base::last_file + 1);
}

}  // namespace test_many_files
}  // namespace leadscrew::gcode
