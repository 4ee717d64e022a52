#pragma once
// G6.4: a surface, defined in many blocks.
//
//     G6.4 D1 P4 Q4 I4 J4     surface 1: of orders P in u and Q in v (2 … 6: the degree and one), with I × J points
//     X_ Y_ Z_ R_ K_ L_       a point and its weight R (1 if not given) a block, u fastest: the I points of v's first row first.
//                             Axes not given keep their value. K and L, in the first blocks: the knots of u, I + P of them, and of
//                             v, J + Q; without any they are clamped and evenly spaced from 0 to 1.
//
// Points are coordinates of the program, under G91 too, whatever lies between those and the machine's: that counts where the
// surface is machined. It ends with its last point. Until then there is nothing but points, parameters and remarks: anything else is an
// unfinished-surface. Whoever defines a number again replaces what it was.

#include <leadscrew/gcode/part.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <map>
#include <memory>
#include <vector>

namespace leadscrew::gcode {

class SurfaceBlocks : Part {
 public:
  /// Of all surfaces together.
  static constexpr std::size_t most_points = std::size_t{1} << 20;

  explicit SurfaceBlocks(const Context& context) : Part(context) {}

  /// G6.4. Error: `surface-counts`.
  [[gnu::cold]] void begin(const Block& block);
  /// From that block to the last point.
  bool is_open() const { return draft_ != nullptr; }
  /// A block of the surface; false where it is none, which ends the surface. Errors: `missing-word`, `surface-knots`,
  /// `surface-weight`, `surface-counts`, `surface-rows`, `surface-normal`, `unfinished-surface`.
  [[gnu::cold]] bool add(const Block& block);
  /// Where the text ends.
  [[gnu::cold]] void end();

  /// In the program's coordinates, mm; null where there is none of this number.
  std::shared_ptr<const surfaces::SurfaceForm> find(int number) const;
  /// All that have no fault, by their numbers.
  std::vector<std::shared_ptr<const surfaces::SurfaceForm>> all() const;
  /// Has a problem with its definition been reported?
  bool is_spoiled(int number) const { return surfaces_.contains(number) && !surfaces_.at(number); }

 private:
  /// Once a problem of it has been reported, it is only followed to its end.
  struct Draft {
    int number = 0;
    KeptPlace place;  // of G6.4
    surfaces::SurfaceForm form;
    std::vector<base::Line> lines;  // of the points
    bool spoiled = false;
  };

  int count_of(const Block& block, char letter, int least, int most);
  bool problem(std::string_view code, std::uint32_t column, std::string message, std::string hint);
  void add_point(const Block& block);
  void add_knot(const Block& block, char letter, std::size_t direction);
  bool check_knots(const Block& block, std::size_t direction);
  void finish(const Block& block);
  void report(const Draft& draft, const surfaces::SurfaceFault& fault);

  std::unique_ptr<Draft> draft_;
  std::map<int, std::shared_ptr<const surfaces::SurfaceForm>> surfaces_;
  std::size_t points_ = 0;  // of all
};

}  // namespace leadscrew::gcode
