# SPDX-License-Identifier: BSD-3-Clause
"""A page of nexrad3d web in each browser of this machine: opened from a file and from a server, played, turned by mouse,
keys and touch, and compared with a picture of nexrad3d render.

NEXRAD_BROWSERS names the browsers ("chromium firefox"); NEXRAD_WEB_PICTURES a folder for the pictures, if they are to be
looked at."""

import functools
import http.server
import itertools
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import threading
import unittest

import browser
import pixels

DRAWN = "window.nexrad3d?.framesDrawn > 0"
AT_REST = "window.nexrad3d?.framesDrawn > 0 && !nexrad3d.scheduled"
DETAIL_READ = AT_REST + " && !nexrad3d.detail?.loading"
# A domain that is so large that its volume is written in bricks, and the voxels about its middle as a domain of their own.
LARGE = ("--dims", "4096x4096x9", "--bounds=-110,25,-72,55")
MIDDLE = ("--dims", "512x512x9", "--bounds=-93.375,38.125,-88.625,41.875")
# The volume alone, from a place to which two pages with one projection agree.
VOLUME_ALONE = """(() => {
  const { picture } = nexrad3d;
  Object.assign(picture, { drawLetters: () => picture.letters.clear(picture.width, picture.height) });
  Object.assign(picture.lines, { draw: () => {}, drawGround: () => {} });
  picture.volume.opacityDistance = 5;
  nexrad3d.set({ stretch: 4 });
})()"""
SHARE = 4.0  # of 255: the greatest mean difference between a page and a picture of the program
SURFACES = 5.0  # the same of surfaces: a page closes them where nothing was scanned


def nexrad3d(*arguments):
    run = subprocess.run([os.environ["NEXRAD3D"], *map(str, arguments)], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(run.stderr)
    return run.stdout


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *ignored):
        pass


class PartsHandler(QuietHandler):
    """Sends parts of volume files to those who ask for them. `sent`: their first bytes and lengths, in the order in which they
    were asked for; `broken`: it sends none."""

    sent = []
    broken = False

    def do_GET(self):
        part = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", ""))
        if not self.path.endswith(".nxv"):
            super().do_GET()
        elif part is None or PartsHandler.broken:
            self.send_error(503)
        else:
            self.send_part(pathlib.Path(self.translate_path(self.path)), int(part[1]), int(part[2]) + 1)

    def send_part(self, path, begin, end):
        data = path.read_bytes()[begin:end]
        self.send_response(206)
        self.send_header("Content-Length", str(len(data)))
        self.send_header("Content-Range", f"bytes {begin}-{begin + len(data) - 1}/{path.stat().st_size}")
        self.end_headers()
        self.wfile.write(data)
        PartsHandler.sent.append((begin, len(data)))


class Server:
    """A static server of a folder."""

    def __init__(self, folder, handler=QuietHandler):
        handler = functools.partial(handler, directory=str(folder))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self.address = f"http://127.0.0.1:{self.server.server_address[1]}/"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *ignored):
        self.server.shutdown()
        self.server.server_close()


