"""Canonical machining calls, as `rs274 -g` and `leadscrew canon` print them, and whether two lists of them do the same."""
import math
import re

CALL = re.compile(r"^\s*\d+ N[\d.]*\s*([A-Z_0-9.]+)\((.*)\)\s*$")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*(?:e[-+]?\d+)?|nan|inf)")
STRAIGHT = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE")
EVENTS = ("SELECT_TOOL", "CHANGE_TOOL", "SET_SPINDLE_SPEED", "START_SPINDLE_CLOCKWISE", "START_SPINDLE_COUNTERCLOCKWISE",
          "STOP_SPINDLE_TURNING", "ORIENT_SPINDLE", "MIST_ON", "MIST_OFF", "FLOOD_ON", "FLOOD_OFF", "PROGRAM_STOP",
          "OPTIONAL_PROGRAM_STOP", "PALLET_SHUTTLE", "SET_MOTION_OUTPUT_BIT", "CLEAR_MOTION_OUTPUT_BIT",
          "START_SPEED_FEED_SYNC", "STOP_SPEED_FEED_SYNCH", "RIGID_TAP",
          "SET_AUX_OUTPUT_BIT", "CLEAR_AUX_OUTPUT_BIT", "SET_MOTION_OUTPUT_VALUE", "SET_AUX_OUTPUT_VALUE",
          "SPINDLE.0.WAIT_ORIENT_COMPLETE", "ENABLE_FEED_OVERRIDE", "DISABLE_FEED_OVERRIDE", "ENABLE_SPEED_OVERRIDE",
          "DISABLE_SPEED_OVERRIDE", "ENABLE_ADAPTIVE_FEED", "DISABLE_ADAPTIVE_FEED", "ENABLE_FEED_HOLD", "DISABLE_FEED_HOLD")
WAITING = ("DWELL", "NURBS_FEED") + EVENTS
ROUNDING = 0.505e-4  # of a printed number, in its unit
LEAST_RATE = 0.1  # that rs274 makes of G93, units per minute
PLANES = {"CANON_PLANE_XY": (0, 1, 2), "CANON_PLANE_XZ": (2, 0, 1), "CANON_PLANE_YZ": (1, 2, 0)}


class Told:
    """Numbers as they were printed, in mm or degrees, and how exactly."""

    def __init__(self, values, unit, linear=(0, 1, 2, 6, 7, 8)):
        self.values = [value * unit if i in linear else value for i, value in enumerate(values)]
        self.rounding = ROUNDING * unit

    def __getitem__(self, i):
        return self.values[i] if i < len(self.values) else 0.0

    def agrees(self, other):
        slack = self.rounding + other.rounding
        return all(abs(self[i] - other[i]) <= slack for i in range(max(len(self.values), len(other.values))))


class Frame:
    """From coordinates of the program to those of the machine: R(program + shift) + origin + tool."""

    def __init__(self):
        self.origin, self.shift, self.tool = Told([0] * 6, 1), Told([0] * 6, 1), Told([0] * 9, 1)
        self.rotation = 0.0

    def copy(self):
        other = Frame()
        other.__dict__.update(self.__dict__)
        return other

    def turned(self, x, y, sign):
        sine, cosine = math.sin(math.radians(sign * self.rotation)), math.cos(math.radians(sign * self.rotation))
        return cosine * x - sine * y, sine * x + cosine * y

    def to_machine(self, program):
        p = [value + self.shift[i] for i, value in enumerate(program)]
        p[0], p[1] = self.turned(p[0], p[1], 1)
        return [value + self.origin[i] + self.tool[i] for i, value in enumerate(p)]

    def to_program(self, machine):
        p = [value - self.origin[i] - self.tool[i] for i, value in enumerate(machine)]
        p[0], p[1] = self.turned(p[0], p[1], -1)
        return [value - self.shift[i] for i, value in enumerate(p)]

    def difference(self, other):
        for name in ("origin", "shift", "tool"):
            mine, its = getattr(self, name), getattr(other, name)
            if not mine.agrees(its):
                return f"{name} {its.values} {mine.values}"
        if abs(self.rotation - other.rotation) > 2 * ROUNDING:
            return f"rotation {other.rotation} {self.rotation}"
        return None


