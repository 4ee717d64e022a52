#pragma once
// What drafts of surfaces have shown, from one reading of a program to the next.
//
//     the reading that checks ──drafts of all passes──▶ lines, and where rotary axes begin ──▶ the reading that moves, the referee's …
//
// A draft of two hundred passes takes as long as a third of what checks them all: motion would wait for it a second time. What is
// kept names everything that it follows from, and serves no other machining, chain, travel or beginning: there a draft is made anew,
// as it is where there was no room.

#include <cstddef>
#include <leadscrew/gcode/rotary_lift.hpp>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

#ifdef __wasi__  // one thread, and a library without std::mutex
struct DraftsMutex {
  void lock() {}
  void unlock() {}
};
#else
using DraftsMutex = std::mutex;
#endif

/// What a draft follows from.
struct SurfaceDraftKey {
  surfaces::Machining machining;
  kinematics::Chain chain;
  kinematics::RotaryLimits limits;
  kinematics::Angles<double> before{};  ///< where the rotary axes are, degrees

  /// Surfaces of one form are the same, and is_draft counts for nothing.
  friend bool operator==(const SurfaceDraftKey& a, const SurfaceDraftKey& b);
};

/// What it has shown.
struct SurfaceDraft {
  RotaryLift::Choice choice;
  std::shared_ptr<const surfaces::FoundLines> lines;  ///< null: too many to be kept
};

/// In bounded memory. Any thread may ask and tell.
class SurfaceDrafts {
 public:
  static constexpr std::size_t most_bytes = std::size_t{8} << 20;  ///< of lines, and of the surfaces that they are of
  static constexpr std::size_t most_drafts = 256;

  std::optional<SurfaceDraft> find(const SurfaceDraftKey& key) const;
  /// Passed over where it does not fit beside those that came before it, which are wanted first.
  void keep(SurfaceDraftKey key, SurfaceDraft draft);

  std::size_t count() const;
  /// How often one was asked for and found.
  std::size_t found() const;

 private:
  struct Kept {
    SurfaceDraftKey key;
    SurfaceDraft draft;
  };
  const Kept* of(const SurfaceDraftKey& key) const;

  mutable DraftsMutex mutex_;
  std::vector<Kept> kept_;
  std::size_t bytes_ = 0;
  mutable std::size_t found_ = 0;
};

}  // namespace leadscrew::gcode
