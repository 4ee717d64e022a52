#pragma once
// A drive that is looked upon: what the drives feed back becomes events, and wishes of viewers with the token reach the
// thread that drives. Neither is seen by the cycle: events are made of what the drives have sent already, by the thread that
// takes it 50 times a second, and a viewer that takes nothing is not waited for (channel.hpp).

#include <leadscrew/drive/drive.hpp>
#include <leadscrew/drive/wishes.hpp>
#include <leadscrew/serve/channel.hpp>
#include <leadscrew/serve/live_events.hpp>
#include <leadscrew/serve/server.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::serve {

class DriveStream {
 public:
  struct Options {
    int port = usual_port;     ///< 0: any that is free
    bool may_control = false;  ///< by whoever knows the token
  };

  /// Takes the port, before anything moves; nobody is answered before the drive begins. The process of the drives, a fork, has the
  /// port as well, and gives it back when the drives stand. Program, setup and wishes outlive it. Errors: those of
  /// page_folder(), Page::read() and Server::open(), and of the program's file; `io-open` where the system gives no token.
  static base::Result<std::unique_ptr<DriveStream>> open(const files::InputFile& program, const drive::Setup& setup,
                                                         Options options, drive::Wishes& wishes);
  /// Viewers get the last events first.
  ~DriveStream();
  DriveStream(const DriveStream&) = delete;
  DriveStream& operator=(const DriveStream&) = delete;

  /// Where it is looked at, and the token, for people.
  std::string text() const;

  /// The same onlooker, with the viewers beside; where they may control, motion waits at pauses for them too. This outlives it.
  drive::Onlooker join(const drive::Onlooker& onlooker);

 private:
  DriveStream(const drive::Setup& setup, drive::Wishes& wishes);
  bool control(std::string_view body);
  void observe(const drive::Feedback& feedback);
  bool obey(const drive::WordMaker& maker, realtime::Runner& runner);
  std::vector<Wish> take_wishes();
  LiveState state_of(const drive::WordMaker& maker, const realtime::Counters& counters) const;

  const drive::Setup& setup_;
  drive::Wishes& wishes_;
  const std::int64_t periods_per_sample_;
  std::int64_t periods_ = 0;
  drive::Feedback last_{};
  LiveState state_;
  bool stops_ = false;
  std::mutex mutex_;
  std::vector<Wish> asked_;  ///< by threads of the server
  Channel channel_;
  std::optional<std::string> token_;
  std::unique_ptr<Server> server_;
};

}  // namespace leadscrew::serve
