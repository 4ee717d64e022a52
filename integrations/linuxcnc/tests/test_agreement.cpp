/* SPDX-License-Identifier: GPL-2.0-only */
// A machine's file and the kinematics module that motmod calls: compared at 20 poses before motion begins, one in a period.
#include <gtest/gtest.h>

#include <algorithm>

#include "posemath.h"
extern "C" {
#include "kinematics.h"
}
#include "motmod.hpp"
#include "planning.h"

extern "C" {
#include "state.h"
extern void* rtapi_info_address_machine;
}

namespace {

int calls = 0;
double difference = 0;  ///< mm, of the module's joint 1 from the file's at the last of the poses

/// A trunnion of the file's, whose kinematics are those of the module.
class OfTwoRotaryAxes : public testing::Test {
 protected:
  void SetUp() override {
    *static_cast<char**>(rtapi_info_address_machine) = file.data();
    calls = 0;
    difference = 0;
  }
  void TearDown() override { *static_cast<char**>(rtapi_info_address_machine) = nullptr; }

 private:
  std::string file = LEADSCREW_TP_MACHINE;
};

TEST_F(OfTwoRotaryAxes, KinematicsAreComparedAtOnePoseInAPeriod) {
  Motmod motmod;
  for (const double x : {5.0, 0.0}) {  // anew whenever motion begins: pins may have changed
    calls = 0;
    EXPECT_EQ(motmod.line(x, 0), TP_ERR_OK);
    EXPECT_EQ(calls, 0);
    int most = 0, before_motion = 0;
    EXPECT_TRUE(motmod.cycle_until([&, last = 0]() mutable {
      most = std::max(most, calls - last);
      last = calls;
      if (motmod.speed() == 0) before_motion = calls;
      return motmod.functions.tpIsDone(&motmod.tp) != 0;
    }));
    EXPECT_EQ(most, 1);
    EXPECT_EQ(before_motion, 20);
    EXPECT_EQ(motmod.pose.tran.x, x);
  }
}

TEST_F(OfTwoRotaryAxes, NothingMovesWhereTheyDiffer) {
  Motmod motmod;
  difference = 0.001;
  EXPECT_EQ(motmod.line(5, 0), TP_ERR_OK);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.functions.tpIsDone(&motmod.tp) != 0; }));
  EXPECT_EQ(calls, 20);
  EXPECT_TRUE(motmod.status.motionFlag & EMCMOT_MOTION_ERROR_BIT);
  EXPECT_EQ(motmod.difference(1), 0);
  difference = 0;
  EXPECT_EQ(motmod.line(5, 0), TP_ERR_OK);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.pose.tran.x, 5);
}

}  // namespace

extern "C" int kinematicsInverse(const EmcPose* pose, double* joints, const KINEMATICS_INVERSE_FLAGS*,
                                 KINEMATICS_FORWARD_FLAGS*) {
  double place[leadscrew_tp_axes], axes[leadscrew_tp_axes];
  position_of(pose, place);
  leadscrew_tp_axes_of(leadscrew_state.planning, place, 0, axes);
  int joint = 0;
  for (const int axis : {0, 1, 2, 3, 5}) joints[joint++] = axes[axis];
  if (++calls == 20) joints[1] += difference;
  return 0;
}
