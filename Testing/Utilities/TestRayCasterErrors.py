# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/show-ray-caster-errors: the figures of this project's mapper, and the controls of VTK's ray caster."""

import os
import subprocess
import sys
import unittest

SCRIPT = os.path.join(os.environ["NEXRAD_UTILITIES"], "show-ray-caster-errors")

# What the slices share with VTK's ray caster; Documentation/Developer/ray-caster-errors.md says so.
SHARED = {
    # Differences over n / (n - 1) voxels along an axis of n points.
    "normals: a box of 17 x 17 x 5 points, headlight",
}


def run(*arguments, **environment):
    """The script's exit status, and its lines."""
    done = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True,
                          env=dict(os.environ, **environment))
    return done.returncode, (done.stdout if done.returncode < 2 else done.stderr).splitlines()


def figures(lines):
    """What was measured → "right" or "WRONG"."""
    words = [line.split("  ", 1)[0].strip() for line in lines]
    return {what: line.split()[-1] for what, line in zip(words, lines) if line.endswith(("right", "WRONG"))}


class RayCasterErrors(unittest.TestCase):
    def test_slices_are_right_but_for_what_the_page_names(self):
        status, lines = run(VTK_AUTOLOAD_PATH=os.environ["NEXRAD_OVERRIDE"])
        self.assertEqual(status, 0)
        self.assertIn("vtkOpenGLTextureSliceVolumeMapper", lines[0])
        found = figures(lines)
        self.assertGreater(len(found), 50)
        self.assertEqual({what for what, word in found.items() if word == "WRONG"}, SHARED)

    def test_controls_of_the_ray_caster_are_right(self):
        status, lines = run()
        self.assertEqual(status, 0)
        self.assertIn("vtkOpenGLGPUVolumeRayCastMapper", lines[0])
        controls = {what: word for what, word in figures(lines).items() if ": control, " in what}
        self.assertGreater(len(controls), 15)
        self.assertEqual({what for what, word in controls.items() if word != "right"}, set())

    def test_a_part_as_a_markdown_table(self):
        status, lines = run("--markdown", "gray", "--fixed-point")
        self.assertEqual(status, 0)
        self.assertIn("| gray: a gray function of 0.25 | 63.8 | 64.0 | right |", lines)

    def test_an_unknown_check_is_named(self):
        status, lines = run("gravy")
        self.assertEqual(status, 2)
        self.assertIn("there is no check gravy; there are labels, ", lines[-1])


if __name__ == "__main__":
    unittest.main()
