#pragma once
// What is done, in files that only grow: each process has one of its own, so that nobody waits for another.
//
//     shards/HOST-PID-TIME.jsonl:   {"check":"…","key":"…","result":{…},"spent":{…}}      a line a task
//
// A line is written by one write(2): a process that is killed leaves whole lines, and at most the beginning of one, which its
// checksum betrays. Every second the disk is asked to have them (fdatasync). A process holds a lock on its shard
// as long as it lives.

#include <chrono>
#include <functional>
#include <leadscrew/base/result.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/key.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::sweep {

/// What a task took of the computer.
struct Spent {
  double begin = 0;      ///< s since 1970
  double end = 0;        ///< the same
  double processor = 0;  ///< s of the processor that did it
};

/// A process' own.
class ShardWriter {
 public:
  /// In the folder DIR/shards; nothing is made before the first result. `build`: build_name().
  ShardWriter(std::string folder, std::string build) : folder_(std::move(folder)), build_(std::move(build)) {}
  ~ShardWriter() { static_cast<void>(sync()); }
  ShardWriter(const ShardWriter&) = delete;
  ShardWriter& operator=(const ShardWriter&) = delete;

  /// Errors: `io-open`, `io-write`; then the shard holds what it held before.
  base::Result<void> add(const Key& key, const json::Json& result, const Spent& spent);
  /// What was added is on the disk.
  base::Result<void> sync();

 private:
  base::Result<void> open();

  std::string folder_, build_, path_;
  files::Descriptor file_;
  std::int64_t size_ = 0;  // bytes of whole lines
  bool is_dirty_ = false;
  std::chrono::steady_clock::time_point synced_{};
};

/// One line of a shard, refers to its text.
struct ShardLine {
  Key key;
  std::string_view text;
};

/// What stands in a line, as it was written.
struct ShardParts {
  std::string_view result, spent;  ///< JSON objects; empty where there are none
};
ShardParts parts_of(const ShardLine& line);

/// Calls with every whole line of all shards in the folder, in the order of their names; lines that are not whole are passed
/// over. None where there is no folder. Errors: `io-open`, `io-read`, interruption.
base::Result<void> for_each_line(const std::string& folder, const std::function<void(const ShardLine&)>& line);

/// Waits until no process writes to any shard of the folder, at most so many seconds. Error: `sweep-in-use`.
base::Result<void> await_writers(const std::string& folder, double seconds);

}  // namespace leadscrew::sweep
