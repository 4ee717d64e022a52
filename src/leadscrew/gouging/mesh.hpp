#pragma once
// Surfaces as triangles, for distances: cells of parameters, each two triangles, that lie within the sag of the surface.
//
// A flat triangle over a cell h wide and k high leaves the surface by no more than (h² |Suu| + 2 h k |Suv| + k² |Svv|)/8
// (Filip, Magedson and Markot, "Surface algorithms using bounds on derivatives", 1986); what counts here is the part along the
// normal. Cells are halved, the way that bends more, until that is below the sag. Where two cells of different size meet, the
// triangles leave gaps no wider than the sag.

#include <cstddef>
#include <cstdint>
#include <leadscrew/surfaces/surface.hpp>
#include <vector>

namespace leadscrew::gouging {

using surfaces::Vector;

/// Two triangles: corners 0 1 2 and 0 2 3.
struct Cell {
  std::array<Vector, 4> corners{};  ///< at (u.from, v.from), (u.to, v.from), (u.to, v.to), (u.from, v.to), mm
  surfaces::Range u, v;
  std::uint32_t surface = 0;
};

/// Appends the cells of a whole surface, until there are `most` in all; the share of its parameters that they cover, 1: all.
double tessellate(const surfaces::Surface& surface, std::uint32_t number, double sag, std::size_t most,
                  std::vector<Cell>& cells);

/// So many cells has a surface at any sag.
std::size_t least_cells(const surfaces::Surface& surface);

/// The parameters of a place of a cell's triangles.
std::array<double, 2> parameters_in(const Cell& cell, const Vector& place);

}  // namespace leadscrew::gouging
