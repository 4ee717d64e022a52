/* SPDX-License-Identifier: GPL-2.0-only */
// Each function that motmod calls, by what it is for: a test of its name, which fails where the function does nothing.
#include <gtest/gtest.h>

#include "motmod.hpp"

namespace {

/// Along the way, from corner to corner.
void corner(Motmod& motmod) {
  motmod.line(20, 0);
  motmod.line(20, 20);
}

/// The shortest distance of any word to the corner, mm.
double from_corner(const Motmod& motmod) {
  double least = 1e9;
  for (const auto& place : motmod.places) least = std::fmin(least, std::hypot(place[0] - 20, place[1]));
  return least;
}

TEST(Functions, tpMotFunctions) {
  Motmod motmod;
  motmod.line(50, 0, 0, 300);
  EXPECT_TRUE(motmod.ends());
  EXPECT_NEAR(motmod.pose.tran.x, 50, 1e-9);
  EXPECT_LE(motmod.difference(1), 200 * 1.001);
  EXPECT_LE(motmod.difference(2), 1000 * 1.001);
  EXPECT_LE(motmod.difference(3), 20000 * 1.001);
}

TEST(Functions, tpMotData) {
  Motmod motmod;
  motmod.line(50, 0);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.status.current_vel > 99; }));
  EXPECT_GT(motmod.status.distance_to_go, 1);
  motmod.status.net_feed_scale = 2;  // more than config allows
  EXPECT_TRUE(motmod.ends());
  EXPECT_LE(motmod.difference(1), 150 * 1.001);
  EXPECT_GT(motmod.difference(1), 120);
}

TEST(Functions, tpCreate) {
  Motmod motmod;
  motmod.tp.done = 0;
  motmod.tp.nextId = 7;
  EXPECT_EQ(motmod.functions.tpCreate(&motmod.tp, 32, 0), TP_ERR_OK);
  EXPECT_EQ(motmod.tp.done, 1);
  EXPECT_EQ(motmod.tp.nextId, 0);
  EXPECT_EQ(motmod.functions.tpCreate(nullptr, 32, 0), TP_ERR_FAIL);
}

TEST(Functions, tpClear) {
  Motmod motmod;
  corner(motmod);
  EXPECT_EQ(motmod.tp.done, 0);
  EXPECT_EQ(motmod.functions.tpClear(&motmod.tp), TP_ERR_OK);
  EXPECT_EQ(motmod.tp.done, 1);
  EXPECT_EQ(motmod.tp.depth, 0);
  EXPECT_TRUE(motmod.status.motionFlag & EMCMOT_MOTION_INPOS_BIT);
  for (int n = 0; n < 300; ++n) motmod.cycle();
  EXPECT_EQ(motmod.pose.tran.x, 0);
}

TEST(Functions, tpSetCycleTime) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpSetCycleTime(&motmod.tp, 0), TP_ERR_FAIL);
  EXPECT_EQ(motmod.functions.tpSetCycleTime(&motmod.tp, 0.002), TP_ERR_OK);
  motmod.seconds = 0.002;
  motmod.functions.tpClear(&motmod.tp);
  motmod.line(20, 0, 0, 50);
  EXPECT_TRUE(motmod.ends());
  EXPECT_NEAR(motmod.difference(1), 50, 0.1);
}

TEST(Functions, tpSetVmax) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpSetVmax(&motmod.tp, 120, 180), TP_ERR_OK);
  EXPECT_EQ(motmod.tp.vMax, 120);
  EXPECT_EQ(motmod.tp.ini_maxvel, 180);
  EXPECT_EQ(motmod.functions.tpSetVmax(&motmod.tp, -1, 180), TP_ERR_FAIL);
}

TEST(Functions, tpSetVlimit) {
  Motmod motmod;
  motmod.line(60, 0);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() > 90; }));
  EXPECT_EQ(motmod.functions.tpSetVlimit(&motmod.tp, 30), TP_ERR_OK);
  EXPECT_TRUE(motmod.cycle_until([&] { return std::fabs(motmod.speed() - 30) < 0.01; }));
  motmod.functions.tpSetVlimit(&motmod.tp, 0);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() == 0; }));
  for (int n = 0; n < 200; ++n) motmod.cycle();
  EXPECT_EQ(motmod.functions.tpIsDone(&motmod.tp), 0);
  motmod.functions.tpSetVlimit(&motmod.tp, 400);
  EXPECT_TRUE(motmod.ends());
}

