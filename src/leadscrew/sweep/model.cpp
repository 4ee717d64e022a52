#include <algorithm>
#include <functional>
#include <leadscrew/sweep/model.hpp>
#include <limits>
#include <queue>
#include <utility>

namespace leadscrew::sweep {

namespace {

using Event = std::pair<double, int>;  // when, which rank
using Events = std::priority_queue<Event, std::vector<Event>, std::greater<>>;

constexpr double never = std::numeric_limits<double>::infinity();

/// Processors that are shared equally. Each rank at work gains the same; its task ends when what it has gained reaches a mark.
class SharedProcessors {
 public:
  explicit SharedProcessors(int processors) : processors_(processors) {}

  void begin(int rank, double seconds) { ends_.emplace(gained_ + seconds, rank); }
  bool is_idle() const { return ends_.empty(); }
  /// When the next task ends, if none begins before.
  double next(double now) const { return ends_.empty() ? never : now + (ends_.top().first - gained_) / speed(); }
  void advance(double seconds) {
    if (!ends_.empty()) gained_ += seconds * speed();
  }
  /// The rank whose task ends now.
  int end() {
    const auto [mark, rank] = ends_.top();
    ends_.pop();
    gained_ = mark;
    return rank;
  }

 private:
  double speed() const { return std::min(1.0, static_cast<double>(processors_) / static_cast<double>(ends_.size())); }

  int processors_;
  double gained_ = 0;
  Events ends_;
};

/// Serves one after the other, in the order of asking.
class Server {
 public:
  /// When it has served who asks now.
  double serve(double now, double seconds) {
    free_at_ = std::max(free_at_, now) + seconds;
    busy_ += seconds;
    return free_at_;
  }
  double busy() const { return busy_; }

 private:
  double free_at_ = 0, busy_ = 0;
};

class Simulation {
 public:
  Simulation(const ModelSetup& setup, const std::vector<double>& tasks)
      : setup_(setup),
        tasks_(tasks),
        processors_(setup.processors),
        has_shard_(static_cast<std::size_t>(setup.ranks)) {}

  ModelResult run() {
    for (int rank = 0; rank < setup_.ranks; ++rank) claim(rank);
    while (!waiting_.empty() || !processors_.is_idle()) {
      const double task_end = processors_.next(now_);
      const double waited = waiting_.empty() ? never : waiting_.top().first;
      const double next = std::min(task_end, waited);
      processors_.advance(next - now_);
      now_ = next;
      if (waited <= task_end) {
        const int rank = waiting_.top().second;
        waiting_.pop();
        has_shard_[static_cast<std::size_t>(rank)] == being_made ? have_shard(rank) : begin_task(rank);
      } else {
        end_task(processors_.end());
      }
    }
    return conclude();
  }

 private:
  enum Shard : char { none, being_made, made };

  void claim(int rank) {
    const double served = counter_.serve(now_, setup_.counter_service);
    result_.longest_wait = std::max(result_.longest_wait, served - setup_.counter_service - now_);
    waiting_.emplace(served + setup_.counter_latency, rank);
  }
  void begin_task(int rank) {
    if (next_task_ < tasks_.size()) return processors_.begin(rank, tasks_[next_task_++]);
    first_idle_ = std::min(first_idle_, now_);
  }
  void end_task(int rank) {
    char& shard = has_shard_[static_cast<std::size_t>(rank)];
    if (shard == made) return done(rank);
    shard = being_made;
    waiting_.emplace(file_system_.serve(now_, setup_.shard_service), rank);
  }
  void have_shard(int rank) {
    has_shard_[static_cast<std::size_t>(rank)] = made;
    result_.shard_wait = now_;
    done(rank);
  }
  void done(int rank) {
    result_.makespan = now_;
    claim(rank);
  }
  ModelResult conclude() {
    for (const double task : tasks_) result_.work += task;
    if (result_.makespan == 0) return result_;
    result_.counter_busy = std::min(1.0, counter_.busy() / result_.makespan);
    result_.straggling = std::max(0.0, result_.makespan - first_idle_);
    result_.efficiency = result_.work / (result_.makespan * std::min(setup_.processors, setup_.ranks));
    return result_;
  }

  const ModelSetup setup_;
  const std::vector<double>& tasks_;
  SharedProcessors processors_;
  Server counter_, file_system_;
  Events waiting_;               // for the counter, or for a shard
  std::vector<char> has_shard_;  // Shard of each rank
  std::size_t next_task_ = 0;
  double now_ = 0, first_idle_ = never;
  ModelResult result_;
};

}  // namespace

ModelResult simulate(const ModelSetup& setup, const std::vector<double>& tasks) {
  return Simulation(setup, tasks).run();
}

}  // namespace leadscrew::sweep
