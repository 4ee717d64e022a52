#pragma once
// Random programs on random machines: what the promises of the whole are held against.

#include <cstdint>
#include <leadscrew/campaign/kinds.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <string>
#include <vector>

namespace leadscrew::campaign {

/// Of the feed, while motion goes on.
struct FeedChange {
  std::int64_t tick = 0;  ///< from this word on
  double factor = 1;      ///< of the programmed feed, 0 … 2; 0 holds
};

/// A program, and what it runs on.
struct Case {
  Kind kind = Kind::lines;
  machine::Machine machine;  ///< its period is the shortest that is meant: who runs it may take a longer one
  machine::ToolTable tools;
  std::string tools_text;           ///< the same as a file
  std::string text;                 ///< of the program; without errors
  std::vector<FeedChange> changes;  ///< of `interventions`; the last leads back to 1
};

/// How large a program is drawn.
enum class Size : std::uint8_t { small, large };

/// So many cases have all kinds in turn: of each that plans slowly fewer.
inline constexpr std::int64_t kinds_in_turn = 40;
Kind kind_of(std::int64_t number);

/// The case of this number, of kind_of(number); the same for the same seed, size and attempt ≥ 0, of which each draws another.
Case case_of(std::uint64_t seed, std::int64_t number, Size size, int attempt = 0);

/// A machine file of it, as leadscrew reads them.
std::string machine_text(const machine::Machine& machine);

}  // namespace leadscrew::campaign
