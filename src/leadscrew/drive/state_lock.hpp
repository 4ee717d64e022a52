#pragma once
// One drive at a time keeps a state. The lock is a file beside the state's, `.leadscrew-NAME.lock`, that only its user
// may open, locked by flock(2): the system releases it with the last process that holds it, however that ends, and
// nobody who may not write to the folder can hold it in the user's place.
//
// The file goes when the lock is released. Another process may then hold a lock on a file that has no name any more; so
// whoever gets a lock looks whether the name still leads to it, and begins anew if it does not.

#include <leadscrew/base/result.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <string>
#include <utility>

namespace leadscrew::drive {

class StateLock {
 public:
  /// Held by this process and those that it forks, until the last of them ends. Waits up to 5 s for the drives of a
  /// command that was killed to come to rest. `state` is the path of the state; what is there and is no regular file
  /// needs no lock. Errors: `state-busy`, `io-open`, interruption.
  static base::Result<StateLock> hold(const std::string& state);

  StateLock(StateLock&& other) noexcept
      : descriptor_(std::move(other.descriptor_)), path_(std::exchange(other.path_, {})) {}
  StateLock& operator=(StateLock&&) = delete;
  /// Removes the file. For the process that ends last, where others hold the lock too.
  ~StateLock() { remove_file(); }

  /// For a process that ends without destructors.
  void remove_file();

 private:
  StateLock() = default;

  files::Descriptor descriptor_;
  std::string path_;  ///< empty where nothing is held
};

}  // namespace leadscrew::drive
