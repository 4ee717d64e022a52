"""^C ends long work soon, whatever it is, and a progress function is heard."""

import signal
import subprocess
import sys
import time
import unittest

import numpy as np

import leadscrew

LONG = "G21 G90 G94\nO1 repeat [100000]\nG1 X200 F600\nX0\nO1 endrepeat\nM2\n"
WORK = {
    "run": "leadscrew.run(text, progress=begun)",
    "check": "leadscrew.check(text, progress=begun)",
    "plan": "leadscrew.plan(text, progress=begun)",
    "simulate": "leadscrew.simulate(text, progress=begun)",
    "verify": "leadscrew.verify(numpy.zeros((4_000_000, 9)), text, progress=begun)",
    "passes": "surface.passes(radius=3, scallop=1e-6, orientation='normal', progress=begun)",
    "study": "begun(); leadscrew.study('tube')",
}
LOOP = "begun()\n    for _ in range(10**12): len(text)"
POSITIONS = np.zeros((4_000_000, 9))
PROMISED = 0.1  # s
TRIES = 6
CHILD = """
import functools, os, sys, numpy, leadscrew
text = {text!r}
x, y = numpy.meshgrid(numpy.linspace(0, 200, 8), numpy.linspace(0, 200, 8), indexing="ij")
surface = leadscrew.Surface(numpy.stack([x, y, 20 * numpy.sin(x / 40) * numpy.cos(y / 40)], axis=2))
@functools.cache
def begins():
    print("begins", flush=True)
def begun(share=0):
    begins()
try:
    {work}
except KeyboardInterrupt:
    print("interrupted", flush=True)
try:
    print("left:", os.waitpid(-1, os.WNOHANG))
except ChildProcessError:
    print("no process is left")
"""


class Interrupts(unittest.TestCase):
    def seconds_to_end(self, work):
        """From ^C to its exception."""
        child = subprocess.Popen([sys.executable, "-B", "-c", CHILD.format(text=LONG, work=work)], stdout=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "begins\n")
        time.sleep(0.2)
        self.assertIsNone(child.poll(), "it has ended by itself")
        begin = time.monotonic()
        child.send_signal(signal.SIGINT)
        line = child.stdout.readline()
        seconds = time.monotonic() - begin
        rest = child.stdout.read()
        child.stdout.close()
        self.assertEqual(child.wait(), 0)
        self.assertEqual((line, rest), ("interrupted\n", "no process is left\n"))
        return seconds

    def test_end_work_within_a_tenth_of_a_second(self):
        # Tests share the processors with others: what a loop of Python alone takes to be interrupted is not counted, and the best of
        # some tries is.
        for name, work in WORK.items():
            with self.subTest(name):
                tries = []
                while len(tries) < TRIES and min(tries, default=PROMISED) >= PROMISED:
                    tries.append(self.seconds_to_end(work) - self.seconds_to_end(LOOP))
                print(f"{name}: {', '.join(f'{seconds:.3f}' for seconds in tries)} s more than a loop of Python")
                self.assertLess(min(tries), PROMISED)


class Changes(unittest.TestCase):
    def test_of_a_path_are_refused_while_it_runs(self):
        zigzag = np.tile([[50, 10, 0], [0, 0, 0]], (10_000, 1))
        path = leadscrew.Path(tolerance=0.05).lines(zigzag, feed=50)
        changes = [lambda: path.line([1, 2, 3]), lambda: path.dwell(1), path.stop, lambda: path.smooth(0.1),
                   lambda: path.curve([[1, 0, 0], [2, 0, 0], [3, 1, 0]])]
        refused = []

        def change(share):
            for each in changes:
                with self.assertRaisesRegex(RuntimeError, "<path>: expected a change of the path before or after its run"):
                    each()
                refused.append(share)
            return False

        for work in (path.run, path.plan, path.simulate, lambda progress: path.verify(POSITIONS, progress=progress)):
            refused.clear()
            with self.assertRaises(leadscrew.ProblemError) as raised:
                work(progress=change)
            self.assertEqual(raised.exception.code, "interrupted")
            self.assertEqual(len(refused), len(changes))
        self.assertEqual(path.end.tolist(), [0, 0, 0])
        path.line([1, 0, 0])  # it is not in use any more
        self.assertEqual(path.end.tolist(), [1, 0, 0])


class Progress(unittest.TestCase):
    def test_tells_shares_in_order(self):
        shares = []
        leadscrew.run("G21 G90 G94\n" + "G1 X100 F6000\nX0\n" * 150 + "M2\n", progress=shares.append)
        self.assertGreater(len(shares), 2)
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(max(shares), 1)

    def test_false_ends_the_run(self):
        with self.assertRaises(leadscrew.ProblemError) as raised:
            leadscrew.run(LONG, progress=lambda share: False)
        self.assertEqual(raised.exception.code, "interrupted")

    def test_its_exception_is_the_callers_own(self):
        def fail(share):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            leadscrew.run(LONG, progress=fail)

    def test_threads_run_beside_each_other(self):
        import threading

        ended = threading.Event()

        def work():
            with self.assertRaises(leadscrew.ProblemError):
                leadscrew.run(LONG, progress=lambda share: not ended.is_set())

        thread = threading.Thread(target=work)
        thread.start()
        counted = 0
        begin = time.monotonic()
        while time.monotonic() - begin < 0.2:
            counted += 1
        ended.set()
        thread.join()
        self.assertGreater(counted, 1000)


if __name__ == "__main__":
    unittest.main()
