"""Contours of lines and arcs for cutter compensation, and how near to one a path comes."""
import math


class Piece:
    """A line or an arc in the plane. run: pieces of one run have no move without motion in the plane between them."""

    def __init__(self, start, end, center=None, turn=0, levels=(0, 0), run=0):
        self.start, self.end, self.center, self.turn, self.levels, self.run = start, end, center, turn, levels, run
        self.radius = math.dist(start, center) if turn else 0
        self.begins = self.angle(start) if turn else 0
        self.sweep = self.angle_to(end) or 2 * math.pi if turn else 0

    def angle(self, point):
        return math.atan2(point[1] - self.center[1], point[0] - self.center[0])

    def angle_to(self, point):
        """By which the arc turns from its start to there, 0 to 2π."""
        return self.turn * (self.angle(point) - self.begins) % (2 * math.pi)

    def length(self):
        return self.radius * self.sweep if self.turn else math.dist(self.start, self.end)

    def at(self, part):
        if not self.turn:
            return [a + part * (b - a) for a, b in zip(self.start, self.end)]
        angle = self.begins + self.turn * part * self.sweep
        return [self.center[0] + self.radius * math.cos(angle), self.center[1] + self.radius * math.sin(angle)]

    def distance(self, point):
        to_ends = min(math.dist(point, self.start), math.dist(point, self.end))
        if self.turn:
            inside = self.angle_to(point) <= self.sweep
            return abs(math.dist(point, self.center) - self.radius) if inside else to_ends
        along = [b - a for a, b in zip(self.start, self.end)]
        length = math.hypot(*along)
        part = sum((p - a) * d for p, a, d in zip(point, self.start, along)) / length ** 2 if length else 0
        if not 0 < part < 1:
            return to_ends
        return abs((point[0] - self.start[0]) * along[1] - (point[1] - self.start[1]) * along[0]) / length

    def shares_level(self, other):
        """Whether both are cut at one level: in one run, or flat at the same."""
        return self.run == other.run or len({*self.levels, *other.levels}) == 1

    def samples(self, step):
        count = max(8, math.ceil(self.length() / step))
        return [self.at(i / count) for i in range(count + 1)]


class Contour:
    """Goes along lines and arcs that are much longer than the tool's radius, and says them as it goes.

    strict: it keeps away from itself, so that the tool fits. letters: of the plane's axes, of centres, and across.
    Centres are told to nine decimals, as far from both ends, so that every reader has the same circle. arc_first: the first
    move may be an arc.
    """

    def __init__(self, random, place, radius, letters="XYIJZ", strict=True, decimals=4, level=0.0, arc_first=True):
        self.random, self.radius, self.letters, self.strict, self.decimals = random, radius, letters, strict, decimals
        self.place, self.heads, self.incremental = list(place), random.uniform(-3, 3), False
        self.level, self.run, self.lines, self.pieces = level, 0, [], []
        self.may_leave_level, self.arc_first = True, arc_first

    def rounded(self, point):
        return [round(value, self.decimals) for value in point]

    def words(self, end):
        base = self.place if self.incremental else [0.0, 0.0]
        return " ".join(f"{letter}{value - start:.{self.decimals}f}" for letter, value, start in zip(self.letters, end, base))

    def line(self, code="G1"):
        length = self.radius * self.random.uniform(7, 20)
        end = self.rounded([self.place[0] + length * math.cos(self.heads), self.place[1] + length * math.sin(self.heads)])
        return self.add(f"{code} {self.words(end)}", Piece(self.place, end))

    def arc(self):
        radius, sweep, turn = self.radius * self.random.uniform(6, 15), self.random.uniform(0.6, 2), self.random.choice([1, -1])
        center = [self.place[0] - turn * radius * math.sin(self.heads), self.place[1] + turn * radius * math.cos(self.heads)]
        begins = math.atan2(self.place[1] - center[1], self.place[0] - center[0])
        end = self.rounded([center[0] + radius * math.cos(begins + turn * sweep), center[1] + radius * math.sin(begins + turn * sweep)])
        radius = round(radius, self.decimals)
        half = math.dist(self.place, end) / 2
        aside = turn * math.sqrt(radius ** 2 - half ** 2) / (2 * half)
        center = [(self.place[0] + end[0]) / 2 - aside * (end[1] - self.place[1]), (self.place[1] + end[1]) / 2 + aside * (end[0] - self.place[0])]
        by_radius = f"R{radius:.{self.decimals}f}"
        by_center = f"{self.letters[2]}{center[0] - self.place[0]:.9f} {self.letters[3]}{center[1] - self.place[1]:.9f}"
        code = "G3" if turn > 0 else "G2"
        if self.add(f"{code} {self.words(end)} {self.random.choice([by_radius, by_center])}", Piece(self.place, end, center, turn)):
            self.heads += turn * sweep
            return True
        return False

    def keeps_away(self, piece):
        """From what is behind it: of the piece before, from where the corner is left."""
        for before in self.pieces[1:]:
            if not before.shares_level(piece):
                continue
            near = before is self.pieces[-1]
            for point in piece.samples(self.radius / 4):
                if before.distance(point) < 2.2 * self.radius and not (near and math.dist(point, piece.start) < 4 * self.radius):
                    return False
        return True

    def add(self, block, piece):
        level = self.level
        if self.may_leave_level and self.random.random() < 0.2:
            change = round(self.random.uniform(-3, 3), 3)
            level = level + change if self.incremental else change
            block += f" {self.letters[4]}{change:.3f}"
        piece.levels, piece.run = (self.level, level), self.run
        if self.strict and self.pieces and not self.keeps_away(piece):
            return False
        self.pieces.append(piece)
        self.lines.append(block)
        self.place, self.level = piece.end, level
        return True

    def between(self):
        if self.may_leave_level and self.random.random() < 0.15:
            change = round(self.random.uniform(-3, 3), 3)
            self.lines.append(f"G1 {self.letters[4]}{change:.3f}")
            self.level, self.run = self.level + change if self.incremental else change, self.run + 1
        if self.random.random() < 0.15:
            self.lines.append(self.random.choice(["M3 S100", "M8", "G4 P0.5", "F300", "S200", "S300 G95 F0.5", "G94 F200"]))
        if self.random.random() < 0.2:
            self.incremental = not self.incremental
            self.lines.append("G91" if self.incremental else "G90")

    def go(self):
        """From the way in, whose corner is one, to the last piece. False where it led back to itself."""
        was_arc = self.arc_first and self.random.random() < 0.15
        if was_arc:
            self.arc()
        else:
            self.line(self.random.choice(["G1", "G0"]))
            self.heads = math.atan2(*reversed([b - a for a, b in zip(self.pieces[0].start, self.pieces[0].end)]))
        for i in range(self.random.randint(1, 7)):
            self.between()
            is_arc = self.random.random() < 0.5
            if i == 0 or self.random.random() < 0.8 or is_arc and was_arc:
                self.heads += self.random.choice([-1, 1]) * self.random.uniform(0.1, 2.2)
            if not (self.arc() if is_arc else self.line()):
                break
            was_arc = is_arc
        if self.incremental:
            self.lines.append("G90")
            self.incremental = False
        if any("G95" in line for line in self.lines):
            self.lines.append("G94 F200")


def nearest(path, contour, step):
    """How near a path comes to a contour, both pieces, where they are cut at one level."""
    return min((piece.distance(point) for way in path for piece in contour if way.shares_level(piece) for point in way.samples(step)),
               default=math.inf)
