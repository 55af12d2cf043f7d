# SPDX-License-Identifier: BSD-3-Clause
"""The session of the user guide, in a program of its own, and a second one that opens its state."""

import os
import subprocess
import sys
import tempfile
import unittest

import Plugin

PICTURES = ("radars-slices", "storm-sweeps", "storm-first", "storm-slices", "storm-paraview", "storm-cores")


class Session(unittest.TestCase):
    def run_session(self, *arguments):
        done = subprocess.run(
            [os.environ["NEXRAD_PVPYTHON"], os.environ["NEXRAD_SESSION"],
             os.environ["NEXRAD_PLUGIN"], *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=200)
        sys.stdout.write(done.stdout)
        self.assertEqual(done.returncode, 0)

    def test_session_and_its_state(self):
        level2 = os.path.dirname(os.path.dirname(Plugin.real_files("run-kbgm-20050821")[0]))
        with tempfile.TemporaryDirectory() as folder:
            self.run_session(level2, folder)
            pictures = {name: Plugin.picture(os.path.join(folder, name + ".png")) for name in PICTURES}
            for i, name in enumerate(PICTURES):
                for other in PICTURES[:i]:
                    self.assertGreater(Plugin.difference(pictures[name], pictures[other])[0], 0.05,
                                       f"{name} and {other}")
            self.assertGreater(os.path.getsize(os.path.join(folder, "storm.ogv")), 10000)

            self.run_session(folder)
            again = Plugin.picture(os.path.join(folder, "storm-again.png"))
            self.assertEqual(Plugin.difference(again, pictures["storm-cores"]), (0.0, 0.0))


if __name__ == "__main__":
    unittest.main(verbosity=2)