TEST(Functions, tpSetAmax) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpSetAmax(&motmod.tp, 700), TP_ERR_OK);
  EXPECT_EQ(motmod.tp.aMax, 700);
  EXPECT_EQ(motmod.functions.tpSetAmax(&motmod.tp, 0), TP_ERR_FAIL);
}

TEST(Functions, tpSetId) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpSetId(&motmod.tp, 40), TP_ERR_OK);
  motmod.line(5, 0);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.tp.execId == 40; }));
}

TEST(Functions, tpGetExecId) {
  Motmod motmod;
  motmod.functions.tpSetId(&motmod.tp, 12);
  corner(motmod);
  std::vector<int> ids;
  EXPECT_TRUE(motmod.cycle_until([&] {
    const int id = motmod.functions.tpGetExecId(&motmod.tp);
    if (ids.empty() || ids.back() != id) ids.push_back(id);
    return motmod.tp.done != 0;
  }));
  EXPECT_EQ(ids, (std::vector<int>{0, 12, 13, 0}));
}

TEST(Functions, tpGetExecTag) {
  Motmod motmod;
  motmod.tag.fields[0] = 77;
  motmod.line(5, 0);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.functions.tpGetExecTag(&motmod.tp).fields[0] == 77; }));
}

TEST(Functions, tpSetTermCond) {
  for (const auto& [condition, tolerance] : {std::pair{TC_TERM_COND_STOP, 0.0}, {TC_TERM_COND_PARABOLIC, 0.5}}) {
    Motmod motmod;
    EXPECT_EQ(motmod.functions.tpSetTermCond(&motmod.tp, condition, tolerance), TP_ERR_OK);
    corner(motmod);
    EXPECT_TRUE(motmod.ends());
    EXPECT_LE(from_corner(motmod), tolerance + 1e-6);
    EXPECT_GE(from_corner(motmod), 0.3 * tolerance);
  }
}

TEST(Functions, tpSetPos) {
  Motmod motmod;
  EmcPose there{};
  there.tran = {5, 6, 7};
  EXPECT_EQ(motmod.functions.tpSetPos(&motmod.tp, &there), TP_ERR_OK);
  motmod.cycle();
  EXPECT_EQ(motmod.pose.tran.z, 7);
  motmod.line(8, 6, 7);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.places.front()[0], 5);
  EXPECT_EQ(motmod.pose.tran.y, 6);
  there.tran.x = NAN;
  EXPECT_EQ(motmod.functions.tpSetPos(&motmod.tp, &there), TP_ERR_FAIL);
}

TEST(Functions, tpRunCycle) {
  Motmod motmod;
  corner(motmod);
  motmod.line(0, 0);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.places.back(), (std::array<double, 3>{0, 0, 0}));
  EXPECT_LT(from_corner(motmod), 0.02);
}

TEST(Functions, tpPause) {
  Motmod motmod;
  motmod.line(400, 0);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() > 50; }));
  EXPECT_EQ(motmod.functions.tpPause(&motmod.tp), TP_ERR_OK);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() == 0; }));
  // Neither where motion that is planned ends nor for a time.
  EXPECT_EQ(motmod.functions.tpIsDone(&motmod.tp), 0);
  const double held = motmod.pose.tran.x;
  EXPECT_LT(held, 200);
  for (int n = 0; n < 500; ++n) motmod.cycle();
  EXPECT_EQ(motmod.pose.tran.x, held);
}

TEST(Functions, tpResume) {
  Motmod motmod;
  corner(motmod);
  motmod.functions.tpPause(&motmod.tp);
  for (int n = 0; n < 300; ++n) motmod.cycle();
  EXPECT_EQ(motmod.pose.tran.x, 0);
  EXPECT_EQ(motmod.functions.tpResume(&motmod.tp), TP_ERR_OK);
  EXPECT_TRUE(motmod.ends());
}

TEST(Functions, tpAbort) {
  Motmod motmod;
  corner(motmod);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() > 50; }));
  EXPECT_EQ(motmod.functions.tpAbort(&motmod.tp), TP_ERR_OK);
  // A move that came now would be lost: it is told to wait, and refused if it does not.
  EXPECT_TRUE(motmod.functions.tcqFull(&motmod.tp.queue));
  EXPECT_EQ(motmod.line(7, 7), TP_ERR_FAIL);
  // However long planning takes, motion that is handed over is over soon.
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.functions.tpIsDone(&motmod.tp) != 0; }, 1000));
  EXPECT_LT(motmod.pose.tran.y, 19);
  EXPECT_EQ(motmod.tp.aborting, 0);
  EXPECT_FALSE(motmod.functions.tcqFull(&motmod.tp.queue));
  EXPECT_LE(motmod.difference(3), 20000 * 1.001);
}

