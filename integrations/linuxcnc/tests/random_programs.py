#!/usr/bin/env python3
"""random_programs.py MODULE COUNT SEED [NUMBER…]: random programs and MDI commands inside LinuxCNC, short and long, slow and fast,
with overrides of 0 to 200 %, pauses, steps, aborts, jogs and runs at random instants; of these NUMBERs alone where some are given.
Limits are kept, drives follow, nothing hangs, nothing complains, and motion ends where the last program or command ends.

Programs are played by four LinuxCNCs at once, some programs each, so that one that hangs takes few with it."""
import concurrent.futures
import math
import random
import sys

import simulator
from interventions import ACCELERATION, JERK, VELOCITY, Record

HEAD = "G21 G90 G17 G94\n"
MODES = ["G61", "G61.1", "G64", "G64 P0.002", "G64 P0.01", "G64 P0.05", "G64 P0.2", "G64 P0.05 Q0", "G64 P1"]
PLANES = {"G17": (0, 1, 2), "G18": (2, 0, 1), "G19": (1, 2, 0)}  # first and second axis, and the third
REACH = 60  # mm, of lines; arcs reach further
LONGEST = 12  # s, as programs are drawn, of feeds alone
AT_ONCE, TOGETHER = 4, 10


def spread(draw, least, most):
    """Between both, all orders of magnitude alike."""
    return math.exp(draw.uniform(math.log(least), math.log(most)))


class Program:
    """Blocks, where they end, and about how long they take, s."""

    def __init__(self, draw):
        self.draw = draw
        self.place = [0.0, 0.0, 0.0]
        self.blocks = []
        self.seconds = 0.0

    def feed(self, length):
        """For so many mm, 3 s at most."""
        feed = round(max(spread(self.draw, 1, 30000), length / 3 * 60), 1)
        self.seconds += length / feed * 60
        return f" F{feed}"

    def line(self, step):
        start = self.place
        self.place = [round(min(REACH, max(-REACH, v + self.draw.uniform(-step, step))), 6) for v in self.place]
        return "G1 X{:.6f} Y{:.6f} Z{:.6f}".format(*self.place) + self.feed(math.dist(start, self.place))

    def rapid(self):
        axis = self.draw.randrange(3)
        self.place[axis] = round(self.draw.uniform(-REACH, REACH), 3)
        self.seconds += 0.4
        return f"G0 {'XYZ'[axis]}{self.place[axis]}"

    def arc(self):
        """An arc, a circle or a helix of some turns, in any plane."""
        name = self.draw.choice(list(PLANES))
        first, second, third = PLANES[name]
        radius, toward = spread(self.draw, 0.05, 40), self.draw.uniform(-math.pi, math.pi)
        i, j = (round(radius * f(toward), 6) for f in (math.cos, math.sin))
        center = [self.place[first] + i, self.place[second] + j]
        angle = self.draw.choice([0, self.draw.uniform(-math.pi, math.pi)])
        turns = self.draw.choice([1, 1, 1, 2, 4])
        end = list(self.place)
        if angle:
            cos, sin = math.cos(angle), math.sin(angle)
            end[first] = round(center[0] - i * cos + j * sin, 6)
            end[second] = round(center[1] - i * sin - j * cos, 6)
        if self.draw.random() < 0.4:
            end[third] = round(self.draw.uniform(-REACH, REACH), 4)
        feed = self.feed(math.hypot(2 * math.pi * radius * turns, end[third] - self.place[third]))
        self.place = end
        words = "".join(f" {'XYZ'[axis]}{end[axis]:.6f}" for axis in range(3))
        return f"{name} {self.draw.choice(['G2', 'G3'])}{words} {'IJK'[first]}{i:.6f} {'IJK'[second]}{j:.6f} P{turns}{feed}\nG17"

    def block(self):
        kind = self.draw.random()
        if max(map(abs, self.place)) > 2 * REACH:
            return self.line(1)
        if kind < 0.12:
            return self.rapid()
        if kind < 0.35:
            return self.arc()
        if kind < 0.4:
            return self.draw.choice(MODES)
        if kind < 0.5:
            return self.draw.choice(["M62 P0", "M63 P0", "M67 E0 Q1.5", "G4 P0.05", "M64 P0", "M65 P0", "M68 E0 Q1"])
        return self.line(spread(self.draw, 0.001, 60))

    def curve(self):
        """Many short lines along a curve, of one feed; fewer where a stop at each end would take more than 20 s."""
        count, step = self.draw.randint(50, 1500), spread(self.draw, 0.005, 1)
        feed = round(max(spread(self.draw, 100, 12000), count * step / 8 * 60), 1)
        self.seconds += count * step / feed * 60
        heading, bend = self.draw.uniform(-math.pi, math.pi), spread(self.draw, 0.001, 0.3)
        found = ["G64 P0.01"] * (count > 100 and self.draw.random() < 0.5) or ["G61"] * (count > 100)
        from_rest_to_rest = (32 * step / JERK) ** (1 / 3)  # s
        if found == ["G61"]:
            count = min(count, int(20 / from_rest_to_rest))
        for n in range(count):
            heading += self.draw.uniform(-bend, bend)
            if math.hypot(*self.place) > REACH:
                heading = math.atan2(-self.place[1], -self.place[0])
            self.place[0] = round(self.place[0] + step * math.cos(heading), 6)
            self.place[1] = round(self.place[1] + step * math.sin(heading), 6)
            found.append(f"G1 X{self.place[0]:.6f} Y{self.place[1]:.6f}" + (f" F{feed}" if n == 0 else ""))
        return "\n".join(found)

    def write(self, from_anywhere):
        self.blocks = [self.draw.choice(MODES)] + ["G0 X0 Y0 Z0"] * from_anywhere
        most = self.draw.choice([1, 3, 12, 12, 40, 120])
        for _ in range(most):
            if self.seconds > LONGEST:
                break
            self.blocks.append(self.block())
        if self.draw.random() < 0.25:
            self.blocks.append(self.curve())
        return HEAD + "\n".join(self.blocks) + "\nM2\n"


