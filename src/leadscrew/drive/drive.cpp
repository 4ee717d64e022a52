#include <fmt/format.h>

#include <leadscrew/drive/beginning.hpp>
#include <leadscrew/drive/drive.hpp>
#include <leadscrew/drive/process.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/realtime/schedule.hpp>

namespace leadscrew::drive {

namespace {

constexpr std::int64_t frame = 20'000'000;  // ns between two looks at what happens
constexpr std::int64_t between_looks =
    1'000'000;  // ns between two looks whether drives that begin where they stand are ready

using End = Figures::End;
using Order = Link::Order;
using Phase = Link::Phase;

class Drive {
 public:
  Drive(const files::InputFile& program, const Setup& setup, const Onlooker& onlooker, const Beginning& begin,
        Process& process)
      : program_(program),
        setup_(setup),
        onlooker_(onlooker),
        begin_(begin),
        process_(process),
        link_(process.link()) {}

  base::Result<Figures> run() {
    if (onlooker_.terminal) link_.show_terminal(*onlooker_.terminal);
    if (onlooker_.at_begin) onlooker_.at_begin();
    auto ready = await_readiness();
    if (!ready) {
      if (onlooker_.at_end) onlooker_.at_end();
      return base::failure(ready.error());
    }
    WordMaker maker(program_, setup_, begin_.state.word, link_, onlooker_.may_start);
    maker.start();
    figures_.last = begin_.state.word;
    watch(maker);
    end_words(maker);
    await_end();
    maker.conclude();
    if (onlooker_.at_end) onlooker_.at_end();
    take_figures(maker);
    if (auto sound = check_process(); !sound) return base::failure(sound.error());
    return figures_;
  }

 private:
  /// Until the drives stand where motion begins. After a signal, or a word of who looks on, they do nothing more.
  base::Result<void> await_readiness() {
    const double seconds = static_cast<double>(begin_.return_path.size()) * setup_.machine.period.seconds();
    const std::int64_t pause = begin_.return_path.empty() ? between_looks : frame / 4;
    bool stops = false;
    while (process_.is_running() && (stops || link_.phase.load(std::memory_order_acquire) == Phase::starting)) {
      take_feedback();
      const bool is_unwanted = onlooker_.while_returning && onlooker_.while_returning(seconds);
      stops = stops || is_unwanted || files::interruptions() > 0;
      if (stops) link_.order.store(Order::abandon, std::memory_order_release);
      realtime::sleep_until(realtime::now() + pause);
    }
    if (auto sound = check_process(); !sound) return sound;
    if (stops) return base::failure(files::interruption());
    return {};
  }

  /// Until the last word is made, or nobody takes words any more.
  void watch(WordMaker& maker) {
    realtime::Runner& runner = maker.runner();
    while (!runner.has_ended()) {
      realtime::sleep_until(realtime::now() + frame);
      take_feedback();
      const bool is_to_stop = onlooker_.while_moving && onlooker_.while_moving(maker, runner);
      if ((files::interruptions() > 0 || is_to_stop) && figures_.end == End::done) {
        runner.stop();
        link_.stopping.store(true, std::memory_order_relaxed);
        figures_.end = End::stopped;
      }
      if (files::interruptions() > 1) {
        figures_.end = End::abandoned;
        link_.order.store(Order::abandon, std::memory_order_release);
        runner.halt();
      }
      if (!process_.is_running()) return runner.halt();
    }
  }

  void end_words(const WordMaker& maker) {
    link_.at_end.store(figures_.end == End::done && maker.has_come_to_end(), std::memory_order_release);
    auto order = Order::follow;
    link_.order.compare_exchange_strong(order, Order::end);
  }

  void await_end() {
    while (process_.is_running()) {
      if (files::interruptions() > 1) link_.order.store(Order::abandon, std::memory_order_release);
      take_feedback();
      realtime::sleep_until(realtime::now() + frame / 4);
    }
    take_feedback();
  }

