#pragma once
// A smooth curve through the tube around a polyline: the quintic B-spline that keeps close to it and bends as evenly as
// the tube allows.
//
//      ______________                             It minimises
//        ·        ·  ‾‾--..__    tube             Σ Δu |q(u_i) − p(u_i)|² + ∫ ℓ⁶ |q‴|² du,
//      ──●────────●────────__●──                  p the polyline, q the curve, at the same parameter u. The longer the
//      ______________        ‾‾‾--●               smoothing length ℓ(u), the smoother the curve and the farther from
//                    ‾‾--..__                     the polyline: ℓ is as long as may be, and shortened about the places
//                                                 where the curve would leave the tube.
//
// Distance is taken at equal parameters, which bounds Fréchet's distance: of each curve from the other, and in order.
// Between two samples of one chord, e = q − p bends as q does, so |e| ≤ max(|e_i|, |e_i+1|) + Δu²/8 · max |q″|, and
// |q″| is no more than its largest control point. The proof is therefore complete, span interiors included.
//
// Streaming: a window of some 24 spans is solved, and the first third of it is settled; the next begins with its
// position and four derivatives.

#include <algorithm>
#include <leadscrew/toolpath/quintic_basis.hpp>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

/// Of the polyline.
struct Vertex {
  geometry::Point position{};  ///< mm in every coordinate
  double u = 0;                ///< increasing from vertex to vertex
  double margin = 0;           ///< allowed distance here and on the chord that ends here, mm; > 0
  double pace = 0;             ///< that feed asks for on that chord, s/mm; ≥ 0
  double tolerance = 0;        ///< P on that chord, mm: a smoothing length of less than half is not worth it
  double words = 0;            ///< how far chords between words may be from it, mm
};

class TubeSpline {
 public:
  /// From the state `start` at the vertex given first. `longest`: of ℓ, in u; > 0.
  TubeSpline(const State& start, const Vertex& vertex, double longest);

  /// The polyline goes on; not after close().
  void append(const Vertex& vertex) { vertices_.push_back(vertex); }
  /// The last vertex given is the end. The curve ends there with that state, its derivatives by −u; where `end` has one
  /// only (the position), in any direction.
  void close(const State& end) { end_ = end; }
  /// ℓ may be as long as this from what is not settled on.
  void lengthen(double longest) { longest_ = std::max(longest_, longest); }
  /// The end was another vertex, one that has not been settled: forgets all behind it, and that it was closed.
  void retreat_to(std::size_t vertex);

  /// Is enough of the polyline known for another stretch?
  bool knows_enough() const {
    return end_ || vertices_.back().u - begin_ > (1 + 1e-9) * reach() || vertices_.size() >= most_vertices;
  }
  enum class Outcome { wants_more, settled, ended, failed };
  /// Settles a stretch, if enough is known: it is to be had from stretch(). `ended`: that was the last. `failed`: there
  /// is none that stays inside the tube and is worth it, about vertex worst().
  Outcome settle();
  const QuinticSpline& stretch() const { return stretch_; }
  /// Where the stretch ends, or the curve was to begin.
  double settled() const { return begin_; }

  /// and the position there, mm.
  const geometry::Point& position() const { return start_.derivative[0]; }
  double longest() const { return longest_; }
  /// What is not settled yet; the first one at settled() or before.
  const std::vector<Vertex>& vertices() const { return vertices_; }
  std::size_t worst() const { return worst_; }
  /// Largest proven distance of all that has been settled, over the margin there; ≤ 1.
  double greatest_share() const { return greatest_share_; }
  /// What the stretch leaves for chords between words, mm.
  double sagitta() const { return sagitta_; }

  /// How much of the polyline must be known, in u, for another stretch to be settled.
  double reach() const { return window_spans * longest_ / spans_per_length; }

 private:
  static constexpr std::size_t most_vertices = 16384;  // of a window
  static constexpr double window_spans = 24, spans_per_length = 1.25;
  static constexpr std::size_t settled_share = 3;

  /// Where ℓ was shortened.
  struct Apex {
    double u = 0, length = 0;
  };
  struct Sample {
    double u = 0, weight = 0;
    std::size_t vertex = 0;  ///< at which its chord ends
    geometry::Point position{};
    std::size_t span = 0;
    Six basis{};
    double distance = 0;
    double lengthened = 0;  ///< the curve over the polyline from the sample before
  };

  double smoothing_length(double u) const;
  double shortest_length(double u) const;
  void shorten(double u, double length);
  void place_knots();
  void take_samples();
  class NormalEquations;
  void solve();
  std::vector<double> bends() const;
  std::optional<bool> is_detour(std::size_t judged);
  bool check();
  std::size_t settled_spans() const;

  std::vector<Vertex> vertices_;
  State start_;
  std::optional<State> end_;
  double begin_ = 0;
  bool begun_ = false;  ///< has a window been tried?
  double longest_;
  std::vector<Apex> apexes_;  ///< by u; none lies above another's cone
  std::size_t worst_ = 0;
  Apex least_asked_{};       ///< where the curve left the tube
  bool turns_back_ = false;  ///< did it there, nearly on the spot?
  double greatest_share_ = 0;

  // The window.
  QuinticSpline stretch_;
  double sagitta_ = 0;
  bool whole_ = false;  ///< does the window reach the end?
  std::vector<Sample> samples_;
};

}  // namespace leadscrew::toolpath
