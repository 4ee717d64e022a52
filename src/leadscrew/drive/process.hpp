#pragma once
// The drives' process, as the command sees it, and the memory that both share.

#include <sys/types.h>

#include <leadscrew/base/result.hpp>
#include <leadscrew/drive/beginning.hpp>
#include <leadscrew/drive/link.hpp>
#include <leadscrew/drive/setup.hpp>
#include <memory>

namespace leadscrew::drive {

class Process {
 public:
  /// Before there are threads. Errors: `io-open`.
  static base::Result<std::unique_ptr<Process>> start(const Setup& setup, Beginning& begin);
  /// Waits until the drives stand, without another word.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  Link& link() { return *link_; }
  /// One that has been silent for too long, while this one was awake, is ended here.
  bool is_running();
  /// Was it?
  bool was_silent() const { return was_silent_; }

 private:
  explicit Process(Link* link);
  bool is_silent();

  Link* link_;
  pid_t id_ = 0;
  bool was_silent_ = false;
  std::int64_t beats_ = 0;              ///< periods it had lived when it was last looked at
  std::int64_t beat_ = 0, looked_ = 0;  ///< ns: when it lived one more, and when that was
};

}  // namespace leadscrew::drive
