"""What docs/python.md shows is what comes of it."""

import doctest
import os
import unittest

from common import TREE


class Guide(unittest.TestCase):
    def test_shows_what_comes_of_it(self):
        os.chdir(TREE)
        found = doctest.testfile(str(TREE / "docs" / "python.md"), module_relative=False,
                                 optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
        self.assertGreater(found.attempted, 20)
        self.assertEqual(found.failed, 0)


if __name__ == "__main__":
    unittest.main()
