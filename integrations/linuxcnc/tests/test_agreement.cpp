/* SPDX-License-Identifier: GPL-2.0-only */
// A machine's file and the kinematics module that motmod calls: compared at 20 poses before motion begins, one in a period.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "posemath.h"
extern "C" {
#include "kinematics.h"
}
#include "forbidden_calls.hpp"
#include "motmod.hpp"
#include "planning.h"

extern "C" {
#include "state.h"
extern void* rtapi_info_address_machine;
}

namespace {

int calls = 0;
bool refuses = false;  ///< the module has no joints for the last of the poses
constexpr std::array<double, 5> travel{600, 500, 500, 120,
                                       36000};  ///< of the file's axes from 0, each way, mm or degrees
std::array<double, 5> least{}, greatest{};      ///< of the poses' joints
double difference = 0;  ///< mm, of the module's joint 1 from the file's at the last of the poses

/// A trunnion of the file's, whose kinematics are those of the module.
class OfTwoRotaryAxes : public testing::Test {
 protected:
  void SetUp() override {
    *static_cast<char**>(rtapi_info_address_machine) = file.data();
    calls = 0;
    difference = 0;
    refuses = false;
    least = greatest = {};
  }
  void TearDown() override { *static_cast<char**>(rtapi_info_address_machine) = nullptr; }

 private:
  std::string file = LEADSCREW_TP_MACHINE;
};

TEST(ForbiddenCalls, CountEachFunction) {
  EXPECT_TRUE(leadscrew::testing_support::counts_each_function());
}

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

TEST_F(OfTwoRotaryAxes, PosesAreSpreadOverTheTravelOfTheFile) {
  Motmod motmod;
  EXPECT_EQ(motmod.line(5, 0), TP_ERR_OK);
  EXPECT_TRUE(motmod.ends());
  for (std::size_t joint = 0; joint < travel.size(); ++joint) {
    EXPECT_GE(least[joint], -travel[joint] - 1e-9) << joint;
    EXPECT_LE(least[joint], -0.75 * travel[joint]) << joint;
    EXPECT_GE(greatest[joint], 0.75 * travel[joint]) << joint;
    EXPECT_LE(greatest[joint], travel[joint] + 1e-9) << joint;
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

TEST_F(OfTwoRotaryAxes, WhatTheModuleRefusesIsToldAndNothingMoves) {
  Motmod motmod;
  refuses = true;
  EXPECT_EQ(motmod.line(5, 0), TP_ERR_OK);
  testing::internal::CaptureStdout();
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.functions.tpIsDone(&motmod.tp) != 0; }));
  const std::string told = testing::internal::GetCapturedStdout();
  EXPECT_NE(told.find("kinematics module has no joints for X"), std::string::npos) << told;
  EXPECT_TRUE(motmod.status.motionFlag & EMCMOT_MOTION_ERROR_BIT);
  EXPECT_EQ(motmod.difference(1), 0);
}

}  // namespace

extern "C" int kinematicsInverse(const EmcPose* pose, double* joints, const KINEMATICS_INVERSE_FLAGS*,
                                 KINEMATICS_FORWARD_FLAGS*) {
  double place[leadscrew_tp_axes], axes[leadscrew_tp_axes];
  position_of(pose, place);
  leadscrew_tp_axes_of(leadscrew_state.planning, place, 0, axes);
  std::size_t joint = 0;
  for (const int axis : {0, 1, 2, 3, 5}) {
    least[joint] = std::min(least[joint], axes[axis]);
    greatest[joint] = std::max(greatest[joint], axes[axis]);
    joints[joint++] = axes[axis];
  }
  const bool is_last = ++calls == 20;
  if (is_last) joints[1] += difference;
  return is_last && refuses ? -1 : 0;
}
