#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/sweep/results_page.hpp>
#include <limits>

namespace leadscrew::sweep {

namespace {

constexpr std::size_t most_listed = 1000;  // refusals, and rows that break a promise
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::string text_in(const json::Json& row, std::string_view key) {
  const json::Json* const value = row.find(key);
  return value == nullptr || value->text() == nullptr ? std::string() : *value->text();
}

double number_in(const json::Json& row, std::string_view key) {
  const json::Json* const value = row.find(key);
  return value == nullptr ? nothing : value->number().value_or(nothing);
}

std::int64_t integer_in(const json::Json& row, std::string_view key) {
  const json::Json* const value = row.find(key);
  return value == nullptr ? 0 : value->integer().value_or(0);
}

/// What was not kept, in a row that says so.
std::string broken_in(const json::Json& row) {
  if (std::string broken = text_in(row, "broken"); !broken.empty()) return broken;
  if (const json::Json* const first = row.find("first_violation"); first != nullptr)
    return fmt::format("{}, line {}: {:.6g} where {:.6g} is allowed", text_in(*first, "what"),
                       number_in(*first, "line"), number_in(*first, "value"), number_in(*first, "limit"));
  return "plan or end";
}

}  // namespace

void ResultsPage::observe(const json::Json& row) {
  if (const std::string kind = text_in(row, "kind"); !kind.empty()) return observe_case(row, kind);
  // Variants of --optimise have a picture of their own.
  if (row.find("changed") != nullptr) return;
  observe_program(row);
}

void ResultsPage::observe_case(const json::Json& row, const std::string& name) {
  Kind& kind = kinds_[name];
  ++kind.cases;
  const double time = number_in(row, "time_s");
  if (time > 0) kind.time_s += time;
  const double allowed = number_in(row, "allowed_mm");
  const std::array<double, 5> ratios = {number_in(row, "velocity_ratio"), number_in(row, "acceleration_ratio"),
                                        number_in(row, "jerk_ratio"), number_in(row, "feed_ratio"),
                                        allowed > 0 ? number_in(row, "deviation_mm") / allowed : nothing};
  for (std::size_t i = 0; i < ratios.size(); ++i) kind.worst[i] = std::fmax(kind.worst[i], ratios[i]);
  if (text_in(row, "status") == "kept") return;
  ++kind.broken;
  if (broken_.size() >= most_listed) return void(++more_broken_);
  const std::string code = text_in(row, "code");
  broken_.push_back({fmt::format("seed {}, number {} ({})", integer_in(row, "seed"), integer_in(row, "number"), name),
                     code.empty() ? broken_in(row) : code + ": " + text_in(row, "message")});
}

void ResultsPage::observe_program(const json::Json& row) {
  const std::string status = text_in(row, "status");
  const std::size_t variant = variant_of(row);
  if (const std::string program = text_in(row, "program"); times_.empty() || program != program_) {
    program_ = program;
    times_.emplace_back();
  }
  if (status != "kept" && status != "not-kept") return refuse(row);
  observe_time(row, variant);
  if (status == "kept") return;
  if (broken_.size() >= most_listed) return void(++more_broken_);
  std::string place = program_ + " on " + machines_[variants_[variant].machine];
  for (std::size_t i = 0; i < parameter_names.size(); ++i) {
    if (std::isfinite(variants_[variant].values[i]) && variants_[variant].values[i] != 1)
      place += fmt::format(", {} {}", parameter_names[i], variants_[variant].values[i]);
  }
  broken_.push_back({std::move(place), broken_in(row)});
}

void ResultsPage::observe_time(const json::Json& row, std::size_t variant) {
  std::vector<double>& times = times_.back();
  times.resize(std::max(times.size(), variant + 1), nothing);
  times[variant] = number_in(row, "time_s");
  const std::size_t machine = variants_[variant].machine;
  const json::Json* const lost = row.find("lost");
  if (first_of(machine) != variant || lost == nullptr) return;
  lost_[machine].time_s += times[variant];
  if (lost->members() == nullptr) return;
  for (const auto& [cause, seconds] : *lost->members()) lost_[machine].by_cause[cause] += seconds.number().value_or(0);
}

void ResultsPage::refuse(const json::Json& row) {
  const std::string machine = text_in(row, "machine"), code = text_in(row, "code");
  if (!refusals_.empty()) {
    // Variants of one machine come one after the other.
    Refusal& last = refusals_.back();
    if (last.program == program_ && last.machine == machine && last.code == code) return void(++last.variants);
  }
  if (refusals_.size() >= most_listed) return void(++more_refusals_);
  const json::Json* const line = row.find("line");
  refusals_.push_back(
      {program_, machine, code, text_in(row, "message"), line == nullptr ? 0 : line->integer().value_or(0), 1});
}

std::size_t ResultsPage::variant_of(const json::Json& row) {
  Variant variant;
  const std::string machine = text_in(row, "machine");
  variant.machine = static_cast<std::size_t>(std::ranges::find(machines_, machine) - machines_.begin());
  if (variant.machine == machines_.size()) {
    machines_.push_back(machine);
    lost_.emplace_back();
  }
  std::string values;
  for (std::size_t i = 0; i < parameter_names.size(); ++i) {
    variant.values[i] = number_in(row, parameter_names[i]);
    values += fmt::format("{} ", variant.values[i]);
  }
  const auto [known, is_new] = known_variants_.try_emplace({variant.machine, values}, variants_.size());
  if (is_new) variants_.push_back(variant);
  return known->second;
}

ResultsPage::Times ResultsPage::times(std::optional<std::size_t> machine) const {
  Times all;
  all.by_variant.resize(variants_.size());
  for (std::vector<double> times : times_) {
    times.resize(variants_.size(), nothing);
    bool ran = true;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const bool is_meant = !machine || variants_[i].machine == *machine;
      ran = ran && !(is_meant && std::isnan(times[i]));
    }
    if (!ran) continue;
    ++all.programs;
    for (std::size_t i = 0; i < times.size(); ++i) all.by_variant[i] += times[i];
  }
  return all;
}

std::size_t ResultsPage::first_of(std::size_t machine) const {
  return static_cast<std::size_t>(std::ranges::find(variants_, machine, &Variant::machine) - variants_.begin());
}

}  // namespace leadscrew::sweep
