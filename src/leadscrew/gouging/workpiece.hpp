#pragma once
// All surfaces that a tool may meet, as triangles in a tree of boxes, and the place where a tool comes nearest to them.

#include <cstddef>
#include <cstdint>
#include <leadscrew/gouging/mesh.hpp>
#include <leadscrew/gouging/tool.hpp>
#include <memory>
#include <vector>

namespace leadscrew::gouging {

/// Where a part of a tool is nearest to the surfaces, or deepest in them.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();  ///< mm; < 0: the surface is so deep inside the tool
  std::uint32_t cell = no_cell;                               ///< of the triangles
  Vector place{};                                             ///< of the triangles, or refined, of the surface; mm

  static constexpr std::uint32_t no_cell = 0xFFFFFFFF;
};

/// A hit on the surface itself.
struct SurfacePlace {
  double distance = 0;      ///< mm; < 0 inside the tool
  std::size_t surface = 0;  ///< by its number
  double u = 0, v = 0;
  Vector place{};  ///< mm
};

/// Surfaces, as triangles.
class Workpiece {
 public:
  /// Triangles that are kept: some 90 MB.
  static constexpr std::size_t most_triangles = 1'000'000;

  /// sag: mm; > 0. How far triangles are from the surfaces at most; made greater until there are no more than may be.
  Workpiece(std::vector<std::shared_ptr<const surfaces::Surface>> surfaces, double sag,
            std::size_t most = most_triangles);

  /// False where the surfaces have so many spans that no sag will do: there are no triangles then.
  bool fits() const { return fits_; }
  double sag() const { return sag_; }  ///< mm, that it has come to
  std::size_t triangles() const { return 2 * cells_.size(); }

  /// No place of the triangles is farther from this one, mm.
  double reach_from(const Vector& place) const;

  /// The least distance of a part from all triangles, as nearest_of_triangle() has it, where that is less than `bound`; else
  /// bound, and no cell. `near` is looked at first: the cell of the hit before, or none.
  Hit nearest(const Part& part, const Pose& pose, double bound, std::uint32_t near = Hit::no_cell) const;

  /// The same on the surface itself, from a hit that has a cell: the least that Newton's method finds from there.
  SurfacePlace refined(const Part& part, const Pose& pose, const Hit& hit) const;

 private:
  struct Node {
    Vector center{}, half{};
    std::uint32_t first = 0;  ///< cell, or the first of two nodes
    std::uint32_t count = 0;  ///< of cells; 0: two nodes
  };
  bool tessellate_all(std::size_t most);
  void build();
  double bound_of(const Part& part, const Pose& pose, const Node& node) const;

  std::vector<std::shared_ptr<const surfaces::Surface>> surfaces_;
  double sag_;
  bool fits_ = false;
  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
};

}  // namespace leadscrew::gouging
