# SPDX-License-Identifier: BSD-3-Clause
"""What comes out of the proxies is what the classes and the program make, bit by bit."""

import datetime
import fnmatch
import glob
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy
import Plugin
import SyntheticFiles
import vtknexrad
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkSMPTools

GRID = [48, 40, 24]


def sweeps_of(collection):
    """Names and points of the sweeps, and their arrays, in a form that compares."""
    result = []
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        name = collection.GetMetaData(i).Get(collection.NAME())
        for k in range(collection.GetNumberOfPartitions(i)):
            grid = collection.GetPartition(i, k)
            result.append((name, grid.GetExtent(), grid.GetBounds(), Plugin.point_arrays(grid)))
    return result


def time_steps(reader):
    return [time.timestamp() for time in vtknexrad.time_steps(reader)]


def content_of(folder):
    """The bytes of the volume files in a folder by name."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).glob("*.nxv")}


class PipelineTest(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def assertSameArrays(self, first, second):
        self.assertEqual(set(first), set(second))
        for name in first:
            numpy.testing.assert_array_equal(first[name], second[name], err_msg=name)

    def assertSameVolume(self, first, second):
        self.assertEqual(first.GetDimensions(), second.GetDimensions())
        self.assertEqual(first.GetOrigin(), second.GetOrigin())
        self.assertEqual(first.GetSpacing(), second.GetSpacing())
        arrays = Plugin.point_arrays(first)
        self.assertGreater((arrays["REF_state"] == 0).sum(), 50, "echo is what is compared")
        self.assertSameArrays(arrays, Plugin.point_arrays(second))

    def assertSameSweeps(self, first, second):
        first, second = sweeps_of(first), sweeps_of(second)
        self.assertGreater(len(first), 5)
        self.assertEqual([one[:3] for one in first], [one[:3] for one in second])
        for one, other in zip(first, second):
            self.assertSameArrays(one[3], other[3])


class Sweeps(PipelineTest):
    def test_series_is_the_class_s_at_every_time(self):
        reader = vtknexrad.vtkNexradSeriesReader()
        for path in SyntheticFiles.files():
            reader.AddFileName(path)
        proxy = simple.NEXRADLevelIISeries(FileNames=list(SyntheticFiles.files()))
        self.assertEqual(list(proxy.TimestepValues), time_steps(reader))
        self.assertGreater(len(proxy.TimestepValues), 1)
        for time in proxy.TimestepValues:
            self.assertSameSweeps(Plugin.fetch(proxy, time), vtknexrad.update(reader, time))

    def test_moments_can_be_chosen(self):
        proxy = simple.NEXRADLevelIISeries(FileNames=list(SyntheticFiles.files()[:1]))
        self.assertEqual(list(proxy.Moments), ["REF", "VEL", "SW", "ZDR", "PHI", "RHO", "CFP"])
        proxy.Moments = ["VEL"]
        arrays = {name for sweep in sweeps_of(Plugin.fetch(proxy)) for name in sweep[3]}
        self.assertEqual(arrays, {"VEL", "VEL_state"})

    def test_coordinates_can_be_chosen(self):
        path = SyntheticFiles.files()[0]
        for number, text in enumerate(("Local (metres from the antenna)", "Geographic (degrees)",
                                       "Projected (metres)")):
            reader = vtknexrad.vtkNexradLevel2Reader()
            reader.SetFileName(path)
            reader.SetCoordinates(number)
            proxy = simple.NEXRADLevelIIReader(FileName=path, Coordinates=text)
            self.assertSameSweeps(Plugin.fetch(proxy), vtknexrad.update(reader))

    def test_sites_are_told_apart_by_what_stands_in_the_files(self):
        files = Plugin.real_files("multisite-20100911")
        with tempfile.TemporaryDirectory() as folder:
            for i, path in enumerate(files):
                os.symlink(path, os.path.join(folder, f"file{i}"))
            proxy = simple.NEXRADLevelIISeries(FileNames=[folder])
            names = {sweep[0][:4] for sweep in
                     sweeps_of(Plugin.fetch(proxy, proxy.TimestepValues[-1]))}
        self.assertEqual(names, {os.path.basename(path)[:4] for path in files})


class Merging(PipelineTest):
    def test_day_has_the_class_s_volumes_with_its_settings(self):
        reader = vtknexrad.vtkNexradDayReader()
        for path in SyntheticFiles.files():
            reader.AddFileName(path)
        reader.SetDimensions(*GRID)
        reader.SetRange(150000)
        reader.SetHeightRange(500, 15500)
        reader.SetTimeStep(120)
        reader.SetOption("motion", "none")
        reader.SetOption("sharpening", "off")
        reader.SetOption("ancillary", "on")
        proxy = simple.NEXRADRadarDay(
            FileNames=list(SyntheticFiles.files()), Dimensions=GRID, Range=150000,
            HeightRange=[500, 15500], TimeStep=120, EchoMotion="none", Sharpening=0,
            AncillaryArrays=1)
        self.assertEqual(list(proxy.TimestepValues), time_steps(reader))
        self.assertGreater(len(proxy.TimestepValues), 3)
        for time in (proxy.TimestepValues[1], proxy.TimestepValues[1] + 61.5):
            volume = Plugin.fetch(proxy, time)
            self.assertIn("REF_age", Plugin.point_arrays(volume))
            self.assertSameVolume(volume, vtknexrad.update(reader, time))

    def test_day_shows_the_times_of_its_files_and_takes_others_as_text(self):
        day = simple.NEXRADRadarDay(FileNames=SyntheticFiles.files(), Dimensions=GRID)
        day.UpdatePipelineInformation()
        reader = vtknexrad.vtkNexradDayReader()
        for path in SyntheticFiles.files():
            reader.AddFileName(path)
        reader.UpdateInformation()
        self.assertRegex(day.FirstRay, r"^20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d\.\d\d\dZ$")
        self.assertEqual((day.FirstRay, day.LastRay), (reader.GetFirstRay(), reader.GetLastRay()))
        steps = list(day.TimestepValues)
        self.assertGreater(len(steps), 2)
        day.BeginTime = datetime.datetime.fromtimestamp(steps[1], datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M")
        day.UpdatePipelineInformation()
        self.assertEqual(list(day.TimestepValues), steps[1:])
        self.assertEqual(day.FirstRay, reader.GetFirstRay())

    def test_loops_of_vtk_use_all_cores(self):
        # Debian's ParaView would use one.
        self.assertEqual(vtkSMPTools.GetBackend() == "Sequential",
                         os.environ.get("VTK_SMP_BACKEND_IN_USE") == "Sequential")

    def test_real_day_is_the_program_s(self):
        # The files of REF hold whole dBZ, those of VEL exact numbers.
        files = Plugin.real_files("run-kbgm-20050821")
        for moment in ("REF", "VEL"):
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([os.environ["NEXRAD3D"], "grid", *files, "-o", folder, "--dims",
                                "x".join(map(str, GRID)), "--moment", moment, "--quiet"], check=True)
                made = content_of(folder)
            self.assertEqual(len(made), 6)
            with tempfile.TemporaryDirectory() as folder:
                day = simple.NEXRADRadarDay(FileNames=files, Dimensions=GRID, Moment=moment)
                simple.SaveData(os.path.join(folder, "volumes.nxv.series"), proxy=day)
                self.assertEqual(content_of(folder), made)


class Files(PipelineTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.day = simple.NEXRADRadarDay(
            FileNames=list(SyntheticFiles.files()), Dimensions=GRID, AncillaryArrays=1)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_two_fields_are_the_class_s(self):
        files = SyntheticFiles.files()
        day = simple.NEXRADRadarDay(FileNames=list(files), Dimensions=GRID, Moment="REF,VEL")
        proxy = simple.NEXRADTwoFields(Input=day, ColorArrayName="VEL", OpacityArrayName="REF")
        reader = vtknexrad.vtkNexradDayReader()
        for path in files:
            reader.AddFileName(path)
        reader.SetDimensions(GRID)
        reader.SetMoment("REF,VEL")
        fields = vtknexrad.vtkNexradTwoFields()
        fields.SetInputConnection(reader.GetOutputPort())
        fields.SetColorArrayName("VEL")
        time = day.TimestepValues[0]
        made = Plugin.fetch(proxy, time)
        self.assertSameVolume(made, vtknexrad.update(fields, time))
        both = Plugin.point_arrays(made)["ColorAndOpacity"]
        self.assertGreater((both[:, 0] > -64.0).sum(), 50)

    def test_saved_volume_comes_back(self):
        time = self.day.TimestepValues[0]
        volume = Plugin.fetch(self.day, time)
        simple.SaveData(self.path("one.nxv"), proxy=self.day, Encoding="Float")
        read = simple.OpenDataFile(self.path("one.nxv"))
        self.assertEqual(list(read.TimestepValues), [time])
        self.assertSameVolume(Plugin.fetch(read), volume)
        read.AncillaryArrays = ["REF_age"]
        self.assertEqual({name for name in Plugin.point_arrays(Plugin.fetch(read))},
                         {"REF", "REF_state", "vtkGhostType", "REF_age"})

    def test_saved_series_comes_back_as_index_and_as_files(self):
        simple.SaveData(self.path("day.nxv.series"), proxy=self.day, Encoding="Float")
        files = sorted(glob.glob(self.path("*.nxv")))
        self.assertEqual(len(files), len(self.day.TimestepValues))
        self.assertGreater(len(files), 1)
        for names in ([self.path("day.nxv.series")], files):
            read = simple.OpenDataFile(names)
            self.assertEqual(list(read.TimestepValues), list(self.day.TimestepValues))
            for time in read.TimestepValues:
                self.assertSameVolume(Plugin.fetch(read, time), Plugin.fetch(self.day, time))


class Damage(unittest.TestCase):
    def test_cut_file_is_one_message(self):
        content = pathlib.Path(Plugin.real_files("run-kbgm-20050821")[0]).read_bytes()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "KBGM20050821_024323.gz")
            pathlib.Path(path).write_bytes(content[:400000])
            reader = vtknexrad.vtkNexradDayReader()
            reader.AddFileName(path)
            reader.SetDimensions(GRID)
            warnings = []
            reader.AddObserver("WarningEvent", lambda *_: warnings.append(1))
            reader.Update()
            self.assertEqual(len(warnings), 1)
            self.assertGreater(reader.GetDamage().GetNumberOfValues(), 2, "each fault is listed")


class OpenDialog(unittest.TestCase):
    """Which readers ParaView offers for a file: it asks by name, then the reader by content."""

    # One reader, so that the dialog asks nothing; the menu Sources has those of sweeps.
    level2 = {"NexradRadarDay"}

    def offered(self, path):
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        readers = factory.GetReaders(path, session) if not os.path.isdir(path) \
            else factory.GetPossibleReaders(path, session)
        return {readers.GetString(i) for i in range(1, readers.GetLength(), 3)} & (
            self.level2 | {"NexradLevel2Series", "NexradLevel2Reader", "NexradVolumeReader"})

    def patterns(self):
        """The names that the dialog shows among the supported types."""
        hints = Plugin.make("sources", "NexradRadarDay").GetHints()
        hint = hints.FindNestedElementByName("ReaderFactory")
        return hint.GetAttribute("filename_patterns").split()

    def test_level2_files_are_a_day(self):
        self.assertEqual(self.offered(SyntheticFiles.files()[0]), self.level2)

    def test_names_as_the_archives_write_them(self):
        content = pathlib.Path(SyntheticFiles.files()[0]).read_bytes()
        with tempfile.TemporaryDirectory() as folder:
            for name in ("KLSX20060312_180145", "KLSX20060312_180145.gz", "KTLX20190715_120037_V06",
                         "KTYX20100911_012210_V04.gz", "KCRP20170826_044114.bin",
                         "KVWX_20050626_221551.gz", "Level2_KLSX_20060312_1801.ar2v"):
                path = os.path.join(folder, name)
                pathlib.Path(path).write_bytes(content)
                self.assertEqual(self.offered(path), self.level2, name)
                self.assertTrue(any(fnmatch.fnmatch(name, one) for one in self.patterns()), name)
            path = os.path.join(folder, "KLSX20060312_180146")
            pathlib.Path(path).write_text("no radar")
            self.assertEqual(self.offered(path), set())

    def test_sources_are_in_the_menu(self):
        for name in Plugin.SOURCES:
            shown = Plugin.make("sources", name).GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(shown.GetAttribute("category"), "NEXRAD", name)

    def test_groups_of_names_are_shown(self):
        """The dialog shows names that differ in a number at their end as one, with two points for it."""
        for name in ("KLSX20060312_..", "KTYX20100911_..gz", "Level2_KLSX_20060312_..ar2v"):
            self.assertTrue(any(fnmatch.fnmatch(name, one) for one in self.patterns()), name)

    def test_folder_of_files_is_a_day(self):
        folder = os.path.dirname(SyntheticFiles.files()[0])
        self.assertEqual(self.offered(folder), self.level2)
        with tempfile.TemporaryDirectory() as empty:
            self.assertEqual(self.offered(empty), set())


if __name__ == "__main__":
    unittest.main(verbosity=2)
