#include <algorithm>
#include <leadscrew/planner/continuation.hpp>
#include <leadscrew/planner/cubic_basis.hpp>

namespace leadscrew::planner {

void Continuation::insert(double knot) {
  if (knot < s[loose]) ++loose;
  const auto at = std::upper_bound(s.begin(), s.end(), knot) - s.begin();
  breaks.insert(breaks.begin() + at, false);
  if (static_cast<std::size_t>(at) <= tightened.size())
    tightened.insert(tightened.begin() + at, tightened[static_cast<std::size_t>(at) - 1]);
  insert_knot(s, c, knot);
  ++creeping;
}

}  // namespace leadscrew::planner
