# SPDX-License-Identifier: BSD-3-Clause
"""A server of two MPI processes shares a radar day, and shows what the built-in server shows; so does pvbatch."""

import glob
import os
import shutil
import socket
import subprocess
import tempfile
import threading
import unittest

import Plugin
from paraview import servermanager, simple

PROCESSES = 2
TIME = 1284168000.0  # 2010-09-11T01:20:00Z
MPIEXEC = shutil.which("mpiexec")


def environment():
    """For mpiexec: without what MPI left behind in this process, which is one of its own kind."""
    kept = {name: value for name, value in os.environ.items()
            if not name.startswith(("OMPI_", "PMIX_"))}
    # Open MPI asks for this before it runs as root, or more processes than there are cores.
    return {
        **kept,
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
    }


def free_port():
    with socket.socket() as chosen:
        chosen.bind(("localhost", 0))
        return chosen.getsockname()[1]


def start_server(port):
    """Starts a server, and returns when it waits for a client. It ends when its client, this program, ends."""
    server = subprocess.Popen(
        [MPIEXEC, "-n", str(PROCESSES), shutil.which("pvserver"), f"--server-port={port}",
         "--force-offscreen-rendering"], env=environment(), stdout=subprocess.PIPE, text=True)
    # Another look at its port would be taken for the client.
    for line in server.stdout:
        if "Accepting connection" in line:
            # What it prints later is read as well, so that it never waits for a reader.
            threading.Thread(target=server.stdout.read, daemon=True).start()
            return server
    raise RuntimeError(f"pvserver ended with status {server.wait()}")


def open_day(files):
    day = simple.NEXRADRadarDay(FileNames=files, Dimensions=[96, 96, 48], MaximumGap=2700)
    day.UpdatePipeline(TIME)
    return day


def draw(day, path, representation):
    """A picture of the day from the south."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 300]
    view.ViewTime = TIME
    view.UseColorPaletteForBackground = 0
    view.Background = [0, 0, 0]
    display = simple.Show(day, view)
    simple.ColorBy(display, ("POINTS", "REF"))
    for function in (simple.GetColorTransferFunction("REF"), simple.GetOpacityTransferFunction("REF")):
        function.ApplyPreset("NEXRAD clear air", False)
    display.SetRepresentationType(representation)
    display.ScalarOpacityUnitDistance = 5000
    display.ShadowStrength = display.AmbientOcclusionStrength = 0  # as ParaView's own
    display.Scale = [1, 1, 10]
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint = [0, 0, 60e3]
    view.CameraPosition = [-300e3, -1900e3, 1200e3]
    simple.SaveScreenshot(path, view)
    simple.Delete(view)
    return Plugin.picture(path)


def first_look(day):
    """What the echo of the whole day decides: scale, slices, camera and the distance of opacities."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 300]
    view.ViewTime = TIME
    display = simple.Show(day, view)
    look = list(display.Scale) + [display.NumberOfSlices], list(view.CameraPosition), display.ScalarOpacityUnitDistance
    simple.Delete(view)
    return look


def describe(day):
    information = day.GetDataInformation()
    array = information.GetPointDataInformation().GetArrayInformation("REF")
    return information.GetExtent(), information.GetBounds(), array.GetComponentRange(0)


@unittest.skipUnless(MPIEXEC, "mpiexec was not found")
class Server(unittest.TestCase):
    REPRESENTATIONS = ("Outline", "Surface", "Volume", "Volume (slices)")

    def setUp(self):
        self.files = Plugin.real_files("multisite-20100911")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_two_processes_show_what_one_shows(self):
        day = open_day(self.files)
        alone = describe(day)
        scale, camera, distance = first_look(day)
        expected = {each: draw(day, self.path("alone.png"), each) for each in self.REPRESENTATIONS}
        port = free_port()
        type(self).server = start_server(port)
        simple.Connect("localhost", port)
        simple.LoadPlugin(os.environ["NEXRAD_PLUGIN"], remote=True)
        day = open_day(self.files)
        self.assertEqual(servermanager.ActiveConnection.GetNumberOfDataPartitions(), PROCESSES)
        self.assertEqual(describe(day), alone)
        of_two = first_look(day)
        print(f"camera at {camera} and {of_two[1]}, opacities of {distance:.0f} and {of_two[2]:.0f} m")
        self.assertEqual(of_two[0], scale)
        for one, other in zip(camera, of_two[1]):
            self.assertAlmostEqual(one, other, delta=1)
        self.assertAlmostEqual(of_two[2], distance, delta=1)
        for each in self.REPRESENTATIONS:
            apart, largest = Plugin.difference(expected[each], draw(day, self.path("two.png"), each))
            echo, _ = Plugin.difference(expected[each], expected["Outline"])
            print(f"{each}: mean difference {apart:.3f}, largest {largest:.0f} of 255; the echo makes a "
                  f"mean of {echo:.2f}")
            # Surfaces are the same; volumes are blended from two pictures of 8 bits.
            self.assertLessEqual(apart, 0.05 * echo if "Volume" in each else 0.0)

    def test_pvbatch_of_two_processes_writes_an_animation(self):
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "animate_day.py")
        pictures = {}
        for processes in (1, PROCESSES):
            output = self.path(f"by-{processes}")
            os.mkdir(output)
            subprocess.run(
                [MPIEXEC, "-n", str(processes), shutil.which("pvbatch"), script, output]
                + Plugin.real_files("run-kbgm-20050821"), env=environment(), check=True, timeout=200)
            pictures[processes] = [Plugin.picture(each) for each in sorted(glob.glob(output + "/*.png"))]
        self.assertEqual(len(pictures[1]), 6)
        self.assertEqual(len(pictures[PROCESSES]), 6)
        moved, _ = Plugin.difference(pictures[1][0], pictures[1][-1])
        for one, several in zip(pictures[1], pictures[PROCESSES]):
            apart, largest = Plugin.difference(one, several)
            print(f"frame: mean difference {apart:.3f}, largest {largest:.0f} of 255; from first to last "
                  f"frame {moved:.2f}")
            self.assertLess(apart, 0.1 * moved)


if __name__ == "__main__":
    unittest.main(verbosity=2)
