#pragma once
// The report of a run as the workbench's page of a program, with the recording inside: where the page is installed, or built.

#include <leadscrew/base/event.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/results/page_recording.hpp>
#include <leadscrew/results/report_form.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::results {

inline constexpr std::string_view recording_schema = "leadscrew.recording/1";

/// Bytes of a program, a machine file or a tool table that the page takes along.
inline constexpr std::int64_t most_page_text = 4 << 20;

/// What the page is told beside words and moves. All text is UTF-8, or what is none of it is replaced.
struct PageParts {
  std::string program;                     ///< its name
  std::string text;                        ///< of it, without its subprograms
  std::string machine;                     ///< text of the machine file; empty: the built-in mill
  std::string tools;                       ///< text of the tool table; may be empty
  MotionAsked asked{};                     ///< in place of what they say
  std::string command;                     ///< the command line that makes the report again
  json::Json events;                       ///< the first of them, as json_of_events() has them
  std::int64_t event_count = 0;            ///< of all
  json::Json result;                       ///< as schema leadscrew.run/1 has it
  std::optional<json::Json> gouging = {};  ///< "gouging" of schema leadscrew.check/1; none where it was not looked for
};

/// "events" of schema leadscrew.recording/1.
json::Json json_of_events(std::span<const base::PassedEvent> events, base::Period period);

/// "asked" of schema leadscrew.recording/1.
json::Json json_of_asked(const MotionAsked& asked);

/// Schema leadscrew.recording/1.
json::Json json_of_recording(const PageParts& parts, const PageRecording& recording);

/// The page's text; none where it is neither beside the command as `cmake --install` puts it there, nor in the build tree.
std::optional<std::string> workbench_page();

/// With the recording in its place; none where the page has no such place.
std::optional<std::string> with_recording(std::string page, const json::Json& recording);

}  // namespace leadscrew::results
