#pragma once
// G47: engraves the text of a remark in its block, a number that counts, or a character (Haas mill operator's manual, "Text
// Engraving"), in a font of strokes of our own.

#include <leadscrew/gcode/planned_cycle.hpp>
#include <string>

namespace leadscrew::gcode {

class Engraving : Part {
 public:
  static constexpr int counter = 599;  ///< the parameter that P1 engraves, and then adds 1 to (Haas)

  Engraving(const Context& context, Motion& motion, PlannedCycle& cycle)
      : Part(context), motion_(motion), cycle_(cycle) {}

  /// `remark` is what stands between the brackets of the block; empty where there are none.
  [[gnu::cold]] void engrave(const Block& block, const std::string& remark);

 private:
  /// mm.
  struct Plan {
    double top = 0, bottom = 0;  ///< of Z
    double height = 0;           ///< of a character
    PlanePoint start;
    double cosine = 1, sine = 0;  ///< of the line's direction
    Feed feed, plunge;
  };

  bool check(const Block& block);
  bool plan(const Block& block, Plan& plan);
  bool find_text(const Block& block, const std::string& remark, std::string& text);
  bool count(const Block& block, const std::string& remark, std::string& text);
  void cut(const Plan& plan, char character, std::size_t place);

  Motion& motion_;
  PlannedCycle& cycle_;
};

}  // namespace leadscrew::gcode
