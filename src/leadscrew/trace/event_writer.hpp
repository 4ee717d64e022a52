#pragma once
// Events as comma-separated rows, beside a trace: a header line, and 17 significant digits.
//
//   tick,t,s,line,code,output,value    tick and t, seconds: of the word in whose period it happened; s: path length of
//                                      its place, mm; code: as the program has it, S, M8; output: of M62 … M68; value:
//                                      of codes that have one

#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/base/event.hpp>

namespace leadscrew::trace {

class EventWriter {
 public:
  EventWriter(base::ByteSink sink, base::Period period);
  base::Result<void> write(const base::PassedEvent& event);
  base::Result<void> finish() { return rows_.flush(); }

 private:
  base::BlockSink rows_;
  base::Period period_;
};

}  // namespace leadscrew::trace
