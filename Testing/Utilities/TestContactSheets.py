# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/make-contact-sheets as a user runs it, on a few minutes of one synthetic radar."""

import glob
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.environ["NEXRAD_UTILITIES"], "make-contact-sheets")


def run(*arguments, **environment):
    return subprocess.run([SCRIPT, *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, **environment})


def picture_size(path):
    """Width and height from a PNG file's header."""
    return struct.unpack(">II", pathlib.Path(path).read_bytes()[16:24])


class ContactSheets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="nexrad-sheets-")
        cls.root = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def folder(self, name):
        """An empty folder of the test's own."""
        path = self.root / self.id().split(".")[-1] / name
        path.mkdir(parents=True)
        return path

    def simulate(self, folder, site):
        """A file of six minutes of a synthetic radar."""
        subprocess.run([os.environ["NEXRAD3D"], "simulate", folder, "--sites", site, "--hours", "0.1",
                        "--quiet"], check=True)
        files = [path for path in glob.glob(str(folder / "**"), recursive=True) if os.path.isfile(path)]
        return pathlib.Path(sorted(files)[0])

    def test_one_sheet_a_file_of_several_radars(self):
        radar, sheets = self.folder("radar"), self.root / "sheets"
        first = self.simulate(radar / "one", "KLSX")
        chunks = radar / "KILX"
        chunks.mkdir()
        shutil.move(self.simulate(self.folder("other"), "KILX"), chunks / "20060312-180000-001-S")
        (radar / "README").write_text("No radar file.\n")

        done = run(radar, "-o", sheets, "--size", "200x176", "--grid", "--no-sharpening",
                   "--draw", "--preset 'clear air'")

        self.assertEqual(done.returncode, 3, done.stderr)
        names = sorted(path.name for path in sheets.glob("*.png"))
        sheet_of_file = str(first.relative_to(radar)).replace("/", "-") + ".png"
        self.assertEqual(names, sorted([sheet_of_file, "KILX.png"]))
        for name in names:
            width, height = picture_size(sheets / name)
            self.assertEqual(width, 3 * 200)
            self.assertGreater(height, 2 * 176)
        page = (sheets / "index.html").read_text(encoding="utf-8")
        self.assertRegex(page, "KLSX · 2006-03-12 18:0.:.. UTC · VCP 11 · message 1")
        self.assertRegex(page, "KILX · 2006-03-12 18:0.:.. UTC · VCP 12 · message 1")
        self.assertIn(f"{radar}/README: ", page)
        self.assertEqual(done.stdout.splitlines()[-1], f"{radar}/README")

    def test_names_what_cannot_be_read(self):
        radar = self.folder("radar")
        for name in ("a", "b"):
            (radar / name).write_text("No radar file.\n")
        done = run(radar, "-o", radar.parent / "sheets")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout.splitlines()[-2:], [f"{radar}/a", f"{radar}/b"])
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 2, done.stderr)
        for name, line in zip("ab", lines):
            self.assertIn(f"{radar}/{name}: left out: ", line)
            self.assertIn("no ray can be read", line)

    def test_names_what_the_program_refuses(self):
        radar = self.folder("radar")
        self.simulate(radar, "KLSX")
        done = run(radar, "-o", radar.parent / "sheets", "--draw", "--preset 'no such'", "--maps", "3km")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "left out: .*no such")

    def test_wrong_usage_is_one_line(self):
        radar = self.folder("radar")
        for arguments, said in (
            ([], "no folder of radar files is named"),
            ([radar], "no folder for the sheets is named"),
            ([radar, "-o"], "-o needs a value"),
            ([radar, "-o", radar, "--sise", "1x1"], "there is no option --sise"),
            ([radar / "none", "-o", radar], "radar/none is no folder"),
            ([radar, "-o", radar, "--program", radar / "none"], "there is no program"),
        ):
            with self.subTest(said):
                done = run(*arguments)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
