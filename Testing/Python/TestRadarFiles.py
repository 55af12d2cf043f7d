# SPDX-License-Identifier: BSD-3-Clause
"""vtknexrad.open of Level II files: sweeps, masked arrays, states, places, damage and errors."""

import functools
import json
import os
import pathlib
import shutil
import tarfile
import subprocess
import unittest
import warnings

import numpy
import vtknexrad
from vtknexrad import State

import Geodesy
import SyntheticFiles
from Tolerance import at_least, at_most


def real_files():
    """The folder of real radar files; the test is skipped, or fails where they are required, without them."""
    folder = os.environ.get("NEXRAD_TEST_DATA") or os.environ.get("NEXRAD_DEFAULT_TEST_DATA", "")
    if not os.path.isdir(os.path.join(folder, "oracles")):
        message = "real radar files not found: set NEXRAD_TEST_DATA"
        if os.environ.get("NEXRAD_REQUIRE_TEST_DATA") == "1":
            raise AssertionError(message)
        raise unittest.SkipTest(message)
    return pathlib.Path(folder)


@functools.lru_cache(maxsize=None)
def radar():
    return vtknexrad.open(SyntheticFiles.files()[0])


class RadarFiles(unittest.TestCase):
    def test_what_the_file_says(self):
        path = SyntheticFiles.files()[0]
        self.assertIsInstance(radar(), vtknexrad.RadarVolume)
        self.assertEqual((radar().radar, radar().vcp, radar().path), ("KLSX", 11, path))
        self.assertTrue(radar().synthetic)
        self.assertEqual(radar().moments, ("REF", "VEL", "SW"))
        # The name of the file has the time of its first ray.
        self.assertEqual(radar().time.astype("datetime64[s]"), numpy.datetime64("2006-03-12T18:01:45"))
        self.assertGreater(radar().end_time, radar().time)
        self.assertEqual(radar().damage, ())

    def test_paths_may_be_objects(self):
        self.assertEqual(vtknexrad.open(pathlib.Path(SyntheticFiles.files()[0])).radar, "KLSX")

    def test_a_sequence_of_sweeps(self):
        self.assertEqual(len(radar()), 16)
        self.assertEqual([sweep.index for sweep in radar()], list(range(16)))
        self.assertIs(radar()[-1], radar()[15])
        self.assertEqual(len(radar()[2:5]), 3)
        self.assertTrue((numpy.diff(radar().elevations) > -0.3).all())  # coverage pattern 11 goes up

    def test_fields_are_the_arrays_of_the_grids(self):
        for sweep in radar():
            for moment in sweep:
                grid = vtknexrad.sweep(radar().collection, sweep.index, moment)
                rows = vtknexrad.array(grid, moment)[:len(sweep.azimuths)]
                field = sweep[moment]
                self.assertEqual(field.shape, (len(sweep.azimuths), len(field.ranges)))
                numpy.testing.assert_array_equal(numpy.asarray(field), rows)
                numpy.testing.assert_array_equal(field.values.mask, numpy.isnan(rows))
                numpy.testing.assert_array_equal(field.where(State.VALID), ~numpy.isnan(rows))

    def test_rays(self):
        sweep = radar()[0]
        self.assertEqual(len(sweep.azimuths), len(sweep.elevations))
        self.assertEqual(len(sweep.azimuths), len(sweep.times))
        self.assertEqual(sweep.times[0], radar().time)
        self.assertTrue((numpy.diff(sweep.times) > numpy.timedelta64(0)).all())
        self.assertTrue((sweep.nyquist_velocity >= 0.0).all())
        self.assertEqual(sweep.unambiguous_range.shape, sweep.azimuths.shape)
        self.assertEqual(sweep.cut, 1)
        numpy.testing.assert_array_equal(sweep.ranges, sweep["REF"].ranges)

    def test_places_of_gates(self):
        sweep = radar()[10]
        latitude, longitude, height = radar().position
        up, along = Geodesy.beam(sweep.elevations[:, None].astype(float), sweep.ranges[None, :])
        north, east = Geodesy.destination(latitude, longitude, sweep.azimuths[:, None].astype(float), along)
        places = sweep.places()
        self.assertEqual(places.shape, sweep[sweep.moments[0]].shape + (3,))
        at_most(self, Geodesy.distance(north, east, places[..., 1], places[..., 0]).max(), 2e-4,
                "distance of gates from an independent computation, m")
        numpy.testing.assert_allclose(places[..., 2], height + up, atol=1e-6)
        local = sweep.xyz()
        numpy.testing.assert_allclose(numpy.hypot(local[..., 0], local[..., 1]), along, atol=1e-6)

    def test_unknown_names_and_numbers(self):
        with self.assertRaises(vtknexrad.UnknownName) as caught:
            radar()[0]["CFP"]
        self.assertEqual(str(caught.exception), "sweep 0 has no 'CFP'; it has REF")
        self.assertIsInstance(caught.exception, KeyError)
        with self.assertRaisesRegex(IndexError, "^no sweep 16; there are 16, counted from 0$"):
            radar()[16]
        with self.assertRaisesRegex(ValueError, "^quality is 'much'; it must be one of off, standard, strict$"):
            vtknexrad.open(SyntheticFiles.files()[0], quality="much")


