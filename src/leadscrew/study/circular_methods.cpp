#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/study/circular_methods.hpp>
#include <numbers>

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::CircularDda;
using pulse::CircularSearch;
using pulse::OnCircle;
using pulse::Order;
using pulse::Preload;
using pulse::Search;

template <Search method, OnCircle on_circle = OnCircle::outward>
FollowedArc search(const Arc& arc) {
  return {follow_arc(CircularSearch<method, on_circle>(arc), arc)};
}

template <Order order, Preload preload, int places = 0>
FollowedArc dda(const Arc& arc) {
  FollowedArc followed;
  followed.path = follow_arc(CircularDda(arc, {order, preload, places}), arc, [&](const CircularDda& dda) {
    followed.drained += (dda.left_x() == 0 && dda.at().x == 0) || (dda.left_y() == 0 && dda.at().y == 0);
  });
  return followed;
}

}  // namespace

const std::vector<CircularMethod>& circular_methods() {  // NOLINT(readability-function-size): a table
  constexpr double eighths = 8, diagonal = 4 * std::numbers::sqrt2, turn = 2 * std::numbers::pi;
  static const std::vector<CircularMethod> all = {
      {"point comparison", search<Search::point_comparison>, eighths, {{0.9990, 4, 500}}},
      {"point comparison, inward on the circle",
       search<Search::point_comparison, OnCircle::inward>,
       eighths,
       {{1, 4, 500}}},
      {"least error", search<Search::least_error>, diagonal, {{0.4992, 4, 500}, {0.49987, 5, 3000}}, 0.5, 0.5},
      {"improved least error",
       search<Search::improved_least_error>,
       diagonal,
       {{0.4992, 4, 500}, {0.49987, 5, 3000}},
       0.5,
       0.5,
       2},
      {"DDA, parallel, empty",
       dda<Order::parallel, Preload::none>,
       turn,
       {{1.8025, 4, 4096}},
       no_bound,
       no_bound,
       0,
       960},
      {"DDA, parallel, half", dda<Order::parallel, Preload::half>, turn, {{1.29, 2, 2000}}, no_bound, no_bound, 0, 0},
      {"DDA, parallel, half in the lagging axis", dda<Order::parallel, Preload::half_lagging>, turn, {{1.31, 2, 500}}},
      {"DDA, parallel, full", dda<Order::parallel, Preload::full>, turn, {{0.9995, 4, 4096}}},
      {"DDA, x first, empty", dda<Order::x_first, Preload::none>, turn, {{1.4675, 4, 4096}}, 1.45, 1.92, 0, 4624},
      {"DDA, x first, half", dda<Order::x_first, Preload::half>, turn, {{0.9655, 4, 4096}}, 0.94, 1.43, 0, 4032},
      {"DDA, x first, half in the lagging axis", dda<Order::x_first, Preload::half_lagging>, turn, {}},
      {"DDA, x first, full", dda<Order::x_first, Preload::full>, turn, {}},
      {"DDA, shrinking axis first, empty", dda<Order::shrinking_first, Preload::none>, turn, {}},
      {"DDA, shrinking axis first, half",
       dda<Order::shrinking_first, Preload::half>,
       turn,
       {{0.950, 3, 2000}},
       0.94,
       1.43,
       0,
       8064},
      {"DDA, shrinking axis first, half in the lagging axis",
       dda<Order::shrinking_first, Preload::half_lagging>,
       turn,
       {}},
      {"DDA, shrinking axis first, full", dda<Order::shrinking_first, Preload::full>, turn, {}},
      {"DDA, growing axis first, empty",
       dda<Order::growing_first, Preload::none>,
       turn,
       {{1.022, 3, 2000}},
       no_bound,
       no_bound,
       0,
       1024},
      {"DDA, growing axis first, half",
       dda<Order::growing_first, Preload::half>,
       turn,
       {{0.9655, 4, 4096}},
       0.94,
       1.43,
       0,
       0},
      {"DDA, growing axis first, half in the lagging axis", dda<Order::growing_first, Preload::half_lagging>, turn, {}},
      {"DDA, growing axis first, full", dda<Order::growing_first, Preload::full>, turn, {}},
      {"DDA, x first, half, R to 8 binary places", dda<Order::x_first, Preload::half, 8>, turn, {}, 0.94, 1.43},
      {"DDA, growing axis first, half, R to 8 binary places",
       dda<Order::growing_first, Preload::half, 8>,
       turn,
       {},
       0.94,
       1.43},
  };
  return all;
}

}  // namespace leadscrew::study
