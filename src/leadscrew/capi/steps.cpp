// The call of leadscrew.h for steps: a trajectory's words, made good for the screws, as step and direction.

#include <leadscrew/host/program_reading.hpp>
#include <leadscrew/steps/compensation.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <leadscrew/waves/step_dump.hpp>
#include <memory>
#include <string_view>

#include "handles.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

namespace {

base::Result<void> write_steps(const leadscrew_trajectory& trajectory, std::int64_t clock_hz, base::ByteSink sink) {
  auto compensation = steps::Compensation::create(trajectory.machine);
  if (!compensation) return base::failure(compensation.error());
  auto made = steps::StepGenerator::create(compensation->stretched(trajectory.machine), clock_hz);
  if (!made) return base::failure(made.error());
  const auto generator = std::make_unique<steps::StepGenerator>(std::move(*made));
  waves::StepVcdWriter writer(std::move(sink), trajectory.machine, clock_hz);
  base::Result<void> state;
  const auto put = [&](std::span<const steps::StepEvent> events) {
    if (state) state = writer.write(events);
  };
  const auto follow = [&](const base::Word& word) { generator->follow(compensation->apply(word), put); };
  const base::Tick last = trajectory.planned.last_tick();
  for (base::Tick tick{}; state && tick <= last; tick = base::next(tick)) follow(trajectory.planned.word(tick));
  while (state && !compensation->settled()) follow(trajectory.planned.word(last));
  if (state) generator->finish(put);
  if (!state) return state;
  if (const auto complaint = generator->complaint()) return base::failure(*complaint);
  return writer.finish();
}

}  // namespace

int leadscrew_trajectory_steps(const leadscrew_trajectory* trajectory, int64_t clock_hz,
                               leadscrew_text_function on_text, void* user, leadscrew_error* error) {
  if (trajectory == nullptr || on_text == nullptr) return misuse(error, "the trajectory or the function is NULL");
  return guarded(error, [&] {
    const auto written = write_steps(*trajectory, clock_hz, [&](std::string_view text) -> base::Result<void> {
      if (on_text(text.data(), text.size(), user) != 0) return base::failure(host::interruption());
      return {};
    });
    if (!written) return rejected(error, written.error());
    return static_cast<int>(LEADSCREW_OK);
  });
}