  void take_figures(const WordMaker& maker) {
    figures_.counters = maker.counters();
    figures_.latencies = maker.latencies();
    figures_.blocks = maker.blocks();
    figures_.real_time = figures_.counters.words > 0 && !maker.notice();
    for (const auto& remark : {maker.notice(), maker.warning()}) {
      if (remark && onlooker_.tell) onlooker_.tell(*remark);
    }
    figures_.taken = link_.taken.load(std::memory_order_acquire);
    figures_.drives_late = link_.late_periods.load(std::memory_order_relaxed);
    figures_.braked = link_.braked.load(std::memory_order_relaxed);
    take_slides();
    take_end(maker);
  }

  void take_slides() {
    if (!link_.is_over() || setup_.options.sink) return;
    figures_.has_drives = true;
    figures_.feed = link_.slides.feed;
    for (const base::Axis axis : base::all_axes) {
      if (setup_.machine.has(axis)) figures_.axes.emplace_back(axis, link_.slides.axes[base::index(axis)]);
    }
  }

  void take_end(const WordMaker& maker) {
    const bool was_stopped = figures_.end == End::stopped || figures_.end == End::abandoned;
    figures_.problem = maker.failure();
    if (figures_.problem) {
      if (!was_stopped && !link_.at_end.load(std::memory_order_relaxed)) figures_.end = End::failed;
      return;
    }
    // A file that was given up while it was to be stopped is no surprise.
    const bool was_left = figures_.end == End::abandoned || (setup_.options.sink && figures_.end == End::stopped);
    const bool is_tripped = link_.phase.load() == Phase::tripped || figures_.counters.too_long_to_rest;
    if (!is_tripped || was_left) return;
    figures_.end = End::tripped;
    figures_.problem = why_tripped();
  }

  base::Diagnostic why_tripped() const {
    if (figures_.counters.too_long_to_rest) {
      return base::problem(
          "stop-too-long",
          fmt::format("a stop takes more than {} periods: motion has ended before", Link::longest_stop_path),
          "a longer --period needs fewer; --resume goes on from there");
    }
    return base::problem("words-late", "the drives got no word in time and came to rest by themselves",
                         "--resume goes on from there; a greater --lead lets words be later");
  }

  void take_feedback() {
    for (Feedback feedback; link_.feedback.pop(feedback);) {
      figures_.last = feedback.word;
      if (onlooker_.observe) onlooker_.observe(feedback);
    }
  }

  /// Do the drives do what they should, or have they done all of it?
  base::Result<void> check_process() const {
    const bool runs = process_.is_running();  // before the phase is looked at, which is its last word
    if (link_.phase.load(std::memory_order_acquire) == Phase::failed) return base::failure(link_.problem.diagnostic());
    if (process_.was_silent())
      return base::failure(base::problem("io-drives", "the process of the drives did nothing for 10 s, and was ended",
                                         "--resume goes on from the state that it wrote last"));
    if (!runs && !link_.is_over())
      return base::failure(base::problem("io-drives", "the process of the drives has ended", {}));
    return {};
  }

  const files::InputFile& program_;
  const Setup& setup_;
  const Onlooker& onlooker_;
  const Beginning& begin_;
  Process& process_;
  Link& link_;
  Figures figures_;
};

}  // namespace

base::Result<Figures> drive(const files::InputFile& program, const Setup& setup, const Onlooker& onlooker) {
  auto begin = Beginning::of(program, setup);
  if (!begin) return base::failure(begin.error());
  for (const base::Diagnostic& warning : begin->warnings) {
    if (onlooker.tell) onlooker.tell(warning);
  }
  files::let_first_interruption_pass();
  // Before there are threads.
  auto process = Process::start(setup, *begin);
  if (!process) return base::failure(process.error());
  return Drive(program, setup, onlooker, *begin, **process).run();
}

}  // namespace leadscrew::drive
