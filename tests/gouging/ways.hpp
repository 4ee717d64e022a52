#pragma once
// Passes over a surface as ways of a tool.

#include <leadscrew/gouging/sweep.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/surfaces/hermite.hpp>
#include <leadscrew/surfaces/passes.hpp>

namespace leadscrew::gouging::test {

inline Way way_of(const surfaces::Pass& pass) {
  const double begin = pass.nodes.front().t, end = pass.nodes.back().t;
  return {[&pass, begin, end](double share) {
            const double t = begin + share * (end - begin);
            std::size_t k = 0;
            while (k + 2 < pass.nodes.size() && pass.nodes[k + 1].t < t) ++k;
            const auto &a = pass.nodes[k], &b = pass.nodes[k + 1];
            const double width = b.t - a.t, x = (t - a.t) / width;
            Pose pose;
            for (std::size_t i = 0; i < 3; ++i) {
              pose.tip[i] = surfaces::hermite_value(a.tip[i], b.tip[i], width, x);
              pose.axis[i] = surfaces::hermite_value(a.axis[i], b.axis[i], width, x);
            }
            pose.axis = kinematics::unit_vector(pose.axis);
            return pose;
          },
          0.02};
}

inline Way line(const Pose& from, const Pose& to) {
  return {[from, to](double t) {
            Pose pose;
            for (std::size_t i = 0; i < 3; ++i) {
              pose.tip[i] = from.tip[i] + t * (to.tip[i] - from.tip[i]);
              pose.axis[i] = from.axis[i] + t * (to.axis[i] - from.axis[i]);
            }
            pose.axis = kinematics::unit_vector(pose.axis);
            return pose;
          },
          1};
}

}  // namespace leadscrew::gouging::test
