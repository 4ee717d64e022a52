#pragma once
// What each block took, as comma-separated rows: a header line, and 17 significant digits.
//
//   line,text,from X,…,to X,…,length,feed_asked,feed_reached,time,least_time,time_lost,cause,file,visit
//
// text: the block, quoted; from, to: of each axis of the machine, mm or degrees; length as feed is counted; feeds: mm/s or
// degrees/s, the first `rapid` of a rapid and empty of a dwell; times: s, the least one at the feed asked for; cause: of most
// of what is lost (pipeline::Cause), empty where nothing is; file: the name of a subprogram's, quoted, empty of the program
// itself; visit: base::visit().

#include <deque>
#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <map>
#include <string>
#include <vector>

namespace leadscrew::results {

/// The lines of a text, one after the other; those before stay known for a while.
class PassedLines {
 public:
  explicit PassedLines(base::ByteSource text) : source_(std::move(text)) {}
  /// Of one that stands more than 10 000 lines before one that was asked for, or behind the last: empty.
  std::string line(std::int64_t number);

 private:
  bool read_line();

  base::ByteSource source_;
  std::string read_;
  std::size_t next_ = 0;  ///< of read_, not yet taken apart
  std::string text_;
  std::int64_t line_ = 0;           ///< of text_
  std::deque<std::string> before_;  ///< lines up to that one: loops go back to them
  bool has_ended_ = false;
};

class BlockWriter {
 public:
  /// program: read from its beginning, as its subprograms are, for the blocks' texts; it must outlive this.
  BlockWriter(base::ByteSink sink, const files::InputFile& program, const machine::Machine& machine);
  /// In the order of the program. Where PassedLines does not know the text any more, it is empty. Errors of the sink are
  /// told by finish().
  void write(const pipeline::BlockTime& block);
  base::Result<void> finish() { return rows_.flush(); }

 private:
  std::string text_of(base::Line line);

  base::BlockSink rows_;
  const files::InputFile& program_;
  std::map<int, PassedLines> texts_;  ///< by base::file()
  std::vector<base::Axis> axes_;
};

}  // namespace leadscrew::results
