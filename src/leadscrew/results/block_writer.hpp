#pragma once
// What each block took, as comma-separated rows: a header line, and 17 significant digits.
//
//   line,text,from X,…,to X,…,length,feed_asked,feed_reached,time,least_time,time_lost,cause
//
// text: the block, quoted; from, to: of each axis of the machine, mm or degrees; length as feed is counted; feeds: mm/s or
// degrees/s, the first `rapid` of a rapid and empty of a dwell; times: s, the least one at the feed asked for; cause: of most
// of what is lost (pipeline::Cause), empty where nothing is.

#include <deque>
#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <string>
#include <vector>

namespace leadscrew::results {

class BlockWriter {
 public:
  /// program: read from its beginning, for the blocks' texts.
  BlockWriter(base::ByteSink sink, base::ByteSource program, const machine::Machine& machine);
  /// In the order of the program. The text of a line of a subprogram's file, or of one that stands more than 10 000
  /// lines before one that was written, is empty. Errors of the sink are told by finish().
  void write(const pipeline::BlockTime& block);
  base::Result<void> finish() { return rows_.flush(); }

 private:
  std::string text_of(base::Line line);
  bool read_line();

  base::BlockSink rows_;
  base::ByteSource program_;
  std::vector<base::Axis> axes_;
  std::string read_;
  std::size_t next_ = 0;  ///< of read_, not yet taken apart
  std::string text_;
  std::int64_t line_ = 0;           ///< of text_
  std::deque<std::string> before_;  ///< lines up to that one: loops go back to them
  bool has_ended_ = false;
};

}  // namespace leadscrew::results
