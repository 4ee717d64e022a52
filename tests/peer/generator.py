"""Programs made by a grammar, the same for the same seed: lines, arcs and helices, canned cycles, offsets, homes, modes,
expressions, parameters and flow, most of them sound and some not; further.py has the rest.

What is left out on purpose: a change of units while a tool offset is in force, which rs274 does not convert; R of G10
while G92 shifts, where rs274 jumps; under G91 a change of units or of the offset along the hole within a series of canned
cycles, where R counts from the level at which the series began, of which rs274 keeps the number, not the place; pecks of less than 0.254 mm, between which rs274 goes above R; axis words of G28 and G30 in a
turned system, of which rs274 makes axes of the program; M6 behind a tool offset, a curve or with a turned system, after
which rs274 believes to stand elsewhere; F0 under G93; do behind a break, after which rs274 makes one pass only; a kept
feed that no F has followed under another feed mode, which rs274 loses; and G43 H0 behind G10 L1, L10 or L11, since rs274
takes T1 for loaded where no tool is.
"""
import math
import random

from further import Further


class Program(Further):
    def __init__(self, seed, flow=True):
        self.random = random.Random(seed)
        self.flow = flow
        self.lines, self.subs = [], []
        self.keeping = self.wet = self.disabled = self.changes_path = False  # modes, by M70 or M73
        self.inches = self.incremental = self.absolute_arcs = self.inverse = self.diameters = False
        self.plane, self.rotated, self.tool = "XY", False, False
        self.systems_turned, self.shift_kept = set(), False
        self.place_unsure = self.table_changed = False  # what rs274 takes for its place and its tools
        self.system, self.parameters, self.names = 1, {}, {}
        self.depth = self.labels = 0
        self.broken_off = False
        self.broken = self.random.random() < 0.12  # one of its blocks is made wrong

    # Words

    def chance(self, share):
        return self.random.random() < share

    def decimals(self):
        return 6 if self.inches else 5

    def value(self, low, high, decimals=None):
        """Written in mm, or in inches of a tenth as many."""
        scale = 0.1 if self.inches else 1
        return round(self.random.uniform(low, high) * scale, self.decimals() - 2 if decimals is None else decimals)

    def number(self, value):
        """A number as programs write it; now and then as an expression or a parameter that holds it."""
        text = f"{value:.{self.decimals()}f}".rstrip("0").rstrip(".")
        text = "0" if text in ("-0", "") else text
        kind = self.random.random()
        if kind < 0.86:
            return ("+" if value > 0 and self.chance(0.02) else "") + text
        if kind < 0.91:
            part = round(self.random.uniform(-9, 9), 2)
            return f"[{text}-[{part:g}]+{part:g}]"
        if kind < 0.94:
            return f"[{2 * value:.8f}/2]"
        number = self.random.randint(1, 30)
        self.parameters[number] = value
        self.lines.append(f"#{number}={text}")
        return f"#{number}" if kind < 0.98 else f"[#{number}*1]"

    def word(self, letter, value):
        value *= 2 if letter == "X" and self.diameters else 1
        letter = letter.lower() if self.chance(0.1) else letter
        return letter + (" " if self.chance(0.02) else "") + self.number(value)

    def block(self, *words):
        """Adds a block; its words may be in any order, since values are placed before."""
        words = [word for word in words if word]
        if self.chance(0.1):
            self.random.shuffle(words)
        text = ("" if self.chance(0.1) else " (remark) " if self.chance(0.02) else " ").join(words)
        if self.chance(0.03):
            text = f"N{self.random.randint(1, 99999)} {text}"
        if self.chance(0.02):
            text += self.random.choice([" (remark)", " ; remark"])
        self.lines.append(text)

    def spindle(self, can_be_all=False):
        """The word $, now and then: which spindle."""
        return self.random.choice(["$0", "$ 0", "$[1-1]"] + ["$-1"] * can_be_all) if self.chance(0.06) else ""

    def feed(self):
        """The word F, where one is needed or wanted."""
        if self.inverse:
            return f"F{self.random.uniform(0.2, 20):.2f}"
        return f"F{self.random.randint(5, 3000)}" if self.chance(0.15) else ""

    # Modes

    def set_units(self):
        if self.tool:
            self.block("G49")
            self.tool = False
        self.inches = self.chance(0.5)
        self.block("G20" if self.inches else "G21")
        if not self.inverse:
            self.block(f"F{self.random.randint(10, 900)}")

    def set_distance(self, incremental=None):
        self.incremental = self.chance(0.5) if incremental is None else incremental
        return "G91" if self.incremental else "G90"

    def set_plane(self, plane=None):
        self.plane = plane or self.random.choice(["XY", "ZX", "YZ"])
        return {"XY": "G17", "ZX": "G18", "YZ": "G19"}[self.plane]

    def mode(self):
        kind = self.random.randrange(9)
        if kind == 0:
            self.set_units()
        elif kind == 1:
            self.block(self.set_distance())
        elif kind == 2:
            self.block(self.set_plane())
        elif kind == 3:
            self.absolute_arcs = self.chance(0.5)
            self.block("G90.1" if self.absolute_arcs else "G91.1")
        elif kind == 4:
            paths = ["G61", "G61.1", "G64", "G64 P0.01", "G64 P0.02 Q0.01"]
            self.block("M9" if self.keeping and not self.changes_path else self.random.choice(paths))
        elif kind == 5:
            self.inverse = not self.inverse
            self.block("G93" if self.inverse else f"G94 F{self.random.randint(10, 900)}")
        elif kind == 6:
            self.block(self.random.choice(["G98", "G99"]))
        elif kind == 7:
            coolant = ["M9"] if self.keeping and self.wet else ["M7", "M8", "M9"]
            self.block(self.random.choice(["M3 S1000", "M4", "M5", *coolant, "S500", "G40", "M0", "M1", "G80"]))
        else:
            others = [] if self.keeping else ["M51 P0", "M52", "M52 P0"]  # rs274 brings none of these back
            others += [] if self.keeping and self.changes_path else ["M53 P0", "M53"]
            others += [] if self.keeping and self.disabled else ["M48", "M49", "M50 P0", "M50"]
            self.block(self.random.choice(others + ["G4 P0.5", "G4 P0", "T1", "T2" if self.place_unsure or self.systems_turned else "T2 M6", "G97 S300", "/G0 X1", "(a remark)", "",
                                           "M62 P1", "M63 P0", "M64 P3", "M65 P2", "M67 E1 Q2.5", "M68 E0 Q[1/3]", "M60",
                                           "M19 R45.5", "M19 R90 P2 Q1.5",
                                           "M66 P1 L0", "M66 E2"]))

    # Motion

    def line(self):
        axes = [axis for axis in "XYZABC" if self.chance(0.5 if axis in "XYZ" else 0.08)] or ["X"]
        words = [self.word(axis, self.value(-40, 40)) if axis in "XYZ" else self.word(axis, round(self.random.uniform(-90, 90), 2))
                 for axis in axes]
        rapid = self.chance(0.35)
        self.block("G0" if rapid else "G1", *words, "" if rapid else self.feed())
        for _ in range(self.random.choice([0, 0, 0, 1, 2])):
            self.block(self.word(self.random.choice("XYZ"), self.value(-40, 40)), "" if rapid else self.feed())

    def machine_line(self):
        if self.incremental:
            self.block(self.set_distance(False))
        axes = [axis for axis in "XYZ" if self.chance(0.6)] or ["Z"]
        self.block("G53", self.random.choice(["G0", f"G1 {self.feed()}"]), *(self.word(axis, self.value(-30, 30)) for axis in axes))

    def thread(self):
        """G33, G33.1 and G76, with the spindle turning; G0 behind them."""
        self.block(self.random.choice(["M3", "M4"]), f"S{self.random.randint(20, 300)}", self.spindle(can_be_all=True))
        kind = self.random.randrange(3)
        if kind == 0:
            for _ in range(self.random.randint(1, 2)):
                axes = [axis for axis in "XYZ" if self.chance(0.5)] or ["Z"]
                self.block("G33", *(self.word(axis, self.value(-30, 30)) for axis in axes), self.word("K", self.value(0.2, 3)), self.spindle())
        elif kind == 1:
            factor = f"I{self.random.uniform(0.5, 3):.2f}" if self.chance(0.4) else ""
            self.block("G33.1", self.word("Z", self.value(-60, -31)), self.word("K", self.value(0.2, 3)), factor, self.spindle())
        else:
            self.threading_cycle()
        self.block("G0", self.word("Z", self.value(31, 40)))
        self.block("M5")

    def threading_cycle(self):
        halved = self.chance(0.3)
        if halved:
            self.block("G7")
        self.block("G0", self.word("X", self.value(20, 30)), self.word("Z", self.value(5, 9)))
        first = self.value(0.1, 0.4)
        words = [self.word("P", self.value(0.3, 3)), self.word("Z", self.value(-30, -12)), self.word("J", first),
                 self.word("I", self.random.choice([-1, 1]) * self.value(0.5, 3)), self.word("K", first + self.value(0.05, 1))]
        words += [f"R{self.random.uniform(1, 2.5):.2f}"] if self.chance(0.6) else []
        words += [f"Q{self.random.choice([29, 29.5, 30, -15])}"] if self.chance(0.5) else []
        words += [f"H{self.random.randint(0, 2)}"] if self.chance(0.4) else []
        words += [self.word("E", self.value(0.2, 4)), f"L{self.random.randint(0, 3)}"] if self.chance(0.5) else []
        self.block("G76", *words, self.spindle())
        if halved:
            self.block("G8")

    def probe(self):
        """rs274 has no probe: it takes contact at the point programmed for granted, and then believes to stand before it."""
        if self.inverse:
            self.inverse = False
            self.block(f"G94 F{self.random.randint(10, 900)}")
        axes = [axis for axis in "XYZ" if self.chance(0.5)] or ["Z"]
        self.block(self.random.choice(["G38.2", "G38.3", "G38.4", "G38.5"]), *(self.word(axis, self.value(-40, 40)) for axis in axes), self.feed())
        found = self.random.choice(axes)
        self.lines.append(f"#{31 + 'XYZ'.index(found)}=#{5061 + 'XYZ'.index(found)}")
        before = self.incremental
        self.block("G90 G53 G0", *(self.word(axis, self.value(-30, 30)) for axis in "XYZ"))
        self.incremental = False
        if before:
            self.block(self.set_distance(True))
        if self.chance(0.5):
            self.lines.append(f"G0 {found}[#{31 + 'XYZ'.index(found)}/2]")

    def to_known_place(self, first, second):
        """Where an arc may begin in coordinates of the program: (first, second) of the plane."""
        start = [self.value(-30, 30), self.value(-30, 30)]
        before = self.incremental
        if self.inverse:
            self.block("G90 G0", self.word(first, start[0]), self.word(second, start[1]))
        else:
            self.block("G90", self.random.choice(["G0", "G1"]), self.word(first, start[0]), self.word(second, start[1]))
        self.incremental = False
        if before:
            self.block(self.set_distance(True))
        return start

    def arc(self):
        first, second = self.plane
        if self.rotated and self.plane != "XY":
            self.block(self.set_plane("XY"))
            first, second = "XY"
        normal = next(axis for axis in "XYZ" if axis not in self.plane)
        start = self.to_known_place(first, second)
        if self.chance(0.35):
            return self.arc_by_radius(first, second, normal, start)
        radius, at = self.value(2, 20), self.random.uniform(0, 2 * math.pi)
        center = [round(start[0] + radius * math.cos(at), self.decimals()), round(start[1] + radius * math.sin(at), self.decimals())]
        radius = math.dist(center, start)
        to = self.random.uniform(0, 2 * math.pi)
        closed = self.chance(0.15)
        end = start if closed else [round(center[0] + radius * math.cos(to), self.decimals()),
                                    round(center[1] + radius * math.sin(to), self.decimals())]
        if not closed and math.dist(start, end) < radius * 0.05:
            return None
        offset = center if self.absolute_arcs else [center[0] - start[0], center[1] - start[1]]
        letters = {"XY": "IJ", "ZX": "KI", "YZ": "JK"}[self.plane]
        words = [] if closed and self.chance(0.5) else self.ends(first, second, start, end)
        words += [self.word(letter, value) for letter, value in zip(letters, offset)]
        if not words or (closed and self.chance(0.3)):
            words += [f"P{self.random.randint(1, 3)}"]
        if self.chance(0.25):
            words.append(self.word(normal, self.value(-5, 5)))
        return self.block(self.random.choice(["G2", "G3"]), *words, self.feed())

    def ends(self, first, second, start, end):
        values = [e - s for s, e in zip(start, end)] if self.incremental else end
        return [self.word(first, values[0]), self.word(second, values[1])]

    def arc_by_radius(self, first, second, normal, start):
        end = [start[0] + self.value(2, 15), start[1] + self.value(2, 15)]
        least = math.dist(start, end) / 2
        radius = least * self.random.uniform(1.02, 3) * self.random.choice([1, -1])
        words = self.ends(first, second, start, end) + [self.word("R", round(radius, self.decimals()))]
        if self.chance(0.25):
            words.append(self.word(normal, self.value(-5, 5)))
        return self.block(self.random.choice(["G2", "G3"]), *words, self.feed())

    # Canned cycles

    CYCLES = {"G73": "Q", "G74": "P", "G81": "", "G82": "P", "G83": "Q", "G84": "P", "G85": "", "G86": "P", "G89": "P"}
    # rs274 feeds to wrong places in other planes, and takes no L with the two below G81.
    TAPS = ("G74", "G84")
    NO_REPEATS = ("G73", "G74")

    def cycle(self):
        if self.inverse:
            self.inverse = False
            self.block(f"G94 F{self.random.randint(10, 900)}")
        code = self.random.choice(self.cycles)
        if self.rotated or code in self.TAPS:
            if self.plane != "XY":
                self.block(self.set_plane("XY"))
        elif self.chance(0.6):
            self.block(self.set_plane())
        first, second = self.plane
        normal = next(axis for axis in "XYZ" if axis not in self.plane)
        self.block("G90 G0", self.word(normal, self.value(-5, 12) if self.chance(0.2) else self.value(16, 25)))
        self.incremental = False
        if self.chance(0.4):
            self.block(self.set_distance(True))
        if code in ("G74", "G84", "G86"):
            self.block("M4 S1000" if code == "G74" else "M3 S1000")
        clear = self.value(1, 15)
        bottom = -self.value(1, 15) if self.incremental else clear - self.value(1, 20)
        words = [self.word(axis, self.value(-30, 30)) for axis in (first, second) if self.chance(0.8)]
        words += [self.word(normal, bottom), self.word("R", clear)]
        words += [f"P{self.random.uniform(0, 2):.2f}"] if "P" in self.CYCLES[code] else []
        words += [self.word("Q", self.value(1.013, 7.177, self.decimals()))] if "Q" in self.CYCLES[code] else []
        words += [f"L{self.random.randint(1, 3)}"] if self.chance(0.15) and code not in self.NO_REPEATS else []
        # Units or coordinates have changed since the series began; and so that G98 leads rs274 to another level.
        self.moved = self.other_level = False
        self.retract = self.random.choice(["G98", "G99"])
        self.block(self.retract, code, *words)
        for _ in range(self.random.randint(0, 5)):
            self.within_series(code, normal)
        if self.other_level:
            self.block("G80 G90 G0", *(self.word(axis, self.value(-10, 10)) for axis in "XYZ"))
            self.incremental = False
        elif self.chance(0.7):
            self.block("G80")
        else:
            self.block("G0", self.word(first, self.value(-10, 10)))

    def within_series(self, code, normal):
        kind = 0.2 if self.chance(0.15) else self.random.random()
        # Rapids must join the holes, so that both are at the same place again behind the other level of G98.
        joined = self.retract == "G99" or code in ("G81", "G82", "G85") or (code in ("G83", "G73") and kind >= 0.27)
        if kind < 0.08:
            self.retract = "G99"
            self.block("G99")
        elif kind < 0.12:
            self.block(f"F{self.random.randint(10, 500)}")
        elif kind < 0.22 and joined and not self.incremental and code not in ("G83", "G73"):
            self.set_units()
            self.change_place(normal)
        elif kind < 0.27 and not self.moved:
            self.block(self.set_distance())
        elif kind < 0.32 and joined and not self.incremental:
            self.select_system()
            self.change_place(normal)
        elif kind < 0.37 and not self.systems_turned:
            axis = self.random.choice("XYZ" if joined and not self.incremental and not self.other_level else self.plane)
            self.block("G92", self.word(axis, self.value(-9, 9)))
            self.shift_kept = True
            self.change_place(axis)
        elif kind < 0.39 and not self.other_level:
            self.block("G4 P0.1")
        first, second = self.plane
        words = [self.word(axis, self.value(-30, 30)) for axis in (first, second) if self.chance(0.7)]
        if not self.other_level:  # behind a block that is refused, or that stays at the hole, no rapids join
            words += [self.word(normal, self.value(-30, 5))] if self.chance(0.12) else []
            words += [self.word("R", self.value(1, 12))] if self.chance(0.12) else []
        repeats = words and not self.other_level and code not in self.NO_REPEATS
        words += [f"L{self.random.randint(1, 3)}"] if repeats and self.chance(0.08) else []
        if words:
            self.block(self.random.choice(["", "", "", code]), *words)

    def change_place(self, axis):
        """Within a series: where the place at which it began has another number along this axis."""
        self.moved = True
        self.other_level = self.other_level or (self.retract == "G98" and axis not in self.plane)

    # Offsets

    def offset(self):
        kind = self.random.randrange(10)
        axes = [axis for axis in "XYZ" if self.chance(0.5)] or ["X"]
        words = [self.word(axis, self.value(-20, 20)) for axis in axes]
        words += [f"A{self.random.randint(-20, 20)}"] if self.chance(0.1) else []
        if kind == 0:
            which = self.random.randint(0, 9)
            number = which or self.system
            turns = not self.shift_kept and self.chance(0.3)
            if turns:
                angle = self.random.choice([0, 30, 45, 90, -60, 12.5])
                words.append(f"R{angle:g}")
                (self.systems_turned.add if angle else self.systems_turned.discard)(number)
            self.block("G10 L2", f"P{which}", *words)
            self.rotated = self.system in self.systems_turned
            self.keep_plane()
        elif kind == 1:
            self.block("G10 L20", f"P{self.random.randint(0, 9)}", *words)
        elif kind == 2:
            self.select_system()
        elif kind == 3 and not self.systems_turned:
            self.block("G92", *words)
            self.shift_kept = True
        elif kind == 4 and not self.systems_turned:
            self.block(self.random.choice(["G92.1", "G92.2", "G92.3"]))
        elif kind == 5:
            self.block("G43.1", self.word("Z", self.value(-20, 20)))
            self.tool = self.place_unsure = True
        elif kind == 6:
            self.block("G49")
            self.tool = False
        elif kind == 7:
            self.block(self.random.choice(["G28", "G30"]), *(words if self.chance(0.6) and not self.rotated else []))
        elif kind == 8:
            self.block(self.random.choice(["G28.1", "G30.1"]))
        else:
            self.block(f"G43 H{self.random.randint(1 if self.table_changed else 0, 3)}")
            self.tool = self.place_unsure = True

    def keep_plane(self):
        if self.rotated and self.plane != "XY":
            self.block(self.set_plane("XY"))

    def select_system(self):
        self.system = self.random.randint(1, 9)
        self.block("G" + ["54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"][self.system - 1])
        self.rotated = self.system in self.systems_turned
        self.keep_plane()

    # Values

    FUNCTIONS = ["ABS", "SIN", "COS", "ROUND", "FIX", "FUP", "EXP", "ATAN", "SQRT", "ACOS", "ASIN", "LN"]
    OPERATORS = ["+", "-", "*", "/", "MOD", "**", "EQ", "NE", "GT", "GE", "LT", "LE", "AND", "OR", "XOR"]

    def expression(self, depth=0):
        kind = self.random.random()
        if depth > 3 or kind < 0.35:
            return f"{self.random.uniform(0.1, 4):.2f}"
        if kind < 0.55 and self.parameters:
            return f"#{self.random.choice(list(self.parameters))}"
        if kind < 0.6 and self.names:
            return f"#<{self.random.choice(list(self.names))}>"
        if kind < 0.75:
            function = self.random.choice(self.FUNCTIONS)
            argument = f"[{self.expression(depth + 1)}]"
            if function == "ATAN":
                return f"ATAN{argument}/[{self.expression(depth + 1)}]"
            if function == "EXP":
                argument = f"[SIN{argument}]"
            elif function in ("SQRT", "LN"):
                argument = f"[ABS[{self.expression(depth + 1)}]+0.1]"
            elif function in ("ACOS", "ASIN"):
                argument = f"[COS[{self.expression(depth + 1)}]*0.9]"
            elif function in ("ROUND", "FIX", "FUP"):
                argument = f"[{self.random.randint(-5, 5)}.{self.random.randint(11, 39)}]"
            return function + argument
        operator = self.random.choice(self.OPERATORS)
        left, right = self.expression(depth + 1), self.expression(depth + 1)
        if operator == "**":
            return f"[ABS[{left}]+0.1]**{self.random.randint(-2, 2)}"
        if operator in ("/", "MOD"):
            right = f"[ABS[{right}]+0.5]"
        if operator == "MOD":
            left = f"{self.random.randint(-20, 20)}.3"
        if operator in ("EQ", "NE", "GT", "GE", "LT", "LE"):
            left = f"{self.random.randint(0, 3)}"
        return f"[{left} {operator} {right}]"

    def assignment(self):
        text = f"[SIN[{self.expression()}]*20]"
        if self.chance(0.3):
            name = self.random.choice(["depth", "_width", "a b", "Count"])
            self.names[name] = True
            self.lines.append(f"#<{name}>={text}")
        else:
            number = self.random.randint(1, 40)
            self.lines.append(f"#{number}={text}")
            self.parameters[number] = None
        if self.chance(0.7):
            axis = self.random.choice("XYZ")
            self.lines.append(f"G0 {axis}[SIN[{self.expression()}]*10]")

    # Flow

    def label(self):
        self.labels += 1
        return f"o{self.labels}" if self.chance(0.8) else f"o<part{self.labels}>"

    def body(self):
        self.depth += 1
        for _ in range(self.random.randint(1, 2)):
            self.statement()
        self.depth -= 1

    def flow_statement(self):
        if self.depth > 2:
            return self.line()
        kind, label, counter = self.random.randrange(6), self.label(), 100 + self.labels
        if kind == 3 and self.broken_off:
            kind = 1
        if kind == 0:
            self.lines.append(f"{label} if [{self.expression()} GT 1]")
            self.harmless()
            if self.chance(0.5):
                self.lines.append(f"{label} elseif [{self.expression()} LT 2]")
                self.harmless()
            if self.chance(0.5):
                self.lines.append(f"{label} else")
                self.harmless()
            self.lines.append(f"{label} endif")
        elif kind == 1:
            self.lines.append(f"{label} repeat [{self.random.randint(0, 4)}]")
            self.harmless()
            self.lines.append(f"{label} endrepeat")
        elif kind == 2:
            self.lines += [f"#{counter}=0", f"{label} while [#{counter} LT {self.random.randint(0, 4)}]"]
            self.harmless()
            if self.chance(0.3):
                inner = self.label()
                self.lines += [f"{inner} if [#{counter} EQ 2]", f"{label} {self.random.choice(['break', 'break'])}", f"{inner} endif"]
                self.broken_off = True
            self.lines += [f"#{counter}=[#{counter}+1]", f"{label} endwhile"]
        elif kind == 3:
            self.lines += [f"#{counter}=0", f"{label} do"]
            self.harmless()
            self.lines += [f"#{counter}=[#{counter}+1]", f"{label} while [#{counter} LT {self.random.randint(1, 4)}]"]
        else:
            self.call(label)
        return None

    def harmless(self):
        """Moves that leave the modes as they were, whichever way the program goes."""
        for _ in range(self.random.randint(1, 2)):
            axis = self.random.choice("XYZ")
            code = "G0" if self.inverse or self.chance(0.5) else "G1"
            self.lines.append(f"{code} {axis}[SIN[{self.expression()}]*10]")

    def call(self, label):
        lines, self.lines = self.lines, []
        self.lines.append(f"{label} sub")
        self.lines.append("G0 X[#1] Y[#2*2]")
        if self.chance(0.3):
            inner = self.label()
            self.lines += [f"{inner} if [#1 GT 2]", f"{label} return [#1*2]" if self.chance(0.5) else f"{label} return", f"{inner} endif"]
        self.lines += ["#1=[#1+1]", "#<local>=#1", "G0 Z#<local>", f"{label} endsub" + (" [#1]" if self.chance(0.4) else "")]
        sub, self.lines = self.lines, lines
        self.lines += sub
        self.lines.append("#1=1 #2=2")
        self.parameters.update({1: 1, 2: 2})
        for _ in range(self.random.randint(1, 2)):
            arguments = "".join(f" [{self.random.uniform(0, 4):.2f}]" for _ in range(self.random.randint(2, 3)))
            self.lines.append(f"{label} call{arguments}")
        self.lines.append("G0 X#1 Y#2")
        if self.chance(0.5):
            self.lines.append("G0 Z#<_value>")

    # Wrong blocks

    WRONG = ["G1 X", "X1 X2", "G0 G1 X1", "G2 X3", "G17 G18", "G5.5", "G1 X1 Q3", "H", "G43 H99", "G10 L3 P1 X0", "G10 L2 P12 X0",
             "G53 G2 X1 I1", "G92", "G4", "G4 P-1", "#0=1", "#9999=2", "#<never_set>", "G0 X#<never_set>", "G0 X[1/0]",
             "G0 X[SQRT[-1]]", "G0 X[ACOS[2]]", "M3 M4", "M5 $1", "S100 $-2", "M19 R5 $-1", "G1 X1 F100 $0", "M99.5", "G0 X1 (open", "T-1", "S-5", "F-3", "G1 F0 X3", "G93 G1 X3",
             "G81 X1 R1", "G80 X1", "G92 X1 G0 Y2", "G91 G53 G0 X1", "G2 X1 Y1 R0.1", "G3 I0 J0", "G2 X5 I1 R3", "G81 Z-1 R2 L0", "M62",
             "G83 X1 Z-3 R1", "G82 X1 Z-3 R1", "G83 X1 Z-3 R1 Q-1", "G28.1 X1", "M6 T1.5", "M1000", "G0 X[1 + ]", "G0 X[2",
             "W1", "G0 Z1 G43 H1 G49", "G38.2", "D3", "G54 P3", "G90 G91", "%5", "G0.5", "X 1 2 3 Y4", "g1x1y2z3f5"]

    def statement(self):
        kind = self.random.random()
        if self.chance(0.25):
            self.further()
        elif kind < 0.25:
            self.line()
        elif kind < 0.42:
            self.arc()
        elif kind < 0.57:
            self.cycle()
        elif kind < 0.72:
            self.offset()
        elif kind < 0.84:
            self.mode()
        elif kind < 0.90:
            self.assignment()
        elif kind < 0.93:
            self.machine_line()
        elif kind < 0.94:
            self.thread()
        elif kind < 0.95:
            self.probe()
        elif self.flow:
            self.flow_statement()
        else:
            self.line()


def program(seed, flow=True, cycles=tuple(Program.CYCLES)):
    """The text of a program."""
    made = Program(seed, flow)
    made.cycles = list(cycles)
    made.inches = made.chance(0.4)
    made.lines.append(f"{'G20' if made.inches else 'G21'} G90 G94 G17 {made.random.choice(['G98', 'G99'])}")
    made.lines.append(f"F{made.random.randint(10, 1500)}")
    statements = made.random.randint(4, 16)
    wrong = made.random.randrange(statements) if made.broken else -1
    for i in range(statements):
        if i == wrong:
            wrong_block = made.random.choice(made.WRONG)
            made.lines.append("G1 X" if made.inverse and "F0" in wrong_block else wrong_block)
        made.statement()
    made.lines.append(made.random.choice(["M2", "M30"]))
    return "\n".join(made.lines) + "\n"
