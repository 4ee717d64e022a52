#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/drive/word_maker.hpp>
#include <utility>

namespace leadscrew::drive {

namespace {

constexpr double least_spare = 0.1;  // s planned behind the words that are made ahead

base::Diagnostic refusal(const RefusedWord& refused) {
  constexpr std::array<std::string_view, 3> reasons = {"its travel", "its velocity", "its acceleration"};
  return base::problem(
      "word-refused",
      fmt::format("a word would lead {} to {:.6g}, beyond {}: the drives did not get it", base::letter(refused.axis),
                  refused.position, reasons[static_cast<std::size_t>(refused.reason)]),
      "this is a defect of leadscrew: please report it, with the program and the machine file");
}

}  // namespace

WordMaker::WordMaker(const files::InputFile& program, const Setup& setup, const base::Word& first, Link& link,
                     MayStart may_start)
    : program_(program),
      setup_(setup),
      link_(link),
      source_(counted(program.source()), setup.machine, setup.tools, setup.reader_options(program.name()), nullptr),
      guard_(setup.machine, first.position),
      way_guard_(guard_) {
  source_.unchanged = [this] { return program_.unchanged(); };
  source_.planner().slice(slice_duration);
  source_.planner().start_at(first.path_length, first.line);
  const Options& options = setup.options;
  const double period = setup.machine.period.seconds();
  const std::int64_t lead = std::llround(options.lead / period);
  const std::int64_t words_of_slice = std::max<std::int64_t>(1, std::llround(slice_duration / period));
  const realtime::RunnerOptions runner_options = {
      .period = setup.machine.period,
      .position = first.position,
      .path_length = first.path_length,
      .line = first.line,
      .look_ahead =
          std::max(options.look_ahead, options.lead + least_spare) + static_cast<double>(words_of_slice) * period,
      .lead = lead,
      .slice = words_of_slice};
  runner_.emplace(runner_options, planning(std::move(may_start)),
                  sink(static_cast<std::size_t>(2 * (lead + words_of_slice) + 4)));
}

void WordMaker::conclude() {
  counters_ = runner_->counters();
  latencies_ = runner_->latencies();
  if (counters_.words > 0) notice_ = runner_->notice();
  runner_.reset();
}

std::optional<base::Diagnostic> WordMaker::failure() const {
  if (source_.failure()) return source_.failure();
  if (guard_.refused()) return refusal(*guard_.refused());
  if (way_guard_.refused()) return refusal(*way_guard_.refused());
  // Read to its end before it was changed: motion is that of the program, but no file tells any more of which.
  if (auto same = program_.unchanged(); !same) return same.error();
  return std::nullopt;
}

gcode::ByteSource WordMaker::counted(gcode::ByteSource source) {
  return [this, source = std::move(source)](std::span<char> bytes) {
    auto got = source(bytes);
    if (got) bytes_read_.fetch_add(static_cast<std::int64_t>(*got), std::memory_order_relaxed);
    return got;
  };
}

realtime::Planning WordMaker::planning(MayStart may_start) {
  return {.next = [this] { return next_chunk(); },
          .refuse = [this] { source_.planner().refuse(); },
          .override_feed = [this](double factor) { source_.planner().override_feed(factor); },
          .lets = std::move(may_start)};
}

std::optional<planner::Chunk> WordMaker::next_chunk() {
  std::optional<planner::Chunk> chunk = source_.next();
  // Before the runner knows that this was the last.
  if (source_.failure()) has_failed_.store(true, std::memory_order_release);
  return chunk;
}

/// A slice that holds a refused word, or whose way to rest does, is not published: for the drives there is none.
realtime::WordSink WordMaker::sink(std::size_t most_waiting) {
  return {.take =
              [this, most_waiting](const base::Word& word) {
                if (link_.words.waiting() >= most_waiting || !link_.words.push(word)) return false;
                guard_.observe(word.position);
                way_guard_ = guard_;
                return true;
              },
          .lead_on =
              [this](const base::PathPlace& place) {
                way_guard_.observe(place.position);
                return link_.words.lead_on(place);
              },
          .publish =
              [this] {
                if (!way_guard_.refused()) return link_.words.publish();
                is_refused_.store(true, std::memory_order_release);
                return false;
              }};
}

}  // namespace leadscrew::drive
