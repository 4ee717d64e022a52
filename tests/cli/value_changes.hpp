#pragma once
// Reads value-change dumps (IEEE 1364-2005, clause 18) by their grammar, as far as `leadscrew` writes them.

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace leadscrew::cli::testing {

struct Dump {
  struct Signal {
    int width = 0;
    std::map<std::int64_t, std::int64_t> changes;  ///< by time

    /// As a viewer shows it at this time.
    std::int64_t at(std::int64_t time) const {
      const auto after = changes.upper_bound(time);
      EXPECT_NE(after, changes.begin()) << "no value yet";
      return after == changes.begin() ? 0 : std::prev(after)->second;
    }
  };

  std::string timescale;
  std::vector<std::string> comments;
  std::map<std::string, Signal> signals;  ///< by scope.name
  std::int64_t first = -1, last = -1;     ///< times
  bool has_initial_values = false;
};

/// Filled up with zeros on the left, then taken as two's complement.
inline std::int64_t signed_value(const std::string& digits, int width) {
  EXPECT_LE(digits.size(), static_cast<std::size_t>(width));
  std::int64_t value = 0;
  for (const char digit : digits) value = 2 * value + (digit - '0');
  const bool is_negative = digits.size() == static_cast<std::size_t>(width) && digits.front() == '1';
  return is_negative ? value - (std::int64_t{1} << width) : value;
}

inline Dump read_dump(const std::string& text) {
  Dump dump;
  std::map<std::string, std::vector<std::string>> names;  // by identifier: a signal may have several
  std::vector<std::string> scopes;
  std::istringstream words(text);
  std::string word;
  const auto skip_to_end = [&] {
    std::string all;
    while (words >> word && word != "$end") all += (all.empty() ? "" : " ") + word;
    return all;
  };
  const auto change = [&](const std::string& identifier, const std::string& digits) {
    ASSERT_TRUE(names.contains(identifier)) << identifier;
    for (const std::string& name : names[identifier]) {
      Dump::Signal& signal = dump.signals[name];
      signal.changes[dump.last] = signed_value(digits, signal.width);
    }
  };
  while (words >> word) {
    if (word == "$timescale") {
      dump.timescale = skip_to_end();
    } else if (word == "$comment") {
      dump.comments.push_back(skip_to_end());
    } else if (word == "$scope") {
      words >> word;
      EXPECT_EQ(word, "module");
      words >> word;
      scopes.push_back(word);
      skip_to_end();
    } else if (word == "$upscope") {
      scopes.pop_back();
      skip_to_end();
    } else if (word == "$var") {
      std::string type, identifier, name;
      int width = 0;
      words >> type >> width >> identifier >> name;
      const std::string full = scopes.back() + "." + name;
      EXPECT_FALSE(dump.signals.contains(full)) << full << " twice";
      for (const std::string& other : names[identifier]) EXPECT_EQ(dump.signals[other].width, width) << other << full;
      names[identifier].push_back(full);
      dump.signals[full].width = width;
      const std::string range = skip_to_end();
      EXPECT_EQ(range, width > 1 ? "[" + std::to_string(width - 1) + ":0]" : "");
    } else if (word == "$dumpvars") {
      dump.has_initial_values = true;
    } else if (word == "$end") {
      // of $dumpvars
    } else if (word.front() == '$') {
      skip_to_end();
    } else if (word.front() == '#') {
      const std::int64_t time = std::stoll(word.substr(1));
      EXPECT_GT(time, dump.last);
      if (dump.first < 0) dump.first = time;
      dump.last = time;
    } else if (word.front() == 'b') {
      const std::string digits = word.substr(1);
      words >> word;
      change(word, digits);
    } else {
      change(word.substr(1), word.substr(0, 1));
    }
  }
  EXPECT_TRUE(scopes.empty());
  return dump;
}

}  // namespace leadscrew::cli::testing
