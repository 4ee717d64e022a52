#pragma once
// The thread of planning: takes requests in their order and keeps the servo thread supplied with motion.
//
// Motion comes to rest before a move of another group, before one that waits, and wherever it runs dry. Before it begins
// anew, the servo thread is shown the move's number at the `gate` and says when it may begin: by then the factor of the feed
// is this move's.

#include <pthread.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "engine.hpp"
#include "link.hpp"

namespace leadscrew::linuxcnc {

class PlanningThread {
 public:
  /// `report` gets a line for each problem.
  PlanningThread(Link& link, const Kinematics& kinematics, const leadscrew_tp_options& options,
                 void (*report)(const char*))
      : link_(link), kinematics_(kinematics), options_(options), report_(report) {}
  /// Ends it.
  ~PlanningThread();
  PlanningThread(const PlanningThread&) = delete;
  PlanningThread& operator=(const PlanningThread&) = delete;

  /// Without priority, whatever the caller's. False where the system gives none.
  bool start();

 private:
  void run();
  bool step_or_break() noexcept;
  void break_off(const char* what) noexcept;
  bool step();
  bool pop(leadscrew_tp_move& move);
  void set_down();
  void make_engine(const Position& position);
  bool refuse_moves();
  void take_moves();
  bool may_begin(const leadscrew_tp_move& move);
  void fail(const std::string& why);
  void tell();

  Link& link_;
  const Kinematics& kinematics_;
  const leadscrew_tp_options options_;
  void (*const report_)(const char*);
  std::atomic<bool> ends_{false};
  std::optional<pthread_t> thread_;

  std::uint32_t set_down_ = 0;  ///< number of the setting down that `engine_` belongs to
  Request where_;               ///< the last setting down that has come out of the ring
  std::unique_ptr<Engine> engine_;
  std::optional<leadscrew_tp_move> next_;  ///< taken from the ring, not pushed yet
  std::uint32_t pushed_ = 0;               ///< number of the last move that was
  int group_ = 0;                          ///< of it
  bool has_failed_ = false;
  bool is_broken_ = false;  ///< something was thrown: there is no more motion until it is set down anew
  std::string problem_;     ///< why there is no engine
};

}  // namespace leadscrew::linuxcnc
