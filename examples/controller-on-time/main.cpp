// A controller on time: one thread plans, another makes a word every servo period and hands it to a function of yours
// and to a file. ^C brings motion to rest on the path. Replace `send` by your drives.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <leadscrew/motion_source.hpp>
#include <leadscrew/realtime.hpp>
#include <leadscrew/trace.hpp>

using namespace leadscrew;

/// Called by the cyclic thread, so it must not wait: the word of this period.
static std::atomic<double> x, y, z;
static void send(const base::Word& word) {
  x = word.position[0], y = word.position[1], z = word.position[2];
}

static void complain(const base::Diagnostic& diagnostic) {
  std::fprintf(stderr, "line %lld: %s\n", static_cast<long long>(diagnostic.place.line), diagnostic.message.c_str());
}

static std::atomic<bool> interrupted;

int main(int argc, char** argv) {
  std::FILE* program = argc == 3 ? std::fopen(argv[1], "rb") : nullptr;
  std::FILE* trace = program ? std::fopen(argv[2], "wb") : nullptr;
  if (!trace) return std::fprintf(stderr, "usage: controller-on-time PROGRAM TRACE.csv\n"), 2;
  const gcode::ByteSource source = [&](std::span<char> bytes) {
    return std::fread(bytes.data(), 1, bytes.size(), program);
  };

  const machine::Machine mill = machine::mill3();
  const machine::ToolTable tools;
  gcode::Reader check(source, mill, tools, {}, complain);  // read it whole before anything moves
  for (gcode::Move move; check.next(move);) {
  }
  if (check.errors() > 0) return 3;
  std::rewind(program);

  trace::CsvWriter writer(
      [&](std::string_view text) -> base::Result<void> {
        if (std::fwrite(text.data(), 1, text.size(), trace) == text.size()) return {};
        return base::failure(base::problem("io-write", "cannot write the trace", "is the disk full?"));
      },
      mill.axis_set(), mill.period);
  realtime::WaitingSink file([&](const base::Word& word) { return writer.write(word).has_value(); });
  const realtime::WordSink to_file = file.sink();

  pipeline::MotionSource motion(source, mill, tools, {}, complain);
  motion.planner().slice(0.02);  // so that a stop takes effect soon
  realtime::Runner runner({.period = mill.period},
                          {.next = [&] { return motion.next(); },
                           .refuse = [&] { motion.planner().refuse(); },
                           .override_feed = [&](double factor) { motion.planner().override_feed(factor); },
                           .come_to_rest = [&] { motion.planner().come_to_rest(); },
                           .is_held = [&] { return motion.planner().is_held(); }},
                          {.take =
                               [&](const base::Word& word) {
                                 if (!to_file.take(word)) return false;
                                 send(word);
                                 return true;
                               },
                           .publish = to_file.publish});
  std::signal(SIGINT, [](int) { interrupted = true; });
  runner.start();
  while (!runner.has_ended()) {
    if (interrupted) runner.stop();
    realtime::sleep_until(realtime::now() + 100'000'000);
    std::fprintf(stderr, "\rX %.4f  Y %.4f  Z %.4f ", x.load(), y.load(), z.load());
  }
  file.end();
  const bool is_written = !file.is_refused() && writer.finish() && std::fclose(trace) == 0;
  const realtime::Counters counters = runner.counters();
  std::fprintf(
      stderr, "\n%lld words, %lld stops as planning was late, %lld periods slept through, 99 %% woke within %.0f µs\n",
      static_cast<long long>(counters.words), static_cast<long long>(counters.starvations),
      static_cast<long long>(counters.overruns), static_cast<double>(runner.latencies().percentile(0.99)) / 1000);
  return is_written ? interrupted ? 130 : 0 : 4;
}
