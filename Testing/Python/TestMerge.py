# SPDX-License-Identifier: BSD-3-Clause
"""vtknexrad.merge, and volumes and series as open gives them."""

import datetime
import filecmp
import functools
import glob
import html
import inspect
import os
import pathlib
import re
import signal
import subprocess
import threading
import time
import unittest
from unittest import mock
from xml.etree import ElementTree

import numpy
import vtknexrad
from vtknexrad import State, merging
from vtkmodules.vtkCommonDataModel import vtkImageData

import Geodesy
import SyntheticFiles
from Tolerance import at_most

DIMS = (40, 36, 16)
IN_METRES = {"range": "230000m", "overlap_length": "100000m", "height": "0m,20000m"}


def path_of(name):
    return os.path.join(SyntheticFiles.folder(), name)


def grid(name, *options):
    """The folder of what `nexrad3d grid` merges of the files."""
    folder = path_of(name)
    if not os.path.isdir(folder):
        subprocess.run([os.environ["NEXRAD3D"], "grid", *SyntheticFiles.files(), "-o", folder, "--dims",
                        "x".join(map(str, DIMS)), "--quiet", *options], check=True)
    return folder


@functools.lru_cache(maxsize=None)
def exact():
    """A folder with the moments REF and VEL and ancillary arrays, in exact values."""
    return grid("exact", "--moment", "REF,VEL", "--ancillary", "--code", "exact")


def merge(**options):
    return vtknexrad.merge(SyntheticFiles.files(), dims=DIMS, **options)