class Motion:
    """One call that moves or waits, with what held for it."""

    def __init__(self, name, text, numbers, unit, frame, feed, start):
        self.name, self.text, self.numbers, self.unit, self.frame = name, text, numbers, unit, frame
        # The feed, its unit and SET_FEED_MODE's number; start: coordinates of the program, in its unit.
        self.feed, self.start = feed, start
        self.rotary = False
        self.in_step = False  # with the spindle: its feed is not F
        self.behind_curve = False  # whose end is not printed: where this begins is not known

    def difference(self, other):
        """From what the other reader, leadscrew, makes of the same block."""
        if self.name != other.name or len(self.numbers) != len(other.numbers):
            return "another call"
        if self.name in WAITING:
            return self.numbers_differ(other, 0)
        if self.unit != other.unit:
            return "another unit"
        found = self.numbers_differ(other, self.slack_of_center())
        if found:
            return found
        if self.name != "STRAIGHT_TRAVERSE" and not self.in_step:
            mine, its = ((m.feed[0] if m.rotary else m.feed[0] * m.feed[1] / m.unit) for m in (self, other))
            if self.feed[2] != other.feed[2]:
                return "another feed mode"
            if mine == LEAST_RATE > its:
                its = mine
            if abs(mine - its) > max(3 * ROUNDING, 1e-5 * abs(mine)):
                return f"feed {its} {mine}"
        return self.frame.difference(other.frame)

    def numbers_differ(self, other, slack_of_center):
        for i, (mine, its) in enumerate(zip(self.numbers, other.numbers)):
            slack = 2 * ROUNDING + (slack_of_center if self.name == "ARC_FEED" and i in (2, 3) else 0)
            if not abs(mine - its) <= slack:
                return f"number {i + 1}: {its} {mine}"
        return None

    def slack_of_center(self):
        """A centre that is not as far from both ends is moved to their perpendicular bisector: by |r1² − r2²|/2d."""
        if self.name != "ARC_FEED":
            return 0
        end, center = self.numbers[0:2], self.numbers[2:4]
        first, last, chord = math.dist(self.start, center), math.dist(end, center), math.dist(self.start, end)
        off = abs(first - last) + 2 * ROUNDING
        return off * max(1, (first + last) / (2 * chord)) if chord > 4 * ROUNDING else off


def motions(text):
    """The calls that move, wait, or ask for what is no motion, but for straight ones that lead nowhere."""
    found, frame, unit, feed, plane = [], Frame(), 1.0, (0.0, 1.0, 0), PLANES["CANON_PLANE_XY"]
    threads, before = False, ""
    in_step = False
    most_speed, surface_speed = [0.0, 0.0], None  # of G96
    overrides = {"FEED_OVERRIDE": True, "SPEED_OVERRIDE": True}  # whether they are enabled
    position, told_in = [0.0] * 9, 1.0  # machine, mm and degrees, from numbers in this unit
    behind_curve = False
    for line in text.splitlines():
        call = CALL.match(line)
        if not call:
            continue
        name, arguments = call.groups()
        if name == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCHES" in arguments else 1.0
            continue
        if name == "SELECT_PLANE":
            plane = PLANES[arguments]
            continue
        if name in ("COMMENT", "MESSAGE"):
            continue
        numbers = [float(number) for number in NUMBER.findall(arguments)]
        if name in ("SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION", "USE_TOOL_LENGTH_OFFSET"):
            frame = frame.copy()
        if name == "SET_G5X_OFFSET":
            frame.origin = Told(numbers[1:], unit)
        elif name == "SET_G92_OFFSET":
            frame.shift = Told(numbers, unit)
        elif name == "SET_XY_ROTATION":
            frame.rotation = numbers[0]
        elif name == "USE_TOOL_LENGTH_OFFSET":
            frame.tool = Told(numbers, unit)
        elif name == "SET_FEED_RATE":
            feed = (numbers[0], unit, feed[2])
        elif name == "ENABLE_FEED_OVERRIDE" and threads:
            threads = False
        elif name == "SET_FEED_MODE":
            feed = (0.0, unit, numbers[1])
        elif name == "SET_SPINDLE_MODE":
            most_speed = numbers
        elif name == "SET_SPINDLE_SPEED" and most_speed[1] > 0:
            # Said again it changes nothing; the limit is a part of it.
            if surface_speed != numbers + most_speed:
                found.append(Motion(name, line, numbers + most_speed, unit, frame, feed, None))
            surface_speed = numbers + most_speed
        elif name == "DWELL" and numbers[0] == 0:
            continue  # no time
        elif name in WAITING:
            # Threads are cut without; the calls around them are not the program's.
            if name == "START_SPEED_FEED_SYNC" and before == "DISABLE_FEED_OVERRIDE":
                threads = True
                if found and found[-1].name == before:
                    found.pop()
                    overrides["FEED_OVERRIDE"] = True
            before = name
            enabled, _, what = name.partition("ABLE_")
            if enabled in ("EN", "DIS"):
                if overrides.get(what) == (enabled == "EN"):
                    continue  # what is so already
                overrides[what] = enabled == "EN"
            in_step = name == "START_SPEED_FEED_SYNC" or (in_step and name != "STOP_SPEED_FEED_SYNCH")
            behind_curve = behind_curve or name == "NURBS_FEED"
            found.append(Motion(name, line, numbers, unit, frame, feed, None))
        elif name in STRAIGHT or name == "ARC_FEED":
            program = frame.to_program(position)
            ends = numbers
            if name == "ARC_FEED":
                ends = [0.0] * 3 + numbers[6:]
                for axis, value in zip(plane, (numbers[0], numbers[1], numbers[5])):
                    ends[axis] = value
            target = frame.to_machine(Told(ends, unit).values)
            start = [program[plane[0]] / unit, program[plane[1]] / unit]
            motion = Motion(name, line, numbers, unit, frame, feed, start)
            steps = [abs(a - b) for a, b in zip(target, position)]
            least = 3 * ROUNDING * (unit + told_in)
            motion.in_step = in_step
            motion.behind_curve, behind_curve = behind_curve and name in STRAIGHT, False
            motion.rotary = max(steps[:3]) <= least and name != "ARC_FEED" and not motion.behind_curve
            if name not in STRAIGHT or motion.behind_curve or max(steps[:3]) > least or max(steps[3:6]) > 4 * ROUNDING:
                found.append(motion)
                position[:len(target)], told_in = target, unit
    # The end of a program stops what turns and flows, allows overrides, and M30 changes the pallet.
    while found and found[-1].name in ("STOP_SPINDLE_TURNING", "MIST_OFF", "FLOOD_OFF", "PALLET_SHUTTLE", "ENABLE_FEED_OVERRIDE"):
        found.pop()
    return found


