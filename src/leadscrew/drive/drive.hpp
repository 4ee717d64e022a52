#pragma once
// A program on time.
//
//   program ─▶ WordMaker ─▶ words ─▶ drives, or a file: a process of their own ─▶ trace, axes, state
//                  ▲                         └─ feedback ─▶ who looks on
//            signals, keys
//
// A signal, or who looks on, brings motion to rest on the path. After a second signal no more words are made: the
// drives come to rest along the stop path that came with the last ones, on the path too. So they do when this process
// is killed.
//
// Modules, in the order of the data:
//   setup, checks     what is asked for, and whether the machine can be driven so
//   state, state_lock, resume, beginning   where an earlier drive has come to, and the return path to there
//   word_maker        text to words on time; word_guard: what is never handed over
//   link, process     memory shared by two processes, and the other one's life
//   drive_side, file_side, word_side       the other process: simulated drives, or a file
//   state_writer      the state on disk
//   slides            simulated slides that follow words, and what is measured of them

#include <termios.h>

#include <functional>
#include <leadscrew/base/result.hpp>
#include <leadscrew/drive/figures.hpp>
#include <leadscrew/drive/link.hpp>
#include <leadscrew/drive/setup.hpp>
#include <leadscrew/drive/word_maker.hpp>
#include <leadscrew/files/input_file.hpp>
#include <optional>

namespace leadscrew::drive {

/// Who looks on. All but `may_start` are called by the thread that drives; any may be absent.
struct Onlooker {
  std::optional<termios> terminal;  ///< settings to give back when this process was killed; none: it uses no terminal
  std::function<void()> at_begin;   ///< from here on the terminal will be given back
  std::function<void(const base::Diagnostic&)> tell;  ///< what is no error, as it is found
  std::function<void(const Feedback&)> observe;       ///< of a period of the drives
  /// Before there are words, while axes go back for so many seconds: true if motion is not wanted any more.
  std::function<bool(double seconds)> while_returning;
  /// 50 times a second: true if motion is to come to rest, and end.
  std::function<bool(const WordMaker&, realtime::Runner&)> while_moving;
  std::function<void()> at_end;   ///< before anything else is told
  WordMaker::MayStart may_start;  ///< by the planner's thread, of a chunk that begins at rest
};

/// Drives the program, which was read whole and has no error, from where the setup says to its end, or until it is
/// stopped. The machine passed check_machine(). From here on a first signal stops motion (files::interruptions()).
/// An error is in the figures where words were made, and the result elsewhere. Errors: those of Beginning::of(),
/// Process::start(), the drives' process (`io-…`, `servo-unstable`), interruption before the first word.
base::Result<Figures> drive(const files::InputFile& program, const Setup& setup, const Onlooker& onlooker);

}  // namespace leadscrew::drive
