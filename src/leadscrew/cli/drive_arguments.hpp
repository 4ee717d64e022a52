#pragma once
// What the command line asks `leadscrew drive` for, beside what other commands are asked for too.

#include <leadscrew/cli/quantity.hpp>
#include <leadscrew/drive/setup.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::cli {

/// Options as text, before their values are looked at.
struct DriveTexts {
  std::optional<std::string> trace, axes, state, resume, sink, look_ahead, lead;
};

/// Says in whole sentences what is wrong.
Parsed<drive::Options> parse_drive(const DriveTexts& texts);

inline constexpr std::string_view drive_examples =
    "Examples:\n"
    "  leadscrew drive part.ngc --state part.state\n"
    "  leadscrew drive part.ngc --resume part.state     from where it was stopped or killed\n"
    "  leadscrew drive part.ngc --trace words.csv --axes axes.csv --json\n"
    "  leadscrew drive part.ngc --sink words.csv        words on time to a file or a pipe, and no drives\n"
    "\n"
    "Keys, on a terminal: space holds and resumes, + and - change the feed by 10 %, q stops. ^C brings motion to rest\n"
    "on the path; after a second one no more words are made. The drives are simulated by a process of their own: when\n"
    "words cease, they come to rest by themselves, on the path and within the limits of every axis. Without a "
    "terminal,\n"
    "and with --quiet, M0 and M1 do not pause. What was in the file of --sink is gone. A pipe that is full holds\n"
    "motion back, word by word; behind it, whoever moves must come to rest by itself when words cease.\n";

}  // namespace leadscrew::cli