def is_rapid(motions, i):
    return i < len(motions) and motions[i].name == "STRAIGHT_TRAVERSE"


def other_way(ours, i, theirs, j):
    """How many rapids of either meet where one leads another way there; None where they do not meet.

    NIST IR 6556, 3.5.16: a cycle begins with the axis of the hole at R or above, is then at the hole, and then at R. rs274
    goes by the level at which the series began: to a hole below R in one slanted rapid, or down to R before it is there.
    Behind a change of units or offsets it retracts to the number of that level, where G98 asks for the place.
    """
    for mine, its in ((2, 1), (2, 2), (1, 2), (3, 2), (2, 3), (3, 3), (1, 3), (3, 1)):
        if not all(is_rapid(ours, i + k) for k in range(mine)) or not all(is_rapid(theirs, j + k) for k in range(its)):
            continue
        if theirs[j + its - 1].difference(ours[i + mine - 1]) is None:
            return mine, its
    return None


def leads_nowhere(motion):
    """Round a corner of cutter compensation that only rounding makes, no farther than is printed."""
    return motion.name == "ARC_FEED" and math.dist(motion.numbers[0:2], motion.start) <= 2 * ROUNDING


def difference(ours, theirs, whole=True):
    """Where two lists of motions part, in words, and how often rapids before a hole lead another way there.

    A straight call behind a curve that ours does not have leads nowhere: to where the curve ended, which is not printed.
    """
    i = j = ways = 0
    while i < len(ours) and j < len(theirs):
        found = theirs[j].difference(ours[i])
        steps = other_way(ours, i, theirs, j) if found else (1, 1)
        if steps is None and theirs[j].behind_curve:
            j += 1
            continue
        if steps is None and leads_nowhere(ours[i]):
            i += 1
            continue
        if steps is None:
            return f"motion {i + 1}: {found}\n  ours   {ours[i].text}\n  theirs {theirs[j].text}", ways
        i, j, ways = i + steps[0], j + steps[1], ways + bool(found)
    while j < len(theirs) and theirs[j].behind_curve:
        j += 1
    if whole and (i < len(ours) or j < len(theirs)):
        rest = ours[i] if i < len(ours) else theirs[j]
        return f"{len(ours)} motions, theirs {len(theirs)}; one goes on:\n  {rest.text}", ways
    return None, ways
