# SPDX-License-Identifier: BSD-3-Clause
"""The installed plugin loads its libraries from beside itself, and works."""

import os
import unittest

import SyntheticFiles
from paraview import simple

LIBRARIES = {"VTKNexrad", "libVTKNexradCore", "libvtkNexradIO", "libvtkNexradFilters",
             "libvtkNexradRendering", "libvtkNexradScene", "libvtkNexradRepresentations", "libvtkNexradAnnotations"}


class Installed(unittest.TestCase):
    def test_libraries_come_from_the_plugin_s_folder(self):
        plugin = os.path.realpath(os.environ["NEXRAD_PLUGIN"])
        simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
        with open("/proc/self/maps") as maps:
            loaded = {line.split()[-1] for line in maps if "nexrad" in os.path.basename(line).lower()}
        self.assertEqual({os.path.dirname(path) for path in loaded}, {os.path.dirname(plugin)})
        self.assertEqual({os.path.basename(path).split(".")[0] for path in loaded}, LIBRARIES)

        day = simple.NEXRADRadarDay(FileNames=list(SyntheticFiles.files()), Dimensions=[16, 16, 8])
        day.UpdatePipeline()
        self.assertGreater(day.PointData["REF"].GetRange()[1], 20.0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
