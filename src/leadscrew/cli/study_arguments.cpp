#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/cli/study_arguments.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view study_examples =
    "Examples:\n"
    "  leadscrew study list                       what there is\n"
    "  leadscrew study butterfly\n"
    "  leadscrew study feed-fluctuation --json    rows of what, published, ours, unit, verdict and why\n"
    "  leadscrew study real-time-vs-offline --picture feeds.svg\n";

Parsed<void> check_picture(const StudyArguments& asked) {
  if (!asked.picture) return {};
  std::vector<std::string_view> drawn;
  for (const study::Study& study : study::studies()) {
    if (study.charts == nullptr) continue;
    if (study.name == asked.name) return {};
    drawn.push_back(study.name);
  }
  return wrong("--picture: there is none of {}; there is of {}", asked.name, fmt::join(drawn, ", "));
}

Parsed<void> check_name(std::string_view name) {
  std::vector<std::string_view> known = {"list"};
  for (const study::Study& study : study::studies()) known.push_back(study.name);
  if (std::ranges::find(known, name) != known.end()) return {};
  const std::string meant = base::did_you_mean(name, known);
  return wrong("no study \"{}\"{}", name,
               meant.empty() ? fmt::format("; there are {}", fmt::join(known, ", ")) : meant);
}

}  // namespace

void describe_study(Command& command, Arguments& arguments) {
  StudyArguments& study = arguments.study;
  command.word("NAME", "Which; list says what there is", study.name);
  command.text("--picture", "FILE", "Its quantities over time, where it has any, as an SVG", study.picture);
  add_output(command, arguments);
  command.check([&study] { return check_name(study.name).and_then([&] { return check_picture(study); }); });
  command.help(std::string(study_examples));
}

}  // namespace leadscrew::cli
