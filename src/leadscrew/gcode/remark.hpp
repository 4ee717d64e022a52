#pragma once
// What a program says to people and into log files, in remarks such as (MSG,text) (LinuxCNC manual, "Comments"), and
// the points that it probes.

#include <cstdint>
#include <functional>
#include <leadscrew/base/diagnostic.hpp>
#include <string>

namespace leadscrew::gcode {

/// One remark that asks for something, with the values of its parameters written out.
struct Remark {
  enum class Kind : std::uint8_t {
    message,      ///< (MSG,text), (DEBUG,text): to be shown to the operator
    print,        ///< (PRINT,text): a line on standard error
    log_open,     ///< (LOGOPEN,name): log lines go to this file from now on, from its beginning
    log_append,   ///< (LOGAPPEND,name): the same, behind what it holds
    log,          ///< (LOG,text): a line into the log file
    log_close,    ///< (LOGCLOSE)
    probe_open,   ///< (PROBEOPEN name): points that a probe finds go to this file from now on, from its beginning
    probe_point,  ///< such a point: nine coordinates of the program, X Y Z A B C U V W, in its units; of every one
    probe_close,  ///< (PROBECLOSE)
  };
  Kind kind = Kind::message;
  std::string text;   ///< the text or the name, at most some megabytes; a name is relative and has no ".."
  base::Place place;  ///< of the remark
};

/// Called for each of them as the reader comes to it, which is ahead of motion by as much as the reader is.
using RemarkSink = std::function<void(const Remark&)>;

}  // namespace leadscrew::gcode
