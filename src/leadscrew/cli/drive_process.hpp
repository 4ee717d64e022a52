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
  bool is_running();

 private:
  explicit DriveProcess(DriveLink* link) : link_(link) {}

  DriveLink* link_;
  pid_t id_ = 0;
};

}  // namespace leadscrew::cli