class Quality(unittest.TestCase):
    def test_filtered_gates_are_those_of_their_classes(self):
        folder = os.path.join(SyntheticFiles.folder(), "clutter")
        subprocess.run([os.environ["NEXRAD3D"], "simulate", folder, "--sites", "KLSX", "--hours", "0.05", "--not-weather",
                        "clutter,biological", "--quiet"], check=True)
        path = os.path.join(folder, sorted(os.listdir(folder))[0])
        measured = vtknexrad.open(path)
        classes = vtknexrad.echo_classes(measured.collection)
        counts = {}
        for level, taken_out in (("standard", (2, 4, 5, 6)), ("strict", (2, 3, 4, 5, 6))):
            filtered = vtknexrad.open(path, quality=level)
            counts[level] = 0
            for sweep, pair in zip(filtered, classes):
                if pair is None:
                    continue
                before, after = measured[sweep.index]["REF"], sweep["REF"]
                expected = numpy.isin(pair[0][:len(sweep.azimuths)], taken_out)
                numpy.testing.assert_array_equal(after.where(State.FILTERED), expected)
                numpy.testing.assert_array_equal(after.values.mask, before.values.mask | expected)
                numpy.testing.assert_array_equal(after.states[~expected], before.states[~expected])
                counts[level] += expected.sum()
        at_least(self, counts["standard"], 6000, "gates that the level standard takes out")
        self.assertGreater(counts["strict"], counts["standard"])


