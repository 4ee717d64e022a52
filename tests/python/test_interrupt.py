"""^C ends long work soon, whatever it is, and a progress function is heard."""

import signal
import subprocess
import sys
import time
import unittest

import leadscrew

LONG = "G21 G90 G94\nO1 repeat [100000]\nG1 X200 F600\nX0\nO1 endrepeat\nM2\n"
WORK = {
    "run": "leadscrew.run(text)",
    "check": "leadscrew.check(text)",
    "plan": "leadscrew.plan(text)",
    "simulate": "leadscrew.simulate(text)",
    "verify": "leadscrew.verify(__import__('numpy').zeros((4_000_000, 3)), text)",
    "passes": "surface.passes(radius=3, scallop=1e-6, orientation='normal')",
}
CHILD = """
import sys, time, numpy, leadscrew
text = {text!r}
x, y = numpy.meshgrid(numpy.linspace(0, 200, 8), numpy.linspace(0, 200, 8), indexing="ij")
surface = leadscrew.Surface(numpy.stack([x, y, 20 * numpy.sin(x / 40) * numpy.cos(y / 40)], axis=2))
print("begins", flush=True)
try:
    {work}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


class Interrupts(unittest.TestCase):
    def test_end_work_within_a_tenth_of_a_second(self):
        for name, work in WORK.items():
            with self.subTest(name):
                child = subprocess.Popen([sys.executable, "-B", "-c", CHILD.format(text=LONG, work=work)],
                                         stdout=subprocess.PIPE, text=True)
                self.assertEqual(child.stdout.readline(), "begins\n")
                time.sleep(0.5)
                self.assertIsNone(child.poll(), "it has ended by itself")
                begin = time.monotonic()
                child.send_signal(signal.SIGINT)
                line = child.stdout.readline()
                seconds = time.monotonic() - begin
                child.stdout.close()
                self.assertEqual(child.wait(), 0)
                self.assertEqual(line, "interrupted\n")
                print(f"{name}: {seconds:.3f} s")
                # 0.1 s by itself; tests share the processors with others.
                self.assertLess(seconds, 2)


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
