#pragma once
// The parts the report's page is made of; each appends itself to the page.

#include <leadscrew/report/report.hpp>
#include <string>
#include <string_view>

namespace leadscrew::report {

/// Everything a part may show.
struct PageContent {
  const Report& report;
  const Recording& recording;
  const machine::Machine& machine;
  base::Period period;
  FollowedRecording* followed = nullptr;  ///< slides, where there were any
};

/// Share of a limit or tolerance by which a value may exceed it and still keep it.
inline constexpr double keeps_up_to = 1.001;

/// "mm" or "°".
std::string_view unit(base::Axis axis);

/// The text of a line that a table of blocks names, where it is known.
std::string_view source_of(const Report& report, base::Line line);

/// Where a block stands in the program: "12", "sub.ngc:12, visit 3".
std::string place_text(const Report& report, base::Line line);

/// The verdict in a sentence for each promise that is broken; empty when all are kept.
std::vector<std::string> broken_promises(const PageContent& content);

void put_heading(std::string& page, const PageContent& content);       ///< title, verdict, key figures
void put_path_section(std::string& page, const PageContent& content);  ///< the path from all sides
/// Where tools are inside surfaces; nothing where that was not looked for.
void put_gouging_section(std::string& page, const PageContent& content);
/// Ideal, commanded and actual path, errors magnified; nothing without slides.
void put_followed_section(std::string& page, const PageContent& content);
/// What holds motion below its feed words, and the blocks that lose most; nothing where that was not asked.
void put_loss_section(std::string& page, const PageContent& content);
void put_time_section(std::string& page, const PageContent& content);       ///< feed and axes over time
void put_limit_section(std::string& page, const PageContent& content);      ///< table of ratios
void put_violation_section(std::string& page, const PageContent& content);  ///< nothing where there is none
void put_block_section(std::string& page, const PageContent& content);      ///< slowest, nearest to a limit
void put_event_section(std::string& page, const PageContent& content);      ///< what the program asked for on its way
void put_diagnostics(std::string& page, const PageContent& content);
void put_origin(std::string& page, const PageContent& content);  ///< how to make the page again

/// The files page.css and page.js, embedded. The page is complete without the script, which lights up the places of
/// blocks that lose time or gouge, and adds the shared cursor and zoom to the charts over time: with every zoom the bands and the time ticks are drawn anew from the bins, which are
/// finer than what the page shows at first.
extern const std::string_view page_css, page_js;

}  // namespace leadscrew::report
