#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/json/json.hpp>
#include <leadscrew/options/options.hpp>
#include <leadscrew/sweep/merge.hpp>
#include <leadscrew/sweep/model_table.hpp>
#include <leadscrew/sweep/shards.hpp>
#include <limits>
#include <map>

namespace leadscrew::sweep {

namespace {

using options::Parsed;
using options::wrong;

constexpr double most_ranks = 1e6;

/// Of the tasks, in the order in which they were begun.
struct Measured {
  std::vector<double> processor;  // s
  double makespan = 0;            // s
};

double number_at(const json::Json& object, std::string_view key) {
  const json::Json* const value = object.find(key);
  return value == nullptr ? 0 : value->number().value_or(0);
}

base::Result<Measured> measured_in(const std::string& folder) {
  std::map<Key, bool> known;
  std::vector<std::pair<double, double>> tasks;  // begin, processor
  double first = std::numeric_limits<double>::infinity(), last = 0;
  const auto take = [&](const ShardLine& line) {
    if (!known.emplace(line.key, true).second) return;
    const auto read = json::Json::parse(line.text);
    const json::Json* const spent = read ? read->find("spent") : nullptr;
    if (spent == nullptr) return;
    const double begin = number_at(*spent, "begin");
    tasks.emplace_back(begin, number_at(*spent, "processor_s"));
    first = std::min(first, begin);
    last = std::max(last, number_at(*spent, "end"));
  };
  if (auto read = for_each_line(shards_of_sweep(folder), take); !read) return base::failure(read.error());
  if (tasks.empty())
    return base::failure({base::Severity::error,
                          "sweep-tasks",
                          "holds no sweep with a task that is done",
                          "give the folder that --out of a sweep named",
                          {.file = folder},
                          {}});
  std::ranges::sort(tasks);
  Measured measured{.makespan = last - first};
  for (const auto& [begin, processor] : tasks) measured.processor.push_back(processor);
  return measured;
}

Parsed<int> parse_count(std::string_view text) {
  const auto number = options::parse_number(text);
  if (!number || !(*number >= 1) || *number > most_ranks || *number != std::floor(*number))
    return wrong("\"{}\" is no whole number from 1 to {}", text, most_ranks);
  return static_cast<int>(*number);
}

}  // namespace

Parsed<std::vector<ModelSetup>> parse_model_setups(std::string_view text) {
  std::vector<ModelSetup> setups;
  while (true) {
    const std::size_t end = std::min(text.find(','), text.size());
    const std::string_view one = text.substr(0, end);
    const std::size_t at = std::min(one.find('@'), one.size());
    const auto ranks = parse_count(one.substr(0, at));
    if (!ranks) return tl::unexpected(ranks.error());
    const auto processors = at == one.size() ? ranks : parse_count(one.substr(at + 1));
    if (!processors) return tl::unexpected(processors.error());
    setups.push_back({.ranks = *ranks, .processors = *processors});
    if (end == text.size()) return setups;
    text.remove_prefix(end + 1);
  }
}

base::Result<std::string> model_table(const std::string& folder, const std::vector<ModelSetup>& setups,
                                      std::int64_t count) {
  const auto measured = measured_in(folder);
  if (!measured) return base::failure(measured.error());
  std::vector<double> tasks = measured->processor;
  const std::size_t own = tasks.size();
  while (static_cast<std::int64_t>(tasks.size()) < count) tasks.push_back(measured->processor[tasks.size() % own]);
  // Longest first again, where they are repeated.
  if (tasks.size() > own) std::ranges::stable_sort(tasks, std::greater<>());
  std::string text =
      fmt::format("measured    {} tasks in {:.3f} s, from the first to the last\n", own, measured->makespan);
  text += "ranks  processors  time s  efficiency  counter busy  longest wait s  shards made s  straggling s\n";
  for (const ModelSetup& setup : setups) {
    const ModelResult result = simulate(setup, tasks);
    text += fmt::format("{:5}  {:10}  {:6.3f}  {:8.1f} %  {:10.2f} %  {:14.6f}  {:13.3f}  {:12.3f}\n", setup.ranks,
                        setup.processors, result.makespan, 100 * result.efficiency, 100 * result.counter_busy,
                        result.longest_wait, result.shard_wait, result.straggling);
  }
  return text;
}

}  // namespace leadscrew::sweep