class RealFiles(unittest.TestCase):
    """Against what Py-ART reads from the same files."""

    def check(self, name, **options):
        oracle = json.loads((real_files() / "oracles" / (os.path.basename(name) + ".json")).read_text())
        volume = vtknexrad.open(real_files() / "level2" / name, **options)
        self.assertEqual(len(volume), oracle["num_sweeps"])
        self.assertEqual(volume.vcp, oracle["vcp"])
        self.assertEqual(str(volume.time.astype("datetime64[ms]")), oracle["first_ray_time"])
        for sweep, expected in zip(volume, oracle["sweeps"]):
            self.assertEqual(len(sweep.azimuths), expected["num_rays"])
            self.assertAlmostEqual(sweep.elevation, expected["elevation_mean"], places=3)
            self.assertEqual(set(sweep.moments), {"RHO" if m == "RHOHV" else m for m in expected["moments"]})
            for moment, figures in expected["moments"].items():
                if moment == "CFP":
                    continue  # Py-ART takes the status codes 2 to 7 for values
                self.check_field(sweep[moment], figures)

    def check_field(self, field, figures):
        self.assertEqual(field.values.count(), figures["valid"], field)
        self.assertEqual(field.where(State.RANGE_FOLDED).sum(), figures["range_folded"], field)
        if figures["valid"]:
            self.assertAlmostEqual(float(field.values.min()), figures["min"], places=3)
            self.assertAlmostEqual(float(field.values.max()), figures["max"], places=3)
            self.assertAlmostEqual(float(field.values.mean(dtype=float)), figures["mean"], places=3)
        # Gates at negative range are left out.
        first = sum(figures["first_gate_m"] + gate * figures["gate_spacing_m"] < 0 for gate in range(20))
        self.assertEqual(field.ranges[0], figures["first_gate_m"] + first * figures["gate_spacing_m"])
        for ray, gate, _raw, value in figures["samples_ray_gate_raw_value"]:
            if gate < first:
                continue
            if value is None:
                self.assertTrue(field.values.mask[ray, gate - first])
            else:
                self.assertAlmostEqual(float(field.values[ray, gate - first]), value, places=4)

    def test_message_31_with_two_polarisations(self):
        self.check(self.find("KDMX20250101_225441_V06"))

    def test_message_1(self):
        self.check(self.find("KBGM20050821_024323.gz"))

    def find(self, name):
        return next(real_files().glob(f"level2/**/{name}")).relative_to(real_files() / "level2")

    def test_a_folder_of_chunks(self):
        folder = next(path for path in sorted((real_files() / "level2" / "chunks").glob("**/*"))
                      if path.is_dir() and vtknexrad.vtkNexradLevel2Reader.CanReadFile(str(path)))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", vtknexrad.DamageWarning)
            volume = vtknexrad.open(folder)
        self.assertIsInstance(volume, vtknexrad.RadarVolume)
        self.assertGreater(volume[0]["REF"].values.count(), 1000)

    def test_a_sweep_without_moments(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", vtknexrad.DamageWarning)
            volume = vtknexrad.open(real_files() / "hostile" / "segv-148-bytes.gz")
        sweep = volume[0]
        self.assertEqual((sweep.moments, len(sweep.azimuths), sweep.times.shape, sweep.cut), ((), 0, (0,), 0))
        self.assertTrue(numpy.isnan(sweep.elevation))
        self.assertIn("nan degrees", sweep._repr_html_() + volume._repr_html_())
        for question in (lambda: sweep.ranges, sweep.places, sweep.plot):
            with self.assertRaisesRegex(KeyError, "^sweep 0 has no 'moment'; it has none$"):
                question()

    def test_damage_is_a_warning(self):
        with self.assertWarnsRegex(vtknexrad.DamageWarning, "KATX20160427_095248_V06.gz: ") as caught:
            volume = vtknexrad.open(real_files() / "level2" / "damaged" / "KATX20160427_095248_V06.gz")
        self.assertEqual(caught.filename, __file__)  # the warning is of the line that opens the file
        self.assertEqual(len(volume), 1)
        self.assertGreaterEqual(len(volume.damage), 1)
        self.assertIn("KATX", volume.damage[0])


class Errors(unittest.TestCase):
    def refused(self, path, kind):
        with self.assertRaises(kind) as caught, warnings.catch_warnings():
            warnings.simplefilter("error")
            vtknexrad.open(path)
        text = str(caught.exception)
        self.assertNotIn("\n", text)
        self.assertTrue(text.startswith(str(path) + ": "), text)
        return text

    def test_nothing_there(self):
        self.assertEqual(self.refused("/nowhere/file", FileNotFoundError), "/nowhere/file: no such file or folder")

    def test_another_kind_of_file(self):
        self.refused(__file__, vtknexrad.Error)

    def test_a_volume_file_that_is_none(self):
        path = os.path.join(SyntheticFiles.folder(), "wrong.nxv")
        with open(path, "w", encoding="ascii") as file:
            file.write("nothing")
        self.refused(path, vtknexrad.Error)

    def test_an_index_that_is_none(self):
        path = os.path.join(SyntheticFiles.folder(), "wrong.nxv.series")
        with open(path, "w", encoding="ascii") as file:
            file.write("nothing")
        self.refused(path, vtknexrad.Error)

    def test_tar_archives(self):
        path = os.path.join(SyntheticFiles.folder(), "day.tar")
        with tarfile.open(path, "w") as archive:
            for file in SyntheticFiles.files()[:2]:
                archive.add(file, os.path.basename(file))
        self.assertIn("a tar archive of radar files: vtknexrad.merge merges them", self.refused(path, vtknexrad.Error))
        member = os.path.join(path, os.path.basename(SyntheticFiles.files()[0]))
        self.assertEqual(vtknexrad.open(member).time, vtknexrad.open(SyntheticFiles.files()[0]).time)
        self.refused(os.path.join(path, "nothing"), FileNotFoundError)
        self.assertEqual(len(vtknexrad.merge([path], dims=(8, 8, 4))), 2)

    def test_folders(self):
        folder = os.path.join(SyntheticFiles.folder(), "kinds")
        os.makedirs(folder)
        self.assertIn("no radar file and no merged volume", self.refused(folder, vtknexrad.Error))
        shutil.copy(SyntheticFiles.files()[0], folder)
        self.assertIn("vtknexrad.merge merges them", self.refused(folder, vtknexrad.Error))


if __name__ == "__main__":
    unittest.main()
