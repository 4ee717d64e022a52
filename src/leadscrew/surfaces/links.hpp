#pragma once
// From the end of one pass to the beginning of the next: off the surface, with no step of direction or curvature, so that
// motion need not stop.
//
//     near:  ╭──────╮   one loop ahead of both        far:      ╭───────────────╮   up, over and down
//        ────╯      ╰────   ends, lifted between             ───╯               ╰───
//
// What is laid is the path of the tool's centre, r above the tip along the axis: a ball that swings about it goes nowhere. The
// lift is along the axis, where a tool that is free stays free. It grows until the whole tool is clear of the whole surface at
// many places of the link, at its ends as clear as the passes are.
// Where a pass's end is bent much, as of a ball that is nearly as round as the surface, a quintic of the link's length would
// swing out far: there a short one leads off the surface first, as long as the end's radius of curvature.

#include <leadscrew/surfaces/pass_nodes.hpp>
#include <leadscrew/surfaces/tool_clearance.hpp>

namespace leadscrew::surfaces {

class LinkMaker {
 public:
  explicit LinkMaker(const Machining& machining) : machining_(machining) {}

  /// None where the log has a failure then. Where gouging is allowed and no link is as clear as its ends, that of those tried which gouges least.
  std::optional<Pass> between(PassLog& log, const PassNode& from, const PassNode& to);

 private:
  /// A curve of nodes with two derivatives by t.
  struct Track {
    std::vector<double> t;
    std::vector<VectorOf<Jet2>> jets;

    void add(double at, const VectorOf<Jet2>& jet) {
      t.push_back(at);
      jets.push_back(jet);
    }
    VectorOf<Jet2> at(double place) const;
  };
  struct Course {
    Track centre, axis;
    double length = 0, rise = 0, descent = 0;  // mm; of the quintics off both ends where these are bent much, else 0
    double swing_up = 0, swing_down = 0;       // mm; to the middle, or to where it is in flight, from both ends
  };
  struct Ends {
    const PassNode *from = nullptr, *to = nullptr;
    VectorOf<Jet2> from_centre, to_centre;
    double distance = 0, turn = 0;  // of the centres, mm; of the axes, radians
  };
  Ends ends_of(const PassNode& from, const PassNode& to) const;
  Course begun_course(Ends& ends, double length) const;
  void end_course(const Ends& ends, const Ends& between, double t, Course& course) const;
  Course near_course(const Ends& ends, double lift) const;
  Course far_course(const Ends& ends, double lift) const;
  void add_axis(const Ends& ends, Course& course) const;
  double worst_clearance(const Course& course, const Ends& ends) const;
  std::vector<PassNode> nodes_of(const Course& course, const Ends& ends) const;
  PassNode node_at(const Course& course, double t) const;
  ToolPose pose_at(const Course& course, double t) const;

  const Machining& machining_;
  std::optional<ToolClearance> clearance_;  // made for the first link
  std::array<std::size_t, 2> last_lift_{};  // of near and far links: which was clear
};

}  // namespace leadscrew::surfaces