TEST(Functions, tpAddLine) {
  Motmod motmod;
  EXPECT_EQ(motmod.line(3, 4, 5), TP_ERR_OK);
  EXPECT_EQ(motmod.line(3, 4, 5), TP_ERR_ZERO_LENGTH);
  EXPECT_EQ(motmod.line(NAN, 4, 5), TP_ERR_FAIL);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.places.back(), (std::array<double, 3>{3, 4, 5}));
  // Of a locking indexer: unlocked for it, locked behind it.
  EmcPose end = motmod.pose;
  end.a = 30;
  EXPECT_EQ(motmod.functions.tpAddLine(&motmod.tp, end, EMC_MOTION_TYPE_INDEXROTARY, 50, 90, 500, 0, 0, 2, {}),
            TP_ERR_OK);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.joints_unlocked == 4; }));
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.joints_unlocked, 0);
  EXPECT_EQ(motmod.pose.a, 30);
}

TEST(Functions, tpAddCircle) {
  Motmod motmod;
  EXPECT_EQ(motmod.circle(10), TP_ERR_OK);
  EXPECT_EQ(motmod.circle(10, {0, 0.6, 0.8}), TP_ERR_GEOM);
  EXPECT_TRUE(motmod.ends());
  double furthest = 0;
  for (const auto& place : motmod.places) {
    furthest = std::fmax(furthest, place[0]);
    EXPECT_NEAR(std::hypot(place[0] - 10, place[1]), 10, 1e-6);
  }
  EXPECT_NEAR(furthest, 20, 0.01);
}

TEST(Functions, tpAddRigidTap) {
  Motmod motmod;
  motmod.status.spindle_status[0].speed = 600;
  for (int n = 0; n < 1000; ++n) motmod.cycle();
  motmod.places.clear();
  motmod.functions.tpSetSpindleSync(&motmod.tp, 0, 1, 0);
  EmcPose end{};
  end.tran.z = -10;
  EXPECT_EQ(motmod.functions.tpAddRigidTap(&motmod.tp, end, 100, 400, 1000, 0, 1, {}), TP_ERR_OK);
  end.tran.z = NAN;
  EXPECT_EQ(motmod.functions.tpAddRigidTap(&motmod.tp, end, 100, 400, 1000, 0, 1, {}), TP_ERR_FAIL);
  double deepest = 0;
  EXPECT_TRUE(motmod.cycle_until([&] {
    deepest = std::fmin(deepest, motmod.pose.tran.z);
    return motmod.tp.done != 0;
  }));
  EXPECT_LT(deepest, -10);
  EXPECT_EQ(motmod.pose.tran.z, 0);
  EXPECT_EQ(motmod.status.spindle_status[0].speed, 600);  // turned back, and on again
  EXPECT_LE(motmod.difference(3), 20000 * 1.001);
}

TEST(Functions, tpGetPos) {
  Motmod motmod;
  motmod.line(4, 0);
  EXPECT_TRUE(motmod.ends());
  EmcPose pose{};
  EXPECT_EQ(motmod.functions.tpGetPos(&motmod.tp, &pose), TP_ERR_OK);
  EXPECT_EQ(pose.tran.x, 4);
  EXPECT_EQ(motmod.functions.tpGetPos(nullptr, &pose), TP_ERR_FAIL);
}

TEST(Functions, tpIsDone) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpIsDone(&motmod.tp), 1);
  motmod.line(4, 0);
  EXPECT_EQ(motmod.functions.tpIsDone(&motmod.tp), 0);
  EXPECT_TRUE(motmod.ends());
}

TEST(Functions, tpQueueDepth) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpQueueDepth(&motmod.tp), 0);
  corner(motmod);
  EXPECT_EQ(motmod.functions.tpQueueDepth(&motmod.tp), 2);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.pose.tran.y > 5; }));
  EXPECT_EQ(motmod.functions.tpQueueDepth(&motmod.tp), 1);
}

TEST(Functions, tpActiveDepth) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpActiveDepth(&motmod.tp), 0);
  corner(motmod);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() > 0; }));
  EXPECT_EQ(motmod.functions.tpActiveDepth(&motmod.tp), 1);
}

TEST(Functions, tpGetMotionType) {
  Motmod motmod;
  motmod.circle(10);
  EXPECT_TRUE(motmod.cycle_until([&] { return motmod.speed() > 0; }));
  EXPECT_EQ(motmod.functions.tpGetMotionType(&motmod.tp), EMC_MOTION_TYPE_ARC);
}

