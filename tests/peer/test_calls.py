"""What calls.difference() finds, and what it takes for the same."""
import calls
import readers

HEAD = """    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)
    2 N..... SET_G5X_OFFSET(1, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)
    3 N..... SET_FEED_RATE(100.0000)
"""


CURVE = "NURBS_FEED(3, ...)"


def text(*lines):
    return HEAD + "".join(f"  {i + 4:3} N1009870{line}\n" for i, line in enumerate(lines))


def found(ours, theirs):
    return calls.difference(calls.motions(text(*ours)), calls.motions(text(*theirs)))[0]


def line(x, y, z, name="STRAIGHT_TRAVERSE", a=0):
    return f"{name}({x:.4f}, {y:.4f}, {z:.4f}, {a:.4f}, 0.0000, 0.0000)"


def offset(x):
    return f"SET_G92_OFFSET({x:.4f}, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)"


def arc(x=10, cx=5, turns=-1, cy=0):
    return f"ARC_FEED({x:.4f}, 0.0000, {cx:.4f}, {cy:.4f}, {turns}, 0.0000, 0.0000, 0.0000, 0.0000)"


SAME = [
    ([line(1, 2, 3)], [line(1, 2, 3)]),
    ([line(1, 2, 3)], [line(1.0001, 2, 3)]),
    ([line(1, 0, 0)], [line(1, 0, 0), line(1, 0, 0)]),  # leads nowhere
    ([line(1, 0, 0), offset(1), line(2, 0, 0)], [line(1, 0, 0), offset(1), line(0, 0, 0), line(2, 0, 0)]),
    ([line(1, 0, 0)], ["SET_FEED_RATE(7.0000)", line(1, 0, 0)]),  # rapids have no feed
    ([line(0, 0, 5), line(4, 0, 5)], [line(4, 0, 5)]),  # a hole reached another way
    ([arc()], [arc()]),
    ([CURVE, line(1, 0, 0)], [CURVE, line(4, 5, 0), line(1, 0, 0)]),  # where the curve ended
    ([CURVE], [CURVE, line(4, 5, 0)]),
    ([arc(10, 5.001)], [arc(10, 5.0015)]),  # a centre that is off
]
OTHER = [
    ([line(1, 2, 3)], [line(1.0002, 2, 3)]),
    ([line(1, 2, 3)], [line(1, 2, 3, a=1)]),
    ([line(1, 2, 3)], [line(1, 2, 3, "STRAIGHT_FEED")]),
    ([line(1, 2, 3)], [line(1, 2, 3), line(1, 2, 4)]),
    ([offset(1), line(1, 2, 3)], [offset(1.1), line(1, 2, 3)]),
    ([line(1, 2, 3, "STRAIGHT_FEED")], ["SET_FEED_RATE(101.0000)", line(1, 2, 3, "STRAIGHT_FEED")]),
    (["SET_XY_ROTATION(1.0000)", line(1, 2, 3)], [line(1, 2, 3)]),
    (["USE_LENGTH_UNITS(CANON_UNITS_INCHES)", line(1, 2, 3)], [line(1, 2, 3)]),
    (["DWELL(1.0000)"], ["DWELL(1.1000)"]),
    ([CURVE, line(1, 0, 0)], [CURVE, line(1, 0, 1)]),
    ([CURVE, line(1, 0, 0)], [CURVE]),
    ([CURVE], [CURVE, line(4, 5, 0), line(4, 6, 0)]),
    ([arc()], [arc(turns=1)]),
    ([arc()], [arc(cy=0.0005)]),
]


def main():
    for ours, theirs in SAME:
        assert found(ours, theirs) is None, (ours, theirs, found(ours, theirs))
    for ours, theirs in OTHER:
        assert found(ours, theirs), (ours, theirs)
    accepted, refused = readers.Outcome(True, text()), readers.Outcome(False, text(), "why", "G1 X")
    assert readers.difference(accepted, accepted)[0] is None
    assert readers.difference(accepted, refused)[0] and readers.difference(refused, accepted)[0]
    assert readers.difference(refused, readers.Outcome(False, text(), "why", "G1 Y"))[0]
    assert readers.difference(refused, readers.Outcome(False, text(), "why", "g1x"))[0] is None


if __name__ == "__main__":
    main()
