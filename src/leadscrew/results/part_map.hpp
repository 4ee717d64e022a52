#pragma once
// The part seen from above, in braille characters: what is to be cut, and over it where the axes have been.
//
//   a character   1 4      its code is U+2800 plus 1 for dot 1, 2 for dot 2, … 128 for dot 8
//                 2 5
//                 3 6
//                 7 8

#include <cstdint>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::results {

class PartMap {
 public:
  /// All that the program travels at feed, in X and Y; so many characters large. `reader`: from its beginning, each time.
  PartMap(const std::function<gcode::Reader()>& reader, int columns, int rows);

  /// The axes have been here.
  void visit(const base::AxisVector& position);
  /// Lines of text, each character as `paint` has it, which is told whether the axes have been there.
  std::string text(const std::function<std::string(bool, std::string_view)>& paint) const;

 private:
  struct Dot {
    int column = 0, row = 0;
  };
  Dot dot_at(double x, double y) const;
  std::size_t cell_at(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void set(std::vector<std::uint8_t>& dots, Dot dot) const;
  void draw(double x0, double y0, double x1, double y1);

  int columns_, rows_;
  double left_ = 0, top_ = 0, unit_ = 1;       ///< mm; of a dot
  std::vector<std::uint8_t> ideal_, visited_;  ///< a character each
};

}  // namespace leadscrew::results
