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
    "  leadscrew study feed-fluctuation --json    rows of what, published, source, expected, ours, …\n"
    "  leadscrew study real-time-vs-offline --picture feeds.svg\n"
    "  leadscrew study tube --words tube          then: leadscrew verify tube/square.csv tube/square.ngc\n";

/// That the study asked for is one of those with `part`, if the option is given.
template <class Part>
Parsed<void> check_part(std::string_view option, bool given, std::string_view name, Part study::Study::* part) {
  if (!given) return {};
  std::vector<std::string_view> known;
  for (const study::Study& study : study::studies()) {
    if (study.*part == nullptr) continue;
    if (study.name == name) return {};
    known.push_back(study.name);
  }
  return wrong("{}: there is none of {}; there is of {}", option, name, fmt::join(known, ", "));
}

Parsed<void> check_outputs(const StudyArguments& asked) {
  return check_part("--picture", asked.picture.has_value(), asked.name, &study::Study::picture).and_then([&] {
    return check_part("--words", asked.words.has_value(), asked.name, &study::Study::words);
  });
}

std::vector<std::string_view> study_names() {
  std::vector<std::string_view> names = {"list"};
  for (const study::Study& study : study::studies()) names.push_back(study.name);
  return names;
}

Parsed<void> check_name(std::string_view name) {
  const std::vector<std::string_view> known = study_names();
  if (std::ranges::find(known, name) != known.end()) return {};
  const std::string meant = base::did_you_mean(name, known);
  return wrong("no study \"{}\"{}", name,
               meant.empty() ? fmt::format("; there are {}", fmt::join(known, ", ")) : meant);
}

}  // namespace

void describe_study(Command& command, Arguments& arguments) {
  StudyArguments& study = arguments.study;
  const auto names = study_names();
  command.word("NAME", "Which; list says what there is", study.name, {.words = {names.begin(), names.end()}});
  command.output("--picture", "FILE.svg", "Its quantities over time, where it has any, as an SVG", study.picture,
                 {".svg"});
  command.folder("--words", "FOLDER", "Its programs and their words, where it has any, as files in a folder",
                 study.words);
  add_output(command, arguments);
  command.check([&study] { return check_name(study.name).and_then([&] { return check_outputs(study); }); });
  command.help(std::string(study_examples));
}

}  // namespace leadscrew::cli
