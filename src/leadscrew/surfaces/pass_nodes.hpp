#pragma once
// A line of a surface made into a pass: nodes so close that the quintics between them are the tip's true path.
//
// Between two nodes the curve has the value and two derivatives of both, by t. t is a quintic polynomial of the line's own
// parameter as well, made of the tip's speed and its derivative at both nodes and of the length between, so that t goes on at the
// tip's speed at every node, and joins where the parameter itself has none (knots of circles as rational B-splines) are
// smooth. Halved until middle and quarters are right.

#include <leadscrew/surfaces/line.hpp>

namespace leadscrew::surfaces {

/// What passes share: how the surface is machined and what was found so far.
struct PassLog {
  const Machining* machining = nullptr;
  std::optional<PassFailure> failure;
  std::optional<Passes::Least> least;
  std::size_t number = 0;  ///< of the pass being made

  void fail(PassFailure::Kind kind, double u, double v, double amount = 0) {
    if (!failure) failure = PassFailure{kind, u, v, amount};
  }
};

/// Frame and bending at a place of this jet; none where it may not be machined, which the log then tells.
struct Contact {
  SurfaceJet jet;
  Frame frame;
  Bending bending;
};
std::optional<Contact> contact_at(PassLog& log, const LinePlace& place, const SurfaceJet& jet);
/// With the jet of second order.
std::optional<Contact> contact_at(PassLog& log, const LinePlace& place);

/// Parts of a pass along a line, more than one where it has corners or many nodes. Fewer than told where the log has a failure.
std::vector<Pass> passes_along(PassLog& log, const Line& line);

}  // namespace leadscrew::surfaces