class Merges(unittest.TestCase):
    def equal(self, ours, theirs):
        self.assertEqual(len(ours), len(theirs))
        numpy.testing.assert_array_equal(ours.times, theirs.times)
        for mine, other in zip(ours, theirs):
            self.assertEqual((mine.moments, mine.ancillary, mine.sites, mine.method, mine.projection),
                             (other.moments, other.ancillary, other.sites, other.method, other.projection))
            for name in mine.moments + mine.ancillary:
                numpy.testing.assert_array_equal(mine[name].states, other[name].states)
                numpy.testing.assert_array_equal(mine[name].filled(0), other[name].filled(0))

    def test_the_usual_merge_is_that_of_the_program(self):
        self.equal(merge(moments=["REF", "VEL"], ancillary=True), vtknexrad.open(exact()))

    def test_options_are_those_of_the_program(self):
        options = dict(step=datetime.timedelta(minutes=4), begin="2006-03-12T18:04", end=numpy.datetime64(
            "2006-03-12T18:12:00"), max_gap=600.0, bounds=(-92.0, 37.8, -89.5, 39.6), height=(500.0, 12e3),
            quality="off", despeckle=4, bias={"KLSX": 1.5}, overlap="nearest", fill_columns=True,
            linear_reflectivity=True, motion=(5.0, -3.0))
        folder = grid("options", "--code", "exact", "--step", "4min", "--begin", "2006-03-12T18:04", "--end",
                      "2006-03-12T18:12", "--max-gap", "10min", "--bounds=-92,37.8,-89.5,39.6", "--height", "0.5km,12km",
                      "--quality", "off", "--despeckle", "4", "--bias", "KLSX:1.5", "--overlap", "nearest",
                      "--fill-columns", "--linear-reflectivity", "--motion=5,-3")
        self.equal(merge(**options), vtknexrad.open(folder))

    def test_further_options_are_those_of_the_program(self):
        folder = grid("further", "--code", "exact", "--quality", "strict", "--no-sharpening", "--overlap-length", "50km")
        self.equal(merge(quality="strict", sharpening=False, overlap_length=50e3), vtknexrad.open(folder))

    def test_options_of_velocities(self):
        folder = grid("velocities", "--code", "exact", "--moment", "SRV,VEL", "--no-dealiasing", "--storm-motion=10,4",
                      "--range", "100km", "--motion", "none")
        self.equal(merge(moments="SRV,VEL", dealiasing=False, storm_motion=(10.0, 4.0), range=100e3, motion="none"),
                   vtknexrad.open(folder))

    def test_the_method_thesis(self):
        self.equal(merge(method="thesis"), vtknexrad.open(grid("thesis", "--method", "thesis", "--code", "exact")))

    def test_what_is_written_is_what_the_program_writes(self):
        folder = grid("written")
        index = merge().write(path_of("ours"))
        self.assertEqual(index, os.path.join(path_of("ours"), "volumes.nxv.series"))
        names = sorted(os.listdir(folder))
        self.assertEqual(sorted(os.listdir(path_of("ours"))), names)
        self.assertEqual(filecmp.cmpfiles(folder, path_of("ours"), names, shallow=False), (names, [], []))

    def test_any_time_of_a_merge(self):
        when = datetime.datetime(2006, 3, 12, 18, 7, 30)
        day = vtknexrad.vtkNexradDayReader()
        for path in SyntheticFiles.files():
            day.AddFileName(path)
        day.SetDimensions(DIMS)
        expected = vtknexrad.array(vtknexrad.update(day, when))
        volume = merge().at(when)
        self.assertEqual(volume.time, numpy.datetime64("2006-03-12T18:07:30"))
        numpy.testing.assert_array_equal(volume["REF"].values.data, expected)

    def test_volumes_do_not_change_with_the_next(self):
        series = merge()
        first = series[0]
        kept = first["REF"].values.copy()
        self.assertTrue((series[1]["REF"].values.data != kept.data).any())
        numpy.testing.assert_array_equal(first["REF"].values.data, kept.data)

    def test_durations_and_dims_as_text(self):
        for step, dims in ((300.0, DIMS), ("5min", "40x36x16"), ("300s", "40,36,16"), (datetime.timedelta(minutes=5), [*DIMS])):
            series = vtknexrad.merge(SyntheticFiles.files(), dims=dims, step=step)
            self.assertEqual((len(series), series[0].shape), (3, DIMS[::-1]))

    def test_other_threads_go_on(self):
        ticks, end = [time.perf_counter()], threading.Event()

        def tick():
            while not end.is_set():
                time.sleep(0.001)
                ticks.append(time.perf_counter())

        ticking = threading.Thread(target=tick)
        ticking.start()
        begin = time.perf_counter()
        volume = vtknexrad.merge(SyntheticFiles.files(), dims=(256, 256, 128))[0]
        lasted = time.perf_counter() - begin
        end.set()
        ticking.join()
        self.assertEqual(volume.shape, (128, 256, 256))
        self.assertGreater(lasted, 0.1)
        # Where the interpreter stood still, nearly all of it was silent.
        self.assertLess(max(numpy.diff(ticks)), 0.5 * lasted)

    def test_a_break_stops_a_merge(self):
        def stop(*_):
            raise KeyboardInterrupt

        series = vtknexrad.merge(SyntheticFiles.files(), dims=(256, 256, 128))
        before = signal.signal(signal.SIGALRM, stop)
        signal.setitimer(signal.ITIMER_REAL, 0.03)
        try:
            with self.assertRaises(KeyboardInterrupt):
                series[0]  # pylint: disable=pointless-statement
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            signal.signal(signal.SIGALRM, before)
        again = vtknexrad.merge(SyntheticFiles.files(), dims=(256, 256, 128))[0]
        numpy.testing.assert_array_equal(series[0]["REF"].values.data, again["REF"].values.data)

    def test_one_path_is_enough(self):
        series = vtknexrad.merge(pathlib.Path(SyntheticFiles.files()[0]), dims=(4, 4, 4))
        self.assertEqual(len(series), 1)

    def test_a_radar_s_name_and_axes_in_degrees(self):
        volume = merge(site="KEAX", axes="geographic")[0]
        self.assertEqual(volume.sites, ("KEAX",))
        self.assertTrue(volume.is_geographic)
        numpy.testing.assert_allclose(volume.longitude[7], volume.x)
        numpy.testing.assert_allclose(volume.latitude[:, 7], volume.y)


