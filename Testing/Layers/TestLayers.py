# SPDX-License-Identifier: BSD-3-Clause
"""The checks of layers.py on this source tree, and each of them on a made-up tree with one fault."""

import os
import pathlib
import tempfile
import unittest

import layers


class ThisTree(unittest.TestCase):
    """Each check finds no fault."""

    root = os.environ["NEXRAD_SOURCE_TREE"]

    def expect_none(self, check):
        faults = check(self.root)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_folders_of_core_include_those_named_before_them(self):
        self.expect_none(layers.check_core_order)

    def test_core_does_without_vtk(self):
        self.expect_none(layers.check_core_without_vtk)

    def test_modules_include_downwards(self):
        self.expect_none(layers.check_modules)

    def test_folders_include_each_other_in_no_circle(self):
        self.expect_none(layers.check_circles_of_folders)

    def test_files_include_each_other_in_no_circle(self):
        self.expect_none(layers.check_circles_of_files)

    def test_sources_have_headers_of_their_names(self):
        self.expect_none(layers.check_own_headers)

    def test_each_exception_is_needed(self):
        self.expect_none(layers.check_exceptions)

    def test_components_of_vtk_are_linked(self):
        self.expect_none(layers.check_vtk_components)

    def test_includes_are_seen(self):
        """A search that found nothing would find no fault either."""
        includes = layers.Includes(self.root).of_tree
        self.assertIn(("Source/Core/Level2/Level2File.h", "Source/Core/Model/RadarVolume.h"), includes)
        self.assertGreater(len(includes), 1000)


class MadeUpTrees(unittest.TestCase):
    """Each check finds the one fault that a small tree has, and none without it."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="nexrad-layers-")
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        self.write("Source/Core/CMakeLists.txt", "foreach(folder IN ITEMS System Model\n    Motion)\n")
        self.write("Source/Core/System/Error.h")
        self.write("Source/Core/Model/Site.h", '#include "nexrad/System/Error.h"')
        self.write("Source/Core/Model/Site.cxx", '#include "nexrad/Model/Site.h"', "#include <vector>")
        self.write("Source/Core/Motion/Field.h", '#include "nexrad/Model/Site.h"')
        self.write("Source/Rendering/vtkMapper.h")
        self.write("Source/Rendering/Tiles/vtkTiles.h", '#include "vtkTilePolygon.h"')
        self.write("Source/Rendering/Tiles/vtkTilePolygon.h")
        self.write("Source/Rendering/vtkMapper.cxx", '#include "vtkMapper.h"', '#include "vtkTiles.h"')
        self.write("Source/IO/vtkReader.h", '#include "vtkImageAlgorithm.h"')
        self.write("Source/Filters/vtkMerge.h", '#include "vtkReader.h"')
        self.write("Source/Application/main.cxx", '#include "vtkMerge.h"')
        self.write("Testing/IO/TestReader.cxx")

    def write(self, path, *lines):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")

    def expect_one(self, check, *words):
        faults = check(self.root)
        self.assertEqual(len(faults), 1, faults)
        for word in words:
            self.assertIn(word, faults[0])

    def test_without_a_fault(self):
        for check in (layers.check_core_order, layers.check_core_without_vtk, layers.check_modules,
                      layers.check_circles_of_folders, layers.check_circles_of_files,
                      layers.check_own_headers):
            with self.subTest(check.__name__):
                self.assertEqual(check(self.root), [])

    def test_a_folder_of_core_that_includes_a_later_one(self):
        self.write("Source/Core/Model/Day.h", '  #  include "nexrad/Motion/Field.h"')
        self.expect_one(layers.check_core_order, "Source/Core/Model/Day.h", "Source/Core/Motion/Field.h")

    def test_a_folder_of_core_without_a_place(self):
        self.write("Source/Core/Quality/Speckle.h")
        self.expect_one(layers.check_core_order, "Source/Core/Quality", "does not name")

    def test_core_with_vtk(self):
        self.write("Source/Core/Model/Day.h", "#include <vtkImageData.h>")
        self.expect_one(layers.check_core_without_vtk, "Source/Core/Model/Day.h", "vtkImageData.h")

    def test_a_module_that_includes_upwards(self):
        self.write("Source/IO/vtkWriter.h", '#include "vtkMerge.h"')
        self.expect_one(layers.check_modules, "Source/IO/vtkWriter.h", "IO may not include Filters")

    def test_drawing_that_includes_core(self):
        self.write("Source/Rendering/vtkColours.h", '#include "nexrad/System/Error.h"')
        self.expect_one(layers.check_modules, "Rendering may not include Core")

    def test_an_unknown_module(self):
        self.write("Source/Extras/Helper.h")
        self.expect_one(layers.check_modules, "Source/Extras")

    def test_a_circle_of_two_folders(self):
        self.write("Source/Rendering/Tiles/vtkTilePolygon.h", '#include "vtkMapper.h"')
        self.expect_one(layers.check_circles_of_folders, "Source/Rendering, Source/Rendering/Tiles",
                        "vtkTilePolygon.h includes Source/Rendering/vtkMapper.h")

    def test_a_circle_of_three_folders(self):
        self.write("Source/Core/System/Error.h", '#include "nexrad/Motion/Field.h"')
        self.expect_one(layers.check_circles_of_folders, "Source/Core/Model, Source/Core/Motion, Source/Core/System")

    def test_a_circle_of_two_files(self):
        self.write("Source/Core/Model/Ray.h", '#include "nexrad/Model/Site.h"')
        self.write("Source/Core/Model/Site.cxx", '#include "nexrad/Model/Site.h"', '#include "nexrad/Model/Ray.h"')
        self.expect_one(layers.check_circles_of_files, "Source/Core/Model/Ray, Source/Core/Model/Site",
                        "Ray.h includes Source/Core/Model/Site.h")

    def test_a_source_without_its_header(self):
        self.write("Source/Core/Model/Day.cxx", '#include "nexrad/Model/Site.h"')
        self.expect_one(layers.check_own_headers, "Source/Core/Model/Day.cxx")

    def test_a_component_of_vtk_that_nothing_links(self):
        self.write("CMake/NexradVTK.cmake", "find_package(VTK 9.1 REQUIRED COMPONENTS",
                   "  CommonCore IOXML IOMovie", "  OPTIONAL_COMPONENTS Python)")
        self.write("Source/IO/vtk.module", "DEPENDS", "  VTK::CommonCore")
        self.write("Testing/IO/CMakeLists.txt", "target_link_libraries(TestReader PRIVATE VTK::IOXML)")
        self.expect_one(layers.check_vtk_components, "IOMovie")

    def test_an_exception_that_nothing_needs(self):
        faults = layers.check_exceptions(self.root)
        self.assertTrue(any("LibraryEntry" in fault for fault in faults), faults)
        self.assertFalse(any("main.cxx" in fault for fault in faults), faults)


if __name__ == "__main__":
    unittest.main()
