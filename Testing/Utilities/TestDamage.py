# SPDX-License-Identifier: BSD-3-Clause
"""The script that damages a synthetic day: what it finds in 36 minutes, and that its checks can fail."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

UTILITIES = pathlib.Path(os.environ["NEXRAD_UTILITIES"])
PROGRAM = os.environ["NEXRAD3D"]


def load_script():
    loader = importlib.machinery.SourceFileLoader("try_damage", str(UTILITIES / "try-damage"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class PartOfADay(unittest.TestCase):
    def test_damage_is_named_and_changes_nothing_else(self):
        """Three radars; of 21 files one is cut, one has a wrong bit, one is missing."""
        run = subprocess.run(
            [sys.executable, UTILITIES / "try-damage", "--program", PROGRAM, "--hours", "0.6", "--rate", "5", "--dims", "48x48x16"],
            capture_output=True, text=True, timeout=280, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        report = json.loads(run.stdout)
        self.assertEqual(report["names"]["not_named"], [])
        self.assertEqual(report["volumes"]["other_bytes"], [])
        self.assertEqual(report["names"]["named"], 2)
        self.assertGreaterEqual(report["volumes"]["untouched"], 1)


class TheChecksThemselves(unittest.TestCase):
    def setUp(self):
        self.script = load_script()
        self.folder = tempfile.TemporaryDirectory()
        self.files = pathlib.Path(self.folder.name)
        self.names = [f"KLSX20060312_{minute // 60 + 18}{minute % 60:02d}00" for minute in range(0, 60, 5)]
        for name in self.names:
            (self.files / name).write_bytes(b"")

    def tearDown(self):
        self.folder.cleanup()

    def test_a_file_that_is_not_named_is_found(self):
        kinds = {"cut": [self.names[0]], "flipped": self.names[1:3], "missing": [], "harmless": [self.names[2]]}
        found = self.script.compare_names(self.names, kinds, [f"/a/{self.names[0]}: cut", f"/a/{self.names[5]}: no reason"])
        self.assertEqual(found["not_named"], [self.names[1]])
        self.assertEqual(found["named_without_damage"], [self.names[5]])

    def test_times_about_a_damaged_file_are_touched(self):
        [(begin, end)] = self.script.touched_spans(self.files, {"cut": [self.names[3]], "flipped": [], "missing": []})
        self.assertEqual((begin.minute, begin.second, end.minute, end.second), (9, 59, 25, 1))

    def test_a_volume_with_other_bytes_is_found(self):
        folders = [self.files / "clean", self.files / "damaged"]
        for folder, content in zip(folders, (b"one", b"two")):
            folder.mkdir()
            (folder / "20060312T180000Z.nxv").write_bytes(content)
            (folder / "20060312T183000Z.nxv").write_bytes(b"same")
        found = self.script.compare_steps(*folders, [])
        self.assertEqual((found["untouched"], found["other_bytes"]), (2, ["20060312T180000Z.nxv"]))

    def test_a_flipped_bit_that_changes_nothing_is_harmless(self):
        """The sign of a record's length has no meaning for its content."""
        content = b"AR2V0001.001" + bytes(12)
        record = self.script.bz2.compress(b"rays" * 100)
        whole = content + len(record).to_bytes(4, "big") + record
        signed = content + (-len(record)).to_bytes(4, "big", signed=True) + record
        broken = whole[:-20] + bytes([whole[-20] ^ 1]) + whole[-19:]
        self.assertEqual(self.script.records_of(whole), self.script.records_of(signed))
        self.assertIsNone(self.script.records_of(broken))
        self.assertIsNone(self.script.records_of(whole[:-1]))

    def test_a_rate_above_what_is_possible_is_refused(self):
        run = subprocess.run([sys.executable, UTILITIES / "try-damage", "--rate", "40"], capture_output=True, text=True,
                             timeout=60, check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("at most 30", run.stderr)


if __name__ == "__main__":
    unittest.main()