class PageTest:
    """The tests of one browser; `name` is its name."""

    name = ""

    @classmethod
    def setUpClass(cls):
        if cls.name not in os.environ.get("NEXRAD_BROWSERS", " ".join(browser.available())).split():
            raise unittest.SkipTest(f"no {cls.name} with a remote control was found")
        temporary = tempfile.TemporaryDirectory(prefix="nexrad-page-")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        nexrad3d("simulate", cls.folder / "day", "--hours", "0.25", "--quiet")
        nexrad3d("grid", cls.folder / "day", "-o", cls.folder / "volumes", "--dims", "128x128x64", "--step", "5min",
                 "--quiet")
        cls.page = cls.folder / "storm.html"
        nexrad3d("web", cls.folder / "volumes", "-o", cls.page, "--quiet")
        cls.browser = browser.Browser(cls.name)
        cls.addClassCleanup(cls.browser.close)

    def open(self, words="", page=None):
        address = (page or self.page).as_uri() + (f"#{words}" if words else "")
        self.browser.open("about:blank")
        self.browser.open(address)
        self.browser.wait(DRAWN)
        self.browser.wait(AT_REST)
        return address

    def picture(self, name):
        folder = pathlib.Path(os.environ.get("NEXRAD_WEB_PICTURES", self.folder))
        path = folder / f"{self.name}-{name}.png"
        self.browser.picture(path)
        return path

    def outside(self):
        """Addresses outside of the page that it asked for."""
        return [address for address in self.browser.requests if not address.startswith(("data:", self.page.as_uri()))]

    def text(self, identifier):
        return self.browser.run(f"document.getElementById('{identifier}').textContent")

    def test_a_page_opens_from_a_file_and_asks_for_nothing(self):
        self.open()
        self.picture("page")
        self.assertEqual(self.outside(), [])
        self.assertEqual(self.browser.messages, [])
        self.assertEqual(self.text("message"), "")
        self.assertRegex(self.text("clock"), r"^2006-03-12 18:\d\d:00 UTC \(1 of \d\)$")
        self.assertIn("SYNTHETIC", self.browser.run("document.title"))
        self.assertIn("SYNTHETIC", self.browser.run("document.getElementById('picture').getAttribute('aria-label')"))

    def test_the_picture_is_that_of_the_program(self):
        for name, words, options in (("usual", "", []), ("east", "&azimuth=90&tilt=60", ["--azimuth", 90, "--tilt", 60]),
                                     ("surfaces", "&preset=iso-values", ["--preset", "iso-values"])):
            with self.subTest(name):
                self.open(f"controls=0&time=1{words}")
                seen = self.picture(name)
                time = self.browser.run("new Date(nexrad3d.time).toISOString()")[:19].replace("-", "").replace(":", "")
                drawn = self.folder / f"render-{time}Z.png"  # of all times: they share the frame, as in the page
                nexrad3d("render", self.folder / "volumes", "-o", self.folder / "render.png", "--quiet", "--shadow", 0,
                         "--occlusion", 0, *options)  # pages have no shadows
                difference = pixels.mean_difference(seen, drawn)
                print(f"{self.name}, {name}: mean difference {difference:.2f} of 255")
                self.assertLess(difference, SURFACES if name == "surfaces" else SHARE)
                shutil.copy(drawn, seen.with_name(f"{self.name}-{name}-program.png"))

    def test_keys_play_and_turn(self):
        self.open()
        before = self.browser.run("nexrad3d.view.azimuth")
        self.browser.press("d")
        self.assertEqual(self.browser.run("nexrad3d.view.azimuth"), before + 5)
        self.browser.press("\ue014")  # arrow to the right
        self.browser.wait("nexrad3d.position === 1")
        self.assertIn("(2 of", self.text("clock"))
        self.browser.press(" ")
        self.browser.wait("nexrad3d.playing && nexrad3d.framesDrawn > 5")
        self.browser.press(" ")
        self.assertFalse(self.browser.run("nexrad3d.playing"))
        self.browser.press("2")
        self.assertEqual(self.browser.run("nexrad3d.settings.preset"), 1)
        self.browser.press("h")
        self.assertFalse(self.browser.run("document.getElementById('panel').hidden"))
        self.browser.wait(AT_REST)
        self.picture("panel")
        self.assertEqual(self.browser.messages, [])

    def drag(self, kind):
        self.browser.act({"type": "pointer", "id": kind, "parameters": {"pointerType": kind}, "actions": [
            {"type": "pointerMove", "x": 600, "y": 300}, {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "x": 700, "y": 300, "duration": 50}, {"type": "pointerUp", "button": 0}]})

    def test_mouse_and_finger_turn(self):
        self.open()
        for kind in ("mouse", "touch"):
            before = self.browser.run("nexrad3d.view.azimuth")
            self.drag(kind)
            self.assertGreater(self.browser.run("nexrad3d.view.azimuth"), before + 10, kind)

    def test_two_fingers_zoom(self):
        self.open()

        def finger(name, first, last):
            return {"type": "pointer", "id": name, "parameters": {"pointerType": "touch"}, "actions": [
                {"type": "pointerMove", "x": first, "y": 300}, {"type": "pointerDown", "button": 0},
                {"type": "pointerMove", "x": last, "y": 300, "duration": 50}, {"type": "pointerUp", "button": 0}]}

        self.browser.act(finger("one", 580, 500), finger("two", 620, 700))
        self.assertGreater(self.browser.run("nexrad3d.view.zoom"), 2.0)

    def test_cut_and_surface_change_the_picture(self):
        self.open("controls=0")
        whole = self.picture("whole")
        for name, settings in (("cut", "{cut: {azimuth: 90, offset: 0}}"), ("surface", "{cut: null, surface: 35}"),
                               ("faint", "{surface: null, strength: 0.25}")):
            self.browser.run(f"nexrad3d.set({settings})")
            self.browser.wait(AT_REST)
            self.assertGreater(pixels.mean_difference(whole, self.picture(name)), 0.3, name)
        self.assertEqual(self.browser.messages, [])

    def test_a_folder_on_a_server_streams_and_follows_what_is_added(self):
        site = self.folder / f"site-{self.name}"
        volumes = sorted((self.folder / "volumes").glob("*.nxv"))
        nexrad3d("web", *volumes[:2], "-o", site, "--quiet")
        with Server(site) as server:
            self.browser.open(server.address)
            self.browser.wait(DRAWN)
            self.assertIn("of 2)", self.text("clock"))
            self.browser.run("nexrad3d.step(1)")
            self.browser.wait("nexrad3d.position === 1")
            self.browser.wait(AT_REST)
            self.picture("folder")
            nexrad3d("web", *volumes[:3], "-o", site, "--quiet")
            self.browser.wait("document.getElementById('clock').textContent.includes('(3 of 3)')")
            self.assertEqual(self.browser.messages, [])
            # Where the first volume goes, the time that is shown stays.
            self.browser.run("nexrad3d.step(-1)")
            self.browser.wait("nexrad3d.position === 1")
            shown = self.browser.run("nexrad3d.time")
            nexrad3d("web", *volumes[1:3], "-o", site, "--quiet")
            self.browser.wait("document.getElementById('clock').textContent.includes('(1 of 2)')")
            self.assertEqual(self.browser.run("nexrad3d.time"), shown)

    def fly(self, east, north, distance=200):
        """Looks at a place of the scene, and waits until the picture has all that it wants."""
        self.browser.run(f"""(() => {{
          nexrad3d.view = {{ azimuth: 200, tilt: 60, zoom: 1, parallel: false }};
          nexrad3d.moved = [0, 0, 0];
          nexrad3d.picture.placed = {{ focus: [{east}, {north}, 0], distance: {distance} }};
          nexrad3d.touch();
        }})()""")
        self.browser.wait("!nexrad3d.isMoving(performance.now()) && " + DETAIL_READ)

    def make_site(self, name, *domain):
        volumes = self.folder / f"{name}-volumes"
        nexrad3d("grid", self.folder / "one", "-o", volumes, "--axes", "geographic", *domain, "--end", "2006-03-12T18:05",
                 "--quiet")
        nexrad3d("web", volumes, "-o", self.folder / name, "--quiet")
        return self.folder / name

    def wanted(self):
        return self.browser.run("nexrad3d.detail.wanted && {level: nexrad3d.detail.wanted.level, "
                                "drawn: nexrad3d.picture.volume.shownDetail() !== null}")

    def test_a_large_volume_is_read_in_parts_as_the_camera_comes_near(self):
        nexrad3d("simulate", self.folder / "one", "--sites", "KLSX", "--hours", "0.2", "--quiet")
        large, middle = self.make_site("large", *LARGE), self.make_site("middle", *MIDDLE)
        volume = next(large.glob("*.nxv"))
        with Server(middle) as server:
            self.browser.open(server.address + "#controls=0")
            self.browser.wait(AT_REST)
            self.browser.run(VOLUME_ALONE)
            self.fly(0, -100)
            expected = self.picture("middle")
        PartsHandler.sent.clear()
        with Server(large, PartsHandler) as server:
            self.browser.open(server.address + "#controls=0&zoom=0.3")
            self.browser.wait(DETAIL_READ)
            self.assertEqual(self.browser.run("nexrad3d.scene.size"), [512, 512, 9])
            self.check_first_bytes(volume)
            self.assertGreater(self.wanted()["level"], 0)
            self.browser.run(VOLUME_ALONE)
            PartsHandler.sent.clear()
            self.fly(0, -100)
            self.assertEqual(self.wanted(), {"level": 0, "drawn": True})
            near = sum(count for _, count in PartsHandler.sent)
            difference = pixels.mean_difference(expected, self.picture("large"))
            print(f"{self.name}, near: {near} bytes in {len(PartsHandler.sent)} parts, "
                  f"mean difference {difference:.3f} of 255")
            self.assertTrue(0 < near < 0.5 * volume.stat().st_size)
            self.assertLess(difference, 0.1)
            self.browser.run("nexrad3d.picture.volume.setDetail(null), nexrad3d.touch()")
            self.browser.wait(AT_REST)
            self.assertGreater(pixels.mean_difference(expected, self.picture("coarse")), 1.0)
            self.check_moving_on()
        self.assertEqual([line for line in self.browser.messages if "503" not in line], [])

    def check_first_bytes(self, volume):
        """What comes first is the header and the coarsest level, the last one of the file."""
        data = volume.read_bytes()
        header = json.loads(data[8:8 + struct.unpack_from("<I", data, 4)[0]])
        begin = len(data) - sum(array["length"] for array in header["levels"][-1]["arrays"])
        first = list(itertools.takewhile(lambda part: part[0] == 0 or part[0] >= begin, PartsHandler.sent))
        self.assertGreater(len(first), 2)
        self.assertLess(sum(count for _, count in first), 16384 + header["levels"][-1]["arrays"][0]["length"] + 1)

    def check_moving_on(self):
        """Moving back asks for nothing again; what cannot be read is said, and the picture stays."""
        self.fly(60, 40)
        PartsHandler.sent.clear()
        self.fly(0, -100)
        self.assertEqual(self.wanted(), {"level": 0, "drawn": True})
        self.assertEqual(PartsHandler.sent, [])
        PartsHandler.broken = True
        try:
            self.fly(-150, -250)
            self.assertIn("cannot be read from the server (503)", self.text("message"))
        finally:
            PartsHandler.broken = False
        self.fly(-150, -250)
        self.assertEqual(self.text("message"), "")
        self.assertEqual(self.wanted(), {"level": 0, "drawn": True})

    def test_a_page_of_a_folder_says_that_it_needs_a_server(self):
        site = self.folder / f"lone-{self.name}"
        nexrad3d("web", self.folder / "volumes", "-o", site, "--quiet")
        self.browser.open((site / "index.html").as_uri())
        self.browser.wait("!document.getElementById('message').hidden")
        self.assertIn("http.server", self.text("message"))

    def test_a_browser_without_webgl_says_so(self):
        with browser.Browser(self.name, webgl=False) as lone:
            lone.open(self.page.as_uri())
            lone.wait("!document.getElementById('message').hidden")
            self.assertIn("WebGL2", lone.run("document.getElementById('message').textContent"))
            lone.picture(pathlib.Path(os.environ.get("NEXRAD_WEB_PICTURES", self.folder)) / f"{self.name}-missing.png")


class Chromium(PageTest, unittest.TestCase):
    name = "chromium"


class Firefox(PageTest, unittest.TestCase):
    name = "firefox"


if __name__ == "__main__":
    unittest.main()