def commands_of(draw):
    """MDI commands that are given one behind the other, and where they end."""
    program = Program(draw)
    commands = [HEAD.strip() + " " + draw.choice(MODES) + " G0 X0 Y0 Z0"]
    commands += [command for _ in range(draw.randint(1, 3)) for command in program.block().split("\n")]
    # Whatever came before, it ends there.
    return commands + [program.rapid()] + ["G0 X{:.6f} Y{:.6f} Z{:.6f}".format(*program.place)], program


def interventions_of(draw, seconds):
    """Overrides and pauses within the time that a program may take; none is left in force."""
    acts, moment = [], 0.0
    for _ in range(draw.choice([0, 1, 2, 4, 8])):
        moment = moment + draw.uniform(0.005, max(0.1, min(seconds / 2, 2)))
        kind = draw.random()
        if kind < 0.35:
            acts.append([moment, "pause", 0])
            if draw.random() < 0.2:
                moment += draw.uniform(0.01, 0.5)
                acts.append([moment, "step", 0])
            moment += spread(draw, 0.005, 0.8)
            acts.append([moment, "resume", 0])
            continue
        what, most, whole = draw.choice([("feed", 2, 1), ("feed", 2, 1), ("rapid", 1, 1), ("maxvel", 400, 400)])
        value = draw.choice([0, most, draw.uniform(0, most), spread(draw, 0.01 * most, most)])
        acts.append([moment, what, round(value, 4)])
        if value < 0.3 * most or draw.random() < 0.2:
            moment += spread(draw, 0.005, 1)
            acts.append([moment, what, whole])
    return acts + [[moment + 1, what, whole] for what, whole in (("feed", 1), ("rapid", 1), ("maxvel", 400))]


def jog_of(draw):
    return [draw.randrange(3), draw.choice([-1, 1]) * draw.uniform(1, 60), draw.uniform(0.02, 0.5)]


def after_an_abort(draw, moment, end):
    """What follows it, soon, and where that ends."""
    # Whatever planner there is, LinuxCNC's interpreter is told at rest where it is, and reads wrong if it has gone on before.
    acts, place = [[moment, "abort", 0], [moment, "rest", 0]], end
    moment += draw.choice([0, 0.01, draw.uniform(0, 0.5)])
    if draw.random() < 0.3:
        acts.append([moment, "jog", jog_of(draw)])
    if draw.random() < 0.5:
        acts.append([moment, "run", 0])
    else:
        commands, program = commands_of(draw)
        acts += [[moment, "send", command] for command in commands]
        place = program.place
    return acts, place


def sensible(acts):
    """Without single steps of commands, and what goes on only where something is paused: else LinuxCNC, whatever its planner,
    takes a program under way for one that has been read to its end."""
    is_paused = are_commands = False
    for act in acts:
        what = act[1]
        are_commands = are_commands or what == "send"
        if what in ("step", "resume") and not is_paused or what == "step" and are_commands:
            continue
        is_paused = what in ("pause", "step") or is_paused and what not in ("resume", "abort")
        yield act