class Refusals(unittest.TestCase):
    def refuse(self, text, **options):
        with self.assertRaises(ValueError) as caught:
            vtknexrad.merge(SyntheticFiles.files(), **options)
        self.assertEqual(str(caught.exception), text)

    def test_parameters_that_cannot_be(self):
        self.refuse("quality is 'good'; it must be one of off, standard, strict", quality="good")
        self.refuse("method is 'mean'; it must be one of beam, thesis", method="mean")
        self.refuse("overlap is 1; it must be one of mean, nearest, maximum, distance", overlap=1)
        self.refuse("axes is 'km'; it must be one of projected, geographic", axes="km")
        self.refuse("motion is 'off'; it must be one of estimated, none", motion="off")
        self.refuse("motion has 3 numbers; it must have 2: m/s to the east, m/s to the north", motion=(1, 2, 3))
        self.refuse("bounds has 2 numbers; it must have 4: west, south, east, north", bounds=(1, 2))
        self.refuse("dims has 2 numbers; it must have three: voxels to the east, north and upward", dims=(2, 3))
        self.refuse("a number of dims is 0; it must be a whole number from 1 to 1073741824", dims=(2, 3, 0))
        self.refuse("despeckle is 27; it must be a whole number from 0 to 26", despeckle=27)
        self.refuse("step is 0; it must be above 0", step=0)
        self.refuse("step is 0; it must be above 0", step="0min")
        self.refuse("'5 minutes' is no duration; write a number and s, min, h, d, as in '5min'", step="5 minutes")
        self.refuse("range is nan; it must be above 0", range=float("nan"))
        self.refuse("max_gap is -1 s; it must not be negative", max_gap=-1)
        self.refuse("'noon' is no time; write it as 2006-03-12T18:05", begin="noon")

    def test_parameters_that_are_none(self):
        with self.assertRaisesRegex(TypeError, r"^merge\(\) has no parameter smoothing$"):
            vtknexrad.merge(SyntheticFiles.files(), smoothing=True)

    def test_no_files(self):
        with self.assertRaisesRegex(ValueError, "^there are no files to merge$"):
            vtknexrad.merge([])
        with self.assertRaisesRegex(FileNotFoundError, "^/nowhere: no such file or folder$"):
            vtknexrad.merge(["/nowhere"])

    def test_what_the_merge_refuses_is_one_line(self):
        with self.assertRaises(vtknexrad.Error) as caught:
            vtknexrad.merge([__file__])
        self.assertNotIn("\n", str(caught.exception))
        self.assertIn("TestMerge.py", str(caught.exception))
        with self.assertRaisesRegex(vtknexrad.Error, "^[^v].*SHEAR.*SRV, AZSHEAR, DIV or KDP"):
            vtknexrad.merge(SyntheticFiles.files(), moments="SHEAR")
        with self.assertRaisesRegex(vtknexrad.Error, "write auto, off, or radars"):
            vtknexrad.merge(SyntheticFiles.files(), bias="KLSX")

    def test_a_file_that_is_left_out_is_a_warning(self):
        with self.assertWarnsRegex(vtknexrad.DamageWarning, "TestMerge.py"):
            series = vtknexrad.merge([SyntheticFiles.files()[0], __file__], dims=DIMS)
        self.assertIn("TestMerge.py", series.damage[0])

    def test_a_series_that_cannot_be_written(self):
        series = merge()
        path = path_of("no-folder")
        with open(path, "w", encoding="ascii"):
            pass
        with self.assertRaises(OSError):
            series.write(path)
        with self.assertRaisesRegex(vtknexrad.Error, "there are no volumes to write"):
            series[5:5].write(path_of("none"))
        with self.assertRaisesRegex(ValueError, "^code is 'zip'; it must be one of automatic, radar, exact$"):
            series.write(path_of("none"), code="zip")


class Options(unittest.TestCase):
    def test_the_signature_has_the_defaults_of_the_table(self):
        for name, parameter in inspect.signature(vtknexrad.merge).parameters.items():
            option = merging.OPTIONS.get(name)
            if option and name not in merging.TIMES and parameter.default is not None:
                self.assertEqual(merging.text_of(name, parameter.default),
                                 IN_METRES.get(name, option["default"]), name)

    def test_paraview_s_properties_have_the_names_and_defaults_of_the_table(self):
        grid = pathlib.Path(__file__).resolve().parents[2] / "Plugins" / "ParaView" / "Grid.xml"
        properties = [each for each in ElementTree.parse(grid).iter() if "initial_string" in each.attrib]
        self.assertGreater(len(properties), 5)
        for each in properties:
            self.assertEqual(each.get("command"), "SetOption")
            option = merging.OPTIONS[each.get("initial_string").replace("-", "_")]
            entries = each.findall("EnumerationDomain/Entry")
            names = [entry.get("text").partition(" ")[0].lower() for entry in entries]
            if each.tag == "StringVectorProperty":  # takes other texts, too: its sentence names the choices
                names = [choice for choice in option["choices"] if choice + ":" in each.findtext("Documentation")]
            self.assertEqual(names, option["choices"], each.get("name"))
            self.assertEqual([int(entry.get("value")) for entry in entries], list(range(len(entries))))
            day = vtknexrad.vtkNexradDayReader()
            value = each.get("default_values")
            day.SetOption(each.get("initial_string"), value if each.tag[:6] == "String" else float(value))
            self.assertEqual(day.GetOption(each.get("initial_string")), option["default"])


