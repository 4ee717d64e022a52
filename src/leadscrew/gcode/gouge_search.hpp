#pragma once
// Where the tool of cutter compensation cuts into a piece of the contour that is none of the neighbours of the one that it
// goes along: a slot or a neck that is too narrow, a loop that closes over several moves.
//
//        contour  ───────╮  ╭───────        Along one side of the neck the tool is nearer to the other side than its
//                   way  ╎r │               radius: neither neighbour of a neighbour tells, since the cavity below has
//                        │  │               room for both ways.
//                     ╭──╯  ╰──╮
//                     ╰────────╯
//
// Every piece of a run at feed and at one level, with the way beside it, is held against the pieces of the run that came
// before: way against contour, both ways round, boxes first. 2048 pieces are kept; what came before those is looked at no more.
//
// By a lead-in the tool comes to the contour across where it goes along later, by a lead-out it goes off: what they lead
// along is no material. Where the contour closes, which is where a piece passes the start of one before it, only the
// pieces between are material; where it does not, all but the first and the last. So what is found is told at the end of the run.
// What leads in and off, or goes over the first of a contour again, may miss it by the rounding of programs: where it cuts by
// more than the contour's end misses its beginning, that is told as slight.
//
// Neighbours are looked at by who adds them, but beside an arc of more than half a turn, which may be a whole contour.

#include <cstdint>
#include <deque>
#include <functional>
#include <leadscrew/gcode/offset_contour.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <vector>

namespace leadscrew::gcode {

/// Whether a piece is an arc of more than half a turn.
bool is_long_arc(const ContourPiece& contour);

class GougeSearch {
 public:
  /// Told of the two places, in the order of the program; slight: by 0.01 mm at most, where the contour closes.
  enum class Depth : bool { usual, slight };
  using Report = std::function<void(const KeptPlace&, const KeptPlace&, Depth)>;

  /// The next piece of the run with its way. radius: mm, > 0, the same all along a run.
  void add(const OffsetPiece& piece, double radius, const KeptPlace& place);
  /// The arc round the corner behind the piece added last.
  void add_corner(const OffsetPiece& corner, double radius, const KeptPlace& place);
  /// The run ends: what has been found is told, once a line of the later of both, and everything is forgotten.
  void end_run(const Report& report);
  /// As end_run(), and nothing is told.
  void forget();

 private:
  /// A piece, or an arc round the corner before the piece of its number.
  struct Entry {
    OffsetPiece piece;
    KeptPlace place;
    std::size_t number = 0;
    bool is_corner = false;
    PlaneBox contour;  ///< around the contour of a piece
    PlaneBox way;      ///< around what the tool reaches
  };
  struct Group {
    std::vector<Entry> entries;
    PlaneBox contours;
    PlaneBox ways;
  };
  struct Gouge {
    std::size_t way = 0;        ///< number of the piece that the tool goes along
    std::size_t contour = 0;    ///< of the piece that is cut into
    bool is_deep = false;       ///< by more than programs are rounded
    bool is_on_way_in = false;  ///< on the arc round the corner before the first piece
    OffsetPiece cutting;        ///< the way
    ContourPiece cut;           ///< into
    double radius = 0;          ///< mm
    KeptPlace first;
    KeptPlace second;
  };

  void keep(Entry entry);
  void compare(const Entry& before, const Entry& entry, double radius);
  void look_for_end(const Entry& entry);
  bool is_gouge(const Gouge& gouge) const;
  bool is_slight(const Gouge& gouge) const;

  std::deque<Group> groups_;
  std::vector<Gouge> found_;
  std::size_t count_ = 0;  // of pieces of the run
  bool is_closed_ = false;
  std::size_t closed_from_ = 0;  // the pieces between which the contour closes
  std::size_t closed_to_ = 0;
  double gap_ = 0;  // mm, there
};

}  // namespace leadscrew::gcode