def job_of(seed, number):
    """A program or commands with what happens meanwhile, and where motion ends."""
    draw = random.Random(f"{seed}/{number}")
    job = {"name": f"random-{number}"}
    jogs, aborts = draw.random() < 0.2, draw.random() < 0.3
    acts = [[0, "jog", jog_of(draw)]] * jogs
    if draw.random() < 0.75:
        program = Program(draw)
        job["program"] = program.write(jogs or aborts or draw.random() < 0.2)
        acts.append([0, "run", 0])
        end = program.place
    else:
        commands, program = commands_of(draw)
        acts += [[0, "send", command] for command in commands]
        end = program.place
    meanwhile = interventions_of(draw, program.seconds)
    if aborts:
        moment = draw.uniform(0, min(program.seconds + 0.5, 6))
        if "program" not in job:
            acts_after, end = [[moment, "abort", 0], [moment, "rest", 0], [moment + draw.uniform(0, 0.3), "send", "G21 G90 G0 X1 Y2 Z3"]], [1, 2, 3]
        else:
            acts_after, end = after_an_abort(draw, moment, end)
        meanwhile = [act for act in meanwhile if act[0] < moment] + acts_after + [
            [act[0], *act[1:]] for act in meanwhile if act[0] >= moment]
    acts += [[round(moment, 4), what, value] for moment, what, value in meanwhile]
    job["acts"] = list(sensible(acts))
    return job, end


def settings():
    """Of the machine, with overrides up to 200 % and drives that follow within a micrometre or stop it."""
    ini = (simulator.HERE / "machine.ini").read_text().replace("@PLANNER@", "leadscrew_tp jerk=20000")
    ini = ini.replace("@HAL@", "signals.hal").replace("MAX_FEED_OVERRIDE = 1.5", "MAX_FEED_OVERRIDE = 2")
    ini = ini.replace("TYPE = LINEAR\n", "TYPE = LINEAR\nFERROR = 0.001\nMIN_FERROR = 0.001\n")
    hal = (simulator.HERE / "signals.hal").read_text()
    hal = hal.replace("net touch touched.out => motion.probe-input\n", "")  # it would end commands and jogs
    hal = hal.replace("cfg=fffbff", "cfg=fffbffb") + "net jogs motion.teleop-mode => sampler.0.pin.6\n"
    hal += "loadrt limit3 names=x-drive,y-drive,z-drive\n"
    for joint, axis in enumerate("xyz"):
        hal = hal.replace(f"net {axis} joint.{joint}.motor-pos-cmd => joint.{joint}.motor-pos-fb", f"net {axis} joint.{joint}.motor-pos-cmd =>")
        hal += f"addf {axis}-drive servo-thread\nnet {axis} {axis}-drive.in\nnet {axis}-there {axis}-drive.out joint.{joint}.motor-pos-fb\n"
        hal += f"setp {axis}-drive.maxv {1.01 * VELOCITY}\nsetp {axis}-drive.maxa {1.01 * ACCELERATION}\n"
    return ini, hal


def complaint_of(result, end):
    record_text, said, ended = result
    if said:
        return said
    if beyond := Record(record_text).beyond_limits():
        return beyond
    if max(abs(a - b) for a, b in zip(ended["position"], end)) > 1e-9:
        return f"ended at {ended['position'][:3]}, not at {end}"
    return ""


def play(module, numbers, seed):
    """Plays these, and says what is wrong with which."""
    jobs, ends = zip(*(job_of(seed, number) for number in numbers))
    ini, hal = settings()
    results, log = simulator.play(module, "", list(jobs), seconds=60 * len(jobs) + 60, hal="signals.hal", hal_text=hal, ini_text=ini)
    complaints = {}
    for number, job, end in zip(numbers, jobs, ends):
        if complaint := complaint_of(results[job["name"]], end):
            complaints[number] = f"{job['name']}: {complaint}\n{job['acts']}\n{job.get('program', '')[:3000]}"
    return complaints, "\n".join(line for line in log.splitlines() if "leadscrew_tp:" in line)


def main(module, count, seed, *chosen):
    numbers = [int(number) for number in chosen] or list(range(int(count)))
    shares = [numbers[n:n + TOGETHER] for n in range(0, len(numbers), TOGETHER)]
    complaints = {}
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        for found, told in pool.map(lambda share: play(module, share, seed), shares):
            complaints |= found
            for text in filter(None, [*found.values(), told]):
                print(text, flush=True)
    print(f"{len(numbers) - len(complaints)} of {len(numbers)} as they should be, seed {seed}")
    sys.exit(bool(complaints))


if __name__ == "__main__":
    module, numbers = simulator.arguments()
    main(module, *numbers)
