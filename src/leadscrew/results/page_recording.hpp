#pragma once
// What the workbench's page of a program shows of words: samples at equal steps of time and the moves in their order, in
// memory that does not grow with the motion. Where there would be too many samples, every second one goes.

#include <array>
#include <cstdint>
#include <deque>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/gcode/machined_move.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/pipeline/near_limits.hpp>
#include <leadscrew/referee/referee.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace leadscrew::results {

class PageRecording {
 public:
  static constexpr std::size_t most_samples = 65'536, most_blocks = 65'536;

  /// The machine gives axes, limits and period, and must outlive the recording.
  explicit PageRecording(const machine::Machine& machine);

  /// Of the word that is observed next: how far it is from the program.
  void judge(const referee::MatchedBlock& matched);
  /// Word after word from that of t = 0; its pose where the machine has a chain of rotary axes.
  void observe(const base::Word& word, const std::optional<kinematics::ToolPose>& pose);
  /// Of a word that will be observed: feed that is asked for (programmed_feed), and the tool.
  void observe(const base::PassedEvent& event);
  /// What the next move that becomes a block has to do with a surface; before observe() of that block.
  void expect(const gcode::MachinedMove& machined);
  /// In the order of the program.
  void observe(const pipeline::BlockTime& block);

  /// Are there no more moves than most_blocks?
  bool is_whole() const { return is_whole_; }
  json::Json samples() const;  ///< "samples" of schema leadscrew.recording/1
  json::Json blocks() const;   ///< "blocks" of it

 private:
  using Derivative = std::array<float, base::axis_count>;

  /// Of all words since the sample before, that which is the farthest for its tolerance.
  struct Judged {
    float distance = 0, tolerance = 0;  ///< mm
  };
  struct Sample {
    base::AxisVector position{};                    ///< mm or degrees
    Derivative velocity{}, acceleration{}, jerk{};  ///< differences of words over period^k
    double feed = 0, length = 0;                    ///< as base::Word has them
    std::array<float, 3> tip{}, direction{0, 0, 1};
    float pole_angle = std::numeric_limits<float>::infinity();  ///< degrees
    std::int32_t line = 0, tool = 0;
    pipeline::Hold hold;
    Judged judged;
  };
  struct Block {
    pipeline::BlockTime time;
    std::int32_t part = 0, pass = 0;  ///< 1 + gcode::MachinedMove::Part; 0: no surface
  };

  void advance(base::Tick tick);
  Sample sample_of(const base::Word& word, const std::optional<kinematics::ToolPose>& pose);
  void thin();
  static Judged farther(const Judged& a, const Judged& b);
  std::vector<Sample> all() const;

  const machine::Machine& machine_;
  std::vector<base::Axis> axes_;
  std::optional<kinematics::Chain> chain_;
  std::vector<Sample> samples_;
  Sample last_;  ///< of the last word
  std::int64_t words_ = 0, every_ = 1;
  std::array<base::AxisVector, 4> differences_{};  ///< of the last word, 0th to 3rd
  std::deque<base::PassedEvent> ahead_;
  std::optional<Judged> judged_;  ///< of words behind the last sample
  double feed_asked_ = 0;         ///< mm/s; infinite of a rapid
  std::array<double, 3> offset_{};
  std::int32_t tool_ = 0;
  std::deque<gcode::MachinedMove> expected_;
  std::vector<Block> blocks_;
  bool is_whole_ = true;
};

}  // namespace leadscrew::results
