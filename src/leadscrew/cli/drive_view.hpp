#pragma once
// The live view of a drive on a terminal, and its keys.

#include <leadscrew/cli/job.hpp>
#include <leadscrew/drive/link.hpp>
#include <leadscrew/drive/terminal.hpp>
#include <leadscrew/drive/wishes.hpp>
#include <leadscrew/drive/word_maker.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <leadscrew/results/part_map.hpp>

namespace leadscrew::cli {

class DriveView {
 public:
  /// `served` is shown below: where else it is looked at, or nothing. The wishes outlive this.
  DriveView(const termios& settings, const files::InputFile& file, const Job& job, const Style& style,
            drive::Wishes& wishes, std::string served);

  void observe(const drive::Feedback& feedback);
  /// Draws ten times a second, and does what keys ask for: space holds and resumes, also at M0; + and − change the feed
  /// by 10 %. True if q was pressed.
  bool go_on(const drive::WordMaker& maker, realtime::Runner& runner);
  /// The same before there are words, while axes go back for so many seconds.
  bool go_back(double seconds);

 private:
  bool obey_keys(realtime::Runner& runner);
  bool is_asked_to_stop();
  void draw(const realtime::Runner& runner);
  void draw_return(double seconds);
  std::string place_text() const;
  std::string status_text(const realtime::Runner& runner) const;
  std::string wait_text(const realtime::Counters& counters) const;
  bool is_due();
  std::string map_text() const;

  drive::Terminal terminal_;
  const Job& job_;
  std::string program_;
  Style style_;
  kinematics::WordPoses poses_;
  results::PartMap map_;
  drive::Feedback last_{};
  drive::Wishes& wishes_;
  std::string served_;
  bool waits_for_input_ = false;
  std::int64_t drawn_ = 0;  ///< ns
};

}  // namespace leadscrew::cli
