"""Statements of the grammar beside those of generator.py: curves, contours with cutter compensation, polar words, diameters, kept modes, feed per
revolution, surface speed, tool tables, local shifts, blocks that mix codes, and calls within calls."""


import re

from contours import Contour

# Of the tools of the table, inches; the last is a lathe's.
DIAMETERS = (0.12, -0.06, 0.03)


class Further:
    """A part of generator.Program."""

    def further(self):
        self.random.choice([self.curve, self.quadratic, self.nurbs, self.polar, self.diameter, self.kept_modes, self.per_revolution,
                            self.surface, self.tool_data, self.local_shift, self.mixed, self.nested_calls, self.kept_in_sub,
                            self.names_of_all, self.rounding, self.doubled_loops, self.machine_block,
                            self.compensated, self.compensated])()

    # Curves

    def begin_curve(self):
        self.place_unsure = True
        self.in_xy()

    def in_xy(self):
        if self.plane != "XY":
            self.block(self.set_plane("XY"))

    def curve(self):
        """G5: control points from the start and from the end; a second one may go on without I and J."""
        self.begin_curve()
        for i in range(self.random.choice([1, 1, 2, 3])):
            words = [self.word(letter, self.value(-20, 20)) for letter in "XY"]
            if i == 0 or self.chance(0.6):
                words += [self.word(letter, self.value(-9, 9)) for letter in "IJ"]
            words += [self.word(letter, self.value(-9, 9)) for letter in "PQ"]
            self.block("G5", *words, self.feed())

    def quadratic(self):
        self.begin_curve()
        for _ in range(self.random.choice([1, 1, 2])):
            words = [self.word(letter, self.value(-20, 20)) for letter in "XY"]
            words += [self.word(letter, self.value(1, 9)) for letter in "IJ"]
            self.block("G5.1", *words, self.feed())

    def nurbs(self):
        self.begin_curve()
        order = self.random.choice([0, 3, 4])
        weight = lambda: f"P{self.random.choice([1, 0.5, 2])}"
        self.block("G5.2", *(self.word(letter, self.value(-20, 20)) for letter in "XY"), weight(), f"L{order}" if order else "", self.feed())
        for _ in range(self.random.randint(3, 5)):
            words = [self.word(letter, self.value(-20, 20)) for letter in "XY"]
            self.lines.append(" ".join(words + [weight()]))
        self.block("G5.3")
        self.line()

    # Cutter compensation

    def compensated(self):
        """A contour that the tool fits into, of a diameter given or of a tool, a lathe's among them."""
        if self.inverse:
            self.inverse = False
            self.block(f"G94 F{self.random.randint(10, 900)}")
        if self.diameters:
            self.diameter()
        plane = self.random.choice(["XY", "XY", "ZX"]) if not self.rotated else "XY"
        if self.plane != plane:
            self.block(self.set_plane(plane))
        if self.incremental:
            self.block(self.set_distance(False))
        letters = "XYIJZ" if plane == "XY" else "ZXKIY"
        level = self.value(-5, 5)
        self.block("G0", self.word(letters[4], level))
        place = self.to_known_place(letters[0], letters[1])
        tool = self.random.randint(1, 2 if plane == "XY" else 3)
        of_tool = self.chance(0.4)
        radius = abs(DIAMETERS[tool - 1]) / 2 * (1 if self.inches else 25.4) if of_tool else self.value(0.5, 3)
        word = f"D{tool}" if of_tool else f"D{2 * radius * self.random.choice([1, 1, -1]):.6f}"
        word += f" L{self.random.randint(0, 9)}" if plane == "ZX" and not of_tool and self.chance(0.5) else ""
        begin = f"{self.random.choice(['G41', 'G42'])}{'' if of_tool else '.1'} {word}"
        contour = Contour(self.random, place, radius, letters, decimals=self.decimals() - 1, level=level, arc_first=plane == "XY")
        contour.go()
        self.end_contour([begin, *contour.lines])
        self.leave_contour(contour)

    def end_contour(self, lines):
        """By G40, or by modes that come back, where rs274 brings back all that the contour has changed."""
        changes = any(re.search(r"M[378]|G9[45]", line) for line in lines)
        end = "G40" if changes or self.tool else self.random.choice(["G40", "G40", "M72", "call"])
        if end == "call":
            label = self.label()
            lines = [f"{label} sub", "M73", *lines, f"{label} endsub", f"{label} call"]
        else:
            lines = ["M70", *lines, end] if end == "M72" else [*lines, end]
        self.lines += lines
        if end != "G40":
            self.block(f"F{self.random.randint(10, 900)}")

    def leave_contour(self, contour):
        """By a line, compensation switched on again before it or not."""
        letters = contour.letters
        way = self.random.choice(["", "", "", "none", "zero", "anew", "plane", "event"])
        radius = self.value(0.5, 3)
        again = f"{self.random.choice(['G41.1', 'G42.1'])} D{2 * radius:.6f}"
        if way == "none":
            self.lines += [again, "G40"]
        elif way == "zero":
            self.lines.append("G41.1 D0")
        elif way == "anew":
            other = Contour(self.random, contour.place, radius, letters, decimals=contour.decimals, level=contour.level, arc_first=False)
            other.go()
            self.lines += [again, *other.lines, "G40"]
        elif way == "plane" and not self.rotated:
            self.block(self.set_plane("ZX" if self.plane == "XY" else "XY"))
        elif way == "event":
            self.block("M9")
        self.block(self.random.choice(["G0", "G1"]), self.word(letters[0], self.value(-30, 30)), self.word(letters[1], self.value(-30, 30)))
        if way == "zero":
            self.lines.append("G40")

    # Coordinates

    def polar(self):
        """A radius and an angle about the origin of the program."""
        self.in_xy()
        if self.chance(0.4):
            self.block("G90 G0", self.word("X", self.value(2, 20)), self.word("Y", self.value(-20, 20)))
            self.incremental = False
        for _ in range(self.random.randint(1, 3)):
            words = [f"@{self.number(self.value(1, 30))}"] if self.chance(0.7) else []
            words += [f"^{self.random.uniform(-180, 180):.2f}"] if self.chance(0.7) or not words else []
            words += [self.word("Z", self.value(-5, 5))] if self.chance(0.2) else []
            rapid = self.chance(0.4)
            self.block("G0" if rapid else "G1", *words, "" if rapid else self.feed())

    def diameter(self):
        self.diameters = not self.diameters
        self.block("G7" if self.diameters else "G8")

    def local_shift(self):
        if self.systems_turned:
            return self.line()
        words = [self.word(axis, self.value(-20, 20)) for axis in "XYZ" if self.chance(0.5)] or ["X0"]
        self.block("G52", *words)
        self.shift_kept = True
        return self.line()

    # Modes

    def kept_modes(self):
        """M70, other modes, and M72, which brings the first ones back."""
        if self.tool:
            self.block("G49")
            self.tool = False
        before = self.modes()
        self.begin_keeping()
        self.block("M70")
        for _ in range(self.random.randint(1, 3)):
            self.mode()
        self.shift()
        self.keeping = False
        self.line()
        if self.chance(0.2):
            self.block("M71")
            return self.block("M70")
        self.block("M72")
        self.bring_back(before)
        return self.after_kept()

    def shift(self):
        """Whether it is in force comes back, and not how far it shifts."""
        if self.systems_turned or self.chance(0.6):
            return
        words = [self.word(axis, self.value(-9, 9)) for axis in "XYZ" if self.chance(0.5)] or ["X1"]
        self.block(self.random.choice(["G92", "G52"]), *words) if self.chance(0.5) else self.block(self.random.choice(["G92.1", "G92.2", "G92.3"]))
        self.shift_kept = True

    def begin_keeping(self):
        """rs274 stops no coolant that came on beside another, disables nothing, and loses M53 where G64 changes as well."""
        self.keeping = True
        self.wet = any(re.search(r"M[78](?!\d)", line) for line in self.lines)
        self.disabled = any("M49" in line or "M50 P0" in line for line in self.lines)
        self.changes_path = self.chance(0.5)

    def modes(self):
        return (self.inches, self.incremental, self.absolute_arcs, self.inverse, self.plane, self.system, self.rotated, self.diameters)

    def bring_back(self, modes):
        (self.inches, self.incremental, self.absolute_arcs, self.inverse, self.plane, self.system, self.rotated, self.diameters) = modes

    def kept_in_sub(self):
        """M73: the modes come back where the subroutine ends."""
        if self.tool:
            self.block("G49")
            self.tool = False
        self.begin_keeping()
        before, lines, self.lines = self.modes(), self.lines, []
        label = self.label()
        self.lines += [f"{label} sub", "M73"]
        for _ in range(self.random.randint(1, 3)):
            self.mode()
            if self.chance(0.2):
                self.block("M70")
                before = self.modes()
        self.shift()
        self.keeping = False
        self.line()
        self.lines.append(f"{label} endsub")
        sub, self.lines = self.lines, lines
        self.bring_back(before)
        self.lines += sub
        self.lines.append(f"{label} call")
        self.after_kept()

    def after_kept(self):
        """Without an F under another feed mode rs274 has lost the one that was kept."""
        if not self.inverse:
            self.block(f"F{self.random.randint(10, 900)}")
        self.line()

    def per_revolution(self):
        self.inverse = False
        self.block(f"S{self.random.randint(100, 3000)} {self.random.choice(['M3', 'M4', ''])}", self.spindle(can_be_all=True))
        self.block("G95", f"F{self.random.uniform(0.01, 2):.3f}")
        self.line()
        if self.chance(0.7):
            self.block(f"G94 F{self.random.randint(10, 900)}")

    def surface(self):
        self.block("G96", f"D{self.random.randint(100, 5000)}" if self.chance(0.6) else "", f"S{self.random.randint(10, 300)}",
                   self.random.choice(["M3", "M4", ""]), self.spindle())
        self.line()
        if self.chance(0.8):
            self.block("G97", f"S{self.random.randint(100, 3000)}")

    # Tools

    def tool_data(self):
        kind, tool = self.random.randrange(4), self.random.randint(1, 3)
        words = [self.word(axis, self.value(-20, 20)) for axis in "XYZ" if self.chance(0.5)] or ["Z1"]
        if kind == 3 or self.rotated:
            self.block(f"G43.2 H{tool}")
        else:
            self.block(f"G10 {('L1', 'L10', 'L11')[kind]} P{tool}", *words)
            self.block(f"G43 H{tool}")
        self.tool = self.table_changed = self.place_unsure = True
        self.line()

    # Blocks

    def mixed(self):
        """Several codes in a block, with remarks between words."""
        axis, remark = self.random.choice("XYZ"), self.random.choice(["", "(a)", " (b) "])
        word = self.word(axis, self.value(-20, 20))
        texts = [f"G80{remark}G0 {word}", f"G0{remark}{word}G80", f"G90{remark}G0{word}(c)", f"G61 G0 {remark}{word}"]
        if not self.inverse:
            texts += [f"G1 G80 {word} F{self.random.randint(10, 500)}", f"F{self.random.randint(10, 500)}{remark}G64 P0.1 G1 {word}",
                      f"S100 M3 M8 F100 {remark} G1 {word}"]
        text = self.random.choice(texts)
        if "G90" in text:
            self.incremental = False
        self.lines.append(text)

    def machine_block(self):
        self.block(self.random.choice(["G64 Q0.01", "G64 P0", "G64 P0.1 Q0", "G61.1 G4 P0.1", "G10 L20 P0 X1 Z2", "M7 M8", "M9 M5",
                                       "M1 G4 P0.2", "T3 G4 P0.1", "G17 G97 S100"]))
        self.plane = "XY" if self.lines[-1].find("G17") >= 0 else self.plane
        self.line()

    # Values and flow

    def names_of_all(self):
        """Names that all subroutines share, names of their own, and whether there are any."""
        name, label = self.random.choice(["_shared", "_other"]), self.label()
        self.lines += [f"#<{name}>={self.random.randint(1, 9)}", "#<own>=2", f"{label} sub", f"#<{name}>=[#<{name}>+#1]",
                       "#<own>=7", "G0 X#<own> Y#31", f"{label} endsub", f"#31={self.random.randint(1, 5)}",
                       f"{label} call [{self.random.randint(1, 5)}]", f"G0 X#<{name}> Y[EXISTS[#<{name}>]] Z[EXISTS[#<never>]+#<own>]"]

    def rounding(self):
        value = lambda: f"{self.random.randint(-4, 4)}.{self.random.choice([1, 25, 49, 51, 75, 9])}"
        function = self.random.choice(["FIX", "FUP", "ROUND"])
        angle = f"ATAN[{value()}]/[{value()}]"
        self.lines += [f"G0 X[{function}[{value()}]] Y[{angle}/10]", f"#40=[{value()} MOD {self.random.choice([3, 2.5, -3])}]", "G0 Z#40",
                       "##40=3" if self.chance(0.05) else "#[2+3]=4", f"G0 X[#[3+2]] Z-[#5-{value().lstrip('-')}]"]

    def nested_calls(self):
        """A subroutine that calls another; what they return, and how they are left."""
        inner, outer = self.label(), self.label()
        self.lines += [f"{inner} sub", "G0 X#1 Y#2", "#3=[#1*2]",
                       f"{inner} {self.random.choice(['return', 'endsub'])} [#3+1]"]
        if "return" in self.lines[-1]:
            self.lines.append(f"{inner} endsub")
        self.lines += [f"{outer} sub", f"{inner} call [#1] [#2]", "G0 Z#<_value> X#<_value_returned>", "#1=[#1+1]",
                       f"{inner} call [#1+#<_value>]", "G0 Y#1", f"{outer} endsub{self.random.choice(['', ' [#<_value>*2]'])}"]
        for _ in range(self.random.randint(1, 2)):
            self.lines.append(f"{outer} call [{self.random.uniform(0, 4):.2f}] [{self.random.uniform(0, 4):.1f}] (remark)")
            self.lines.append("G0 X#<_value> Y#<_value_returned>")

    def doubled_loops(self):
        """Loops within loops, with continue."""
        outer, inner, choice = self.label(), self.label(), self.label()
        counter = 200 + self.labels
        self.lines += [f"#{counter}=0", f"{outer} while [#{counter} LT {self.random.randint(1, 4)}]", f"#{counter}=[#{counter}+1]",
                       f"{inner} repeat [#{counter}]", f"G0 X#{counter} Y[#{counter}*2]", f"{inner} endrepeat",
                       f"{choice} if [#{counter} EQ 2]", f"{outer} continue", f"{choice} endif", f"G0 Z#{counter}", f"{outer} endwhile"]
