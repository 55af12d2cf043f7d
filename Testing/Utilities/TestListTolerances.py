# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/list-tolerances: the page that it makes of figures that tests have recorded."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.environ["NEXRAD_UTILITIES"], "list-tolerances")

FIGURES = """\
Beam.At128\tRMSE, dBZ\t3.1\t3.3\tmost\t
Beam.At128\tRMSE, dBZ\t3.2\t3.3\tmost\t
Alone.Motion/0\tvoxels\t300\t200\tleast\t
Alone.Motion/1\tvoxels\t260\t200\tleast\t
Alone.Named/KLSX\terror, m\t0\t0\tmost\t
"""
FAR_AWAY = "Picture.Storm\terror to the baseline\t0\t0.5\tmost\tother drivers round differently\n"
UNEXPLAINED = "Picture.Rain\tpixels\t500\t100\tleast\t\n"


class ListTolerances(unittest.TestCase):
    def page(self, figures):
        """The script's exit status and messages, and the page's rows."""
        with tempfile.TemporaryDirectory(prefix="nexrad-tolerances-") as folder:
            file, page = pathlib.Path(folder) / "figures", pathlib.Path(folder) / "page.md"
            file.write_text(figures)
            done = subprocess.run([SCRIPT, "--no-run", "--figures", file, "-o", page], capture_output=True, text=True)
            text = page.read_text(encoding="utf-8")
        return done, text, [line for line in text.splitlines() if line.startswith("| `")]

    def test_latest_figure_of_each_test_in_order(self):
        done, text, rows = self.page(FIGURES)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(rows, ["| `Alone.Motion` | voxels | 260 | ≥ 200 | 1.30 |",
                                "| `Alone.Named/KLSX` | error, m | 0 | ≤ 0 | 1.00 |",
                                "| `Beam.At128` | RMSE, dBZ | 3.2 | ≤ 3.3 | 1.03 |"])
        self.assertIn("3 figures; 3 have a bound within 2 times the figure", text)
        self.assertNotIn("## Bounds further away", text)

    def test_bounds_further_away_have_their_reason(self):
        done, text, rows = self.page(FIGURES + FAR_AWAY)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4 figures; 3 have", text)
        self.assertEqual(rows[-1], "| `Picture.Storm` | error to the baseline | 0 | ≤ 0.5 | other drivers round differently |")
        self.assertLess(text.index("## Bounds further away"), text.index(rows[-1]))

    def test_fails_without_a_reason(self):
        done, _, rows = self.page(FIGURES + UNEXPLAINED)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Picture.Rain: pixels: 500, but the bound is 100\n", done.stderr)
        self.assertEqual(len(rows), 4)


if __name__ == "__main__":
    unittest.main()
