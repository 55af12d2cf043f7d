# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of nexrad3d render as the validator of the Khronos Group reads them."""

import json
import os
import pathlib
import subprocess
import unittest

import files

# Prints what the validator reports of the files that it is given, as one JSON list.
VALIDATE = """
const fs = require("fs");
const validator = require(process.env.GLTF_VALIDATOR);
const validate = (path) =>
  validator.validateBytes(new Uint8Array(fs.readFileSync(path)), { uri: path, maxIssues: 0 });
Promise.all(process.argv.slice(1).map(validate)).then((reports) => console.log(JSON.stringify(reports)));
"""


def reports(paths):
    run = subprocess.run([os.environ["NODE"], "-e", VALIDATE, "--", *map(str, paths)], capture_output=True, text=True,
                         check=True)
    return json.loads(run.stdout)


class Validator(unittest.TestCase):
    def test_it_finds_a_fault(self):
        """A report without errors says something only where a wrong file has some."""
        path = pathlib.Path(files.FOLDER.name) / "wrong.glb"
        path.write_bytes(b"glTF" + bytes(20))
        self.assertGreater(reports([path])[0]["issues"]["numErrors"], 0)

    def test_surfaces_have_no_faults(self):
        folder = pathlib.Path(files.FOLDER.name) / "surfaces"
        folder.mkdir()
        volumes = files.gridded("--format", "nxv", "--moment", "REF,VEL")
        files.nexrad3d("render", volumes, "-o", folder / "surfaces.glb", "--iso-values", "20:0.3,40:0.6,50:1",
                       "--rings", "50km", "--quiet")
        files.nexrad3d("render", volumes, "-o", folder / "crop.glb", "--crop", "-50km,50km,-50km,50km,0,9km",
                       "--section", "-40km,0km,40km,0km", "--quiet")
        files.nexrad3d("render", volumes, "-o", folder / "velocity.glb", "--moment", "VEL", "--iso-values", "-5,5",
                       "--quiet")
        paths = sorted(folder.glob("*.glb"))
        self.assertGreaterEqual(len(paths), 6)
        for path, report in zip(paths, reports(paths), strict=True):
            with self.subTest(path.name):
                print(f"{path.name}: {path.stat().st_size} bytes, {report['info']['totalTriangleCount']} triangles")
                issues = report["issues"]
                self.assertEqual((issues["numErrors"], issues["numWarnings"]), (0, 0), issues["messages"][:5])
                self.assertEqual(report["mimeType"], "model/gltf-binary")


if __name__ == "__main__":
    unittest.main()