class Volumes(unittest.TestCase):
    def test_fields_and_masks(self):
        volume = vtknexrad.open(exact())[0]
        self.assertEqual(volume.moments, ("REF", "VEL"))
        self.assertEqual(volume.ancillary[:4], ("REF_age", "REF_radars", "REF_weight", "REF_site"))
        self.assertEqual(volume.shape, DIMS[::-1])
        for name in volume.moments:
            field = volume[name]
            numpy.testing.assert_array_equal(field.states, vtknexrad.array(volume.image, name + "_state"))
            numpy.testing.assert_array_equal(field.values.mask, field.states != State.ECHO)
            numpy.testing.assert_array_equal(numpy.isnan(numpy.asarray(field)), field.values.mask)
            self.assertTrue(field.values.count())
        age = volume["REF_age"]
        self.assertEqual(age.unit, "s")
        numpy.testing.assert_array_equal(age.values.mask, age.states == State.NOT_SCANNED)
        self.assertEqual(numpy.asarray(volume["REF_site"]).dtype, numpy.uint8)
        self.assertEqual(set(numpy.unique(volume["REF_site"].values.compressed())) - {255}, {0})

    def test_places_of_columns(self):
        volume = vtknexrad.open(exact())[0]
        x, y = numpy.meshgrid(volume.x, volume.y)
        latitude, longitude = Geodesy.destination(*volume.centre, numpy.degrees(numpy.arctan2(x, y)), numpy.hypot(x, y))
        at_most(self, Geodesy.distance(latitude, longitude, volume.latitude, volume.longitude).max(), 3e-6,
                "distance of columns from an independent computation, m")
        again_x, again_y = volume.xy(volume.latitude, volume.longitude)
        numpy.testing.assert_allclose(again_x, x, atol=1e-6)
        numpy.testing.assert_allclose(again_y, y, atol=1e-6)

    def test_the_radar_is_at_its_place(self):
        volume = vtknexrad.open(exact())[0]
        latitude, longitude, _height = vtknexrad.open(SyntheticFiles.files()[0]).position
        x, y = volume.xy(latitude, longitude)
        column = numpy.abs(volume.y - y).argmin(), numpy.abs(volume.x - x).argmin()
        # Above the radar is its cone of silence.
        self.assertEqual(volume["REF"].states[-1][column], State.NOT_SCANNED)

    def test_composites(self):
        volume = vtknexrad.open(exact())[0]
        for moment in volume:
            values = volume[moment].values
            composite = volume.composite(moment)
            for row, column in ((3, 4), (17, 20), (20, 12), (35, 39)):
                own = values[:, row, column].compressed()
                if own.size == 0:
                    self.assertIs(composite[row, column], numpy.ma.masked)
                else:
                    strongest = own[numpy.abs(own).argmax()] if moment == "VEL" else own.max()
                    self.assertEqual(composite[row, column], strongest)

    def test_a_volume_that_is_written_comes_back(self):
        volume = vtknexrad.open(exact())[1]
        path = path_of("one.nxv")
        volume.write(path, "exact")
        again = vtknexrad.open(path)
        self.assertIsInstance(again, vtknexrad.Volume)
        self.assertEqual(again.time, volume.time)
        for name in volume.moments + volume.ancillary:
            numpy.testing.assert_array_equal(again[name].filled(0), volume[name].filled(0))

    def test_a_moment_of_a_file(self):
        path = glob.glob(os.path.join(exact(), "*.nxv"))[0]
        self.assertEqual(vtknexrad.open(path, moments="VEL").moments, ("VEL",))
        self.assertEqual(vtknexrad.open(path, moments="VEL,REF").moments, ("VEL", "REF"))
        with self.assertRaises(vtknexrad.Error):
            vtknexrad.open(path, moments="ZDR")

    def test_unknown_names(self):
        with self.assertRaisesRegex(KeyError, "^the volume has no 'SW'; it has REF, VEL, REF_age"):
            vtknexrad.open(exact())[0]["SW"]

    def test_an_image_that_is_turned_has_no_places(self):
        image = vtkImageData()
        image.SetDimensions(2, 2, 2)
        image.SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1)
        with self.assertRaisesRegex(vtknexrad.Error, "turned"):
            vtknexrad.Volume(image).latitude