TEST(Functions, tpSetSpindleSync) {
  Motmod motmod;
  motmod.status.spindle_status[0].speed = 600;
  for (int n = 0; n < 1000; ++n) motmod.cycle();
  EXPECT_EQ(motmod.functions.tpSetSpindleSync(&motmod.tp, 0, 1.5, 0), TP_ERR_OK);
  // Its lead is along X, Y and Z.
  EmcPose turned{};
  turned.a = 10;
  EXPECT_EQ(motmod.functions.tpAddLine(&motmod.tp, turned, EMC_MOTION_TYPE_FEED, 100, 400, 1000, 0, 0, -1, {}),
            TP_ERR_FAIL);
  EXPECT_EQ(motmod.line(0, 0, -30), TP_ERR_OK);
  double worst = 0;
  EXPECT_TRUE(motmod.cycle_until([&] {
    const double z = motmod.pose.tran.z, turns = motmod.status.spindle_status[0].spindleRevs;
    // Positions are those of the period's end.
    if (z < -8 && z > -25) worst = std::fmax(worst, std::fabs(z + 1.5 * (turns + 0.01)));
    return motmod.tp.done != 0;
  }));
  EXPECT_EQ(motmod.pose.tran.z, -30);
  EXPECT_LT(worst, 0.01);
  // By its speed: 10 turns a second, 0.5 mm each.
  motmod.functions.tpSetSpindleSync(&motmod.tp, 0, 0.5, 1);
  motmod.places.clear();
  motmod.line(0, 0, -27);
  EXPECT_TRUE(motmod.ends());
  EXPECT_NEAR(motmod.difference(1), 5, 0.01);
}

TEST(Functions, tpSetAout) {
  Motmod motmod;
  motmod.functions.tpSetAout(&motmod.tp, 1, 2.5, 2.5);
  motmod.line(3, 0);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.analog, (std::vector<std::pair<int, double>>{{1, 2.5}}));
  EXPECT_EQ(motmod.functions.tpSetAout(&motmod.tp, EMCMOT_MAX_AIO, 1, 1), TP_ERR_FAIL);
}

TEST(Functions, tpSetDout) {
  Motmod motmod;
  motmod.functions.tpSetDout(&motmod.tp, 2, 1, 1);
  motmod.line(3, 0);
  motmod.functions.tpSetDout(&motmod.tp, 2, 0, 0);
  motmod.line(3, 3);
  EXPECT_TRUE(motmod.cycle_until([&] { return !motmod.digital.empty(); }));
  EXPECT_LT(motmod.pose.tran.x, 0.1);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.digital, (std::vector<std::pair<int, int>>{{2, 1}, {2, 0}}));
  // Forgotten where it is cleared before a move.
  motmod.functions.tpSetDout(&motmod.tp, 3, 1, 1);
  tpClearDIOs(&motmod.tp);
  motmod.line(0, 0);
  EXPECT_TRUE(motmod.ends());
  EXPECT_EQ(motmod.digital.size(), 2U);
}

TEST(Functions, tpSetRunDir) {
  Motmod motmod;
  EXPECT_EQ(motmod.functions.tpSetRunDir(&motmod.tp, TC_DIR_FORWARD), TP_ERR_OK);
  EXPECT_EQ(motmod.functions.tpSetRunDir(&motmod.tp, TC_DIR_REVERSE), TP_ERR_FAIL);
}

TEST(Pins, LimitJerkOfMotionThatBeginsFromThenOn) {
  Motmod motmod;
  EXPECT_EQ(*motmod.pins.at("leadscrew-tp.y-jerk"), 20000);
  *motmod.pins.at("leadscrew-tp.x-jerk") = 5000;
  motmod.line(20, 0);
  EXPECT_TRUE(motmod.ends());
  EXPECT_LE(motmod.difference(3), 5000 * 1.001);
  EXPECT_GE(motmod.difference(3), 5000 * 0.95);
  *motmod.pins.at("leadscrew-tp.x-jerk") = 0;  // none: the parameter's
  motmod.line(0, 0);
  EXPECT_TRUE(motmod.ends());
  EXPECT_GE(motmod.difference(3), 20000 * 0.95);
}

TEST(Functions, tcqFull) {
  Motmod motmod;
  motmod.functions.tpPause(&motmod.tp);
  int moves = 0;
  while (!motmod.functions.tcqFull(&motmod.tp.queue) && moves < 10000) {
    ASSERT_EQ(motmod.line(++moves, 0), TP_ERR_OK);
    if (moves % 200 == 0) motmod.cycle();
  }
  EXPECT_GT(moves, 1000);
  EXPECT_LT(moves, 4096);
}

}  // namespace
