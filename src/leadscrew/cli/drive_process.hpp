#pragma once
// The drives' process, as the command sees it, and the memory that both share.

#include <sys/types.h>

#include <leadscrew/base/result.hpp>
#include <leadscrew/cli/drive_link.hpp>
#include <leadscrew/cli/drive_state.hpp>
#include <leadscrew/cli/job.hpp>
#include <memory>
#include <vector>

namespace leadscrew::cli {

class DriveProcess {
 public:
  /// Before there are threads. `begin` and `way_back` are those of run_drives(). Errors: `io-open`.
  static base::Result<std::unique_ptr<DriveProcess>> start(const Job& job, const DriveState& begin,
                                                           const std::vector<base::PathPlace>& way_back);
  /// Waits until the drives stand, without another word.
  ~DriveProcess();
  DriveProcess(const DriveProcess&) = delete;
  DriveProcess& operator=(const DriveProcess&) = delete;

  DriveLink& link() { return *link_; }
  /// One that has been silent for too long, while this one was awake, is ended here.
  bool is_running();
  /// Was it?
  bool was_silent() const { return was_silent_; }

 private:
  explicit DriveProcess(DriveLink* link);
  bool is_silent();

  DriveLink* link_;
  pid_t id_ = 0;
  bool was_silent_ = false;
  std::int64_t beats_ = 0;              ///< periods it had lived when it was last looked at
  std::int64_t beat_ = 0, looked_ = 0;  ///< ns: when it lived one more, and when that was
};

}  // namespace leadscrew::cli