class Pages(unittest.TestCase):
    @staticmethod
    def page_of(path, *options):
        page = path_of("page.html")
        subprocess.run([os.environ["NEXRAD3D"], "web", path, "-o", page, "--quiet", *options], check=True)
        return pathlib.Path(page).read_text(encoding="utf-8")

    # Not assertEqual, which would print the pages.
    def test_a_page_is_that_of_the_program(self):
        volume, path = vtknexrad.open(exact())[1], path_of("shown.nxv")
        volume.write(path)
        expected = self.page_of(path, "--look-at", "38.7,-90.7", "--zoom", "2", "--parallel")
        shown = volume.show(height=300, look_at=(38.7, -90.7), zoom=2, parallel=True)
        self.assertTrue(shown.text == expected)
        cell = shown._repr_html_()
        self.assertIn("height:300px", cell)
        self.assertTrue(html.unescape(re.search('srcdoc="([^"]*)"', cell)[1]) == expected)

    def test_a_page_of_a_series_has_its_times(self):
        series = vtknexrad.open(exact())
        self.assertTrue(series.show().text == self.page_of(series.write(path_of("played"))))

    def test_options_that_cannot_be(self):
        with self.assertRaisesRegex(vtknexrad.Error, r"^nexrad3d web: .*--zoom.*$"):
            vtknexrad.open(exact())[0].show(zoom=-1)

    def test_pyvista_takes_the_image(self):
        volume, pyvista = vtknexrad.open(exact())[0], mock.Mock()
        with mock.patch.dict("sys.modules", pyvista=pyvista):
            self.assertIs(volume.to_pyvista(), pyvista.wrap.return_value)
        pyvista.wrap.assert_called_once_with(volume.image)
        with mock.patch.dict("sys.modules", pyvista=None), self.assertRaisesRegex(ImportError, "^to_pyvista needs"):
            volume.to_pyvista()


class Parts(unittest.TestCase):
    """Rows and levels of files."""

    def is_part(self, part, whole, first, end):
        self.assertEqual((part.moments, part.ancillary, part.time), (whole.moments, whole.ancillary, whole.time))
        for name in whole.moments + whole.ancillary:
            numpy.testing.assert_array_equal(part[name].states, whole[name].states[:, first:end])
            numpy.testing.assert_array_equal(part[name].filled(0), whole[name].filled(0)[:, first:end])
        for name, places in (("x", whole.x), ("y", whole.y[first:end]), ("z", whole.z),
                             ("latitude", whole.latitude[first:end]), ("longitude", whole.longitude[first:end])):
            numpy.testing.assert_array_equal(getattr(part, name), places)

    def test_rows_are_those_of_the_whole(self):
        path = os.path.join(exact(), "volumes.nxv.series")
        whole = vtknexrad.Volume.open(path)
        for first, end in ((0, 1), (7, 20), (DIMS[1] - 1, DIMS[1]), (0, DIMS[1])):
            self.is_part(vtknexrad.Volume.open(path, rows=(first, end)), whole, first, end)
        self.assertEqual(vtknexrad.Volume.levels(path), [DIMS[::-1]])

    def test_what_is_not_there(self):
        path = glob.glob(os.path.join(exact(), "*.nxv"))[0]
        for first, end in ((0, DIMS[1] + 1), (-1, 4), (5, 5)):
            with self.assertRaisesRegex(IndexError, f"^{path}: no rows {first} to {end}; there are 36, counted from 0$"):
                vtknexrad.open(path, rows=(first, end))
        for level in (-1, 1):
            with self.assertRaisesRegex(IndexError, f"^{path}: no level {level}; there are 1, counted from 0$"):
                vtknexrad.open(path, level=level)

    def test_levels_of_a_large_volume(self):
        path = SyntheticFiles.large_volume()
        self.assertEqual(vtknexrad.Volume.levels(path), [(8, size, size) for size in (4100, 2050, 1025, 513, 257)])
        whole = vtknexrad.Volume.open(path, level=1)
        self.is_part(vtknexrad.Volume.open(path, level=1, rows=(1000, 1100)), whole, 1000, 1100)

    def test_a_level_is_the_mean_of_smaller_voxels(self):
        # Both are rounded to half dBZ.
        path = SyntheticFiles.large_volume()
        fine = vtknexrad.Volume.open(path, rows=(2000, 2200))
        coarse = vtknexrad.Volume.open(path, level=1, rows=(1000, 1100))
        numpy.testing.assert_allclose(coarse.y, fine.y.reshape(-1, 2).mean(axis=1))
        fours = fine["REF"].states.reshape(8, 100, 2, 2050, 2)
        echo = (fours == State.ECHO).any(axis=(2, 4))
        numpy.testing.assert_array_equal(coarse["REF"].where(State.ECHO), echo)
        power = numpy.where(fours == State.ECHO, 10.0 ** (fine["REF"].filled(0.0).reshape(fours.shape) / 10.0), 0.0)
        scanned = (fours == State.ECHO) | (fours == State.NO_ECHO)
        mean = 10.0 * numpy.log10(power.sum(axis=(2, 4))[echo] / scanned.sum(axis=(2, 4))[echo])
        at_most(self, numpy.abs(coarse["REF"].values.data[echo] - mean).max(), 0.5, "error of a coarser level, dBZ")


