"""Each example runs and draws its picture; the ones beside the examples are small, and none is missing."""

import contextlib
import io
import pathlib
import runpy
import sys
import tempfile
import unittest
from unittest import mock

from common import TREE

FOLDER = TREE / "python" / "examples"
EXAMPLES = sorted(FOLDER.glob("[0-9]*.py"))
LARGEST_PICTURE = 60_000  # bytes


class Examples(unittest.TestCase):
    def test_run_and_draw(self):
        sys.path.insert(0, str(FOLDER))
        with tempfile.TemporaryDirectory() as made:
            for script in EXAMPLES:
                with self.subTest(script.stem), mock.patch.object(sys, "argv", [str(script), made]):
                    told = io.StringIO()
                    with contextlib.redirect_stdout(told):
                        runpy.run_path(str(script), run_name="__main__")
                    self.assertEqual(told.getvalue().splitlines()[-1], f"{script.stem}.png")
                    picture = (pathlib.Path(made) / f"{script.stem}.png").read_bytes()
                    self.assertTrue(picture.startswith(b"\x89PNG"))

    def test_are_ten_with_a_picture_each(self):
        self.assertEqual([script.stem[:2] for script in EXAMPLES], [f"{i:02}" for i in range(1, 11)])
        for script in EXAMPLES:
            picture = script.with_suffix(".png")
            self.assertTrue(picture.exists(), picture)
            self.assertLess(picture.stat().st_size, LARGEST_PICTURE, picture)


if __name__ == "__main__":
    unittest.main()
