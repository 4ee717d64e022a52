#pragma once
// One viewer of a channel, as server-sent events. It is never written to when its connection takes nothing: then the channel
// goes on without it, and what it has missed is told once it takes something again.

#include <httplib.h>

#include <atomic>
#include <deque>
#include <leadscrew/serve/channel.hpp>
#include <memory>
#include <string>

namespace leadscrew::serve {

class Viewer {
 public:
  /// The channel and `stops` outlive it. `greeting` is its first event.
  Viewer(Channel& channel, const std::string& greeting, const std::atomic<bool>& stops);

  /// Writes what there is to write; waits a while for something. False: it is over, or the viewer has gone.
  bool feed(httplib::DataSink& sink);

 private:
  bool rest(httplib::DataSink& sink);

  Channel& channel_;
  const std::atomic<bool>& stops_;
  Channel::Place place_;
  std::deque<std::shared_ptr<const std::string>> unwritten_;
  int idle_ = 0, stalled_ = 0;  ///< times that there was nothing to write, or that it took nothing
  bool is_over_ = false;
};

}  // namespace leadscrew::serve