class Series(unittest.TestCase):
    def test_a_folder_without_an_index(self):
        folder, index = exact(), os.path.join(exact(), "volumes.nxv.series")
        with_index = vtknexrad.open(folder)
        os.rename(index, index + "-away")
        try:
            without = vtknexrad.open(folder)
        finally:
            os.rename(index + "-away", index)
        numpy.testing.assert_array_equal(without.times, with_index.times)
        for at in ("2006-03-12T18:05", "2006-03-12T18:07", "2006-03-12T18:10", "2006-03-12T18:15"):
            self.assertEqual(without.at(at).time, with_index.at(at).time)
        self.assertEqual(vtknexrad.open(without[1:].write(path_of("part"))).times[0], with_index.times[1])

    def test_times_without_data(self):
        reach = "; the volumes are of 2006-03-12 18:05:00 UTC to 2006-03-12 18:15:00 UTC"
        for series, times in ((vtknexrad.open(exact()), ("2006-03-12T18:04:59", "2006-03-12T18:15:01")),
                              (merge(), ("2006-03-12T17:30", "2006-03-12T20:00"))):
            for time in times:
                with self.assertRaises(IndexError) as caught:
                    series.at(time)
                text = time.replace("T", " ") + (":00" if time.count(":") == 1 else "")
                self.assertEqual(str(caught.exception), f"no radar scanned anything at {text} UTC{reach}")
        with self.assertRaisesRegex(vtknexrad.OutOfRange, "^there are no volumes$"):
            merge()[:0].at("2006-03-12T18:05")

    def test_several_indices(self):
        folder = path_of("indices")
        merge().write(folder, name="a.nxv.series")
        merge()[:1].write(folder, name="b.nxv.series")
        with self.assertRaisesRegex(vtknexrad.Error, "several indices: a.nxv.series, b.nxv.series; open one of them"):
            vtknexrad.open(folder)
        self.assertEqual(len(vtknexrad.open(pathlib.Path(folder, "b.nxv.series"))), 1)

    def test_slices_and_numbers(self):
        series = vtknexrad.open(exact())
        self.assertEqual(series.times.dtype, numpy.dtype("datetime64[ns]"))
        self.assertEqual([str(time.astype("datetime64[m]")) for time in series.times],
                         ["2006-03-12T18:05", "2006-03-12T18:10", "2006-03-12T18:15"])
        self.assertEqual(series[-1].time, series.times[-1])
        self.assertEqual(len(series[1:]), 2)
        self.assertEqual(series[1:][0].time, series.times[1])
        with self.assertRaisesRegex(IndexError, "^no volume 3; there are 3, counted from 0$"):
            series[3]


if __name__ == "__main__":
    unittest.main()
