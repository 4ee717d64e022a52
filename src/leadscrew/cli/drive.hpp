#pragma once
// `leadscrew drive`: a program on time.
//
//   program ─▶ MotionSource ─▶ Runner ─▶ words ─▶ drives, a process of their own ─▶ trace, axes, state
//                  ▲                                     └─ feedback ─▶ view
//            signals, keys
//
// A signal, or q, brings motion to rest on the path. After a second signal no more words are made: the drives come to
// rest by the way that came with the last ones, on the path too. So they do when this process is killed.

#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/status.hpp>

namespace leadscrew::cli {

Status drive(const Job& job, Console& console);

}  // namespace leadscrew::cli
