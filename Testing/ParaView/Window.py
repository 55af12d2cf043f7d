# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window, used with mouse and keyboard: events of X in a window of a fixed size.

    Window.py PLUGIN FOLDER PICTURE

opens the radar files of a folder as a new user does, prints each action and the seconds that it took, and takes a
picture of the window. Without a display it needs xvfb-run; it needs xdotool and ImageMagick's import.
"""

import os
import subprocess
import sys
import tempfile
import time

SIZE = (1280, 820)
# Where things are in a window of that size; ParaView lays them out from its upper left corner.
OPEN_BUTTON = (18, 38)
APPLY = (47, 445)


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False).stdout.strip()


class Window:
    """A ParaView with the plugin and nothing else, started in a folder with settings of its own."""

    def __init__(self, plugin, folder, home):
        version = run("dpkg-query", "-W", "-f", "${Version}", "paraview").split("+")[0] or "5.11.0"
        settings = os.path.join(home, ".config", "ParaView", f"ParaView{version}.ini")
        os.makedirs(os.path.dirname(settings), exist_ok=True)
        with open(settings, "w", encoding="utf-8") as file:
            file.write("[General]\nGeneralSettings.ShowWelcomeDialog=false\n")
        self.actions = []
        self.process = subprocess.Popen(
            ["paraview", "--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=VTKNexrad"],
            cwd=folder, env={**os.environ, "HOME": home}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.id = self.wait_for("ParaView")
        run("xdotool", "windowmove", self.id, "0", "0", "windowsize", "--sync", self.id, *map(str, SIZE))
        self.settle()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def wait_for(self, name, seconds=90):
        """The window whose title has that name, as soon as it is visible."""
        end = time.time() + seconds
        while time.time() < end and self.process.poll() is None:
            found = run("xdotool", "search", "--onlyvisible", "--name", name).split()
            if found:
                return found[0]
            time.sleep(0.2)
        raise RuntimeError(f"no window {name}")

    def processor_time(self):
        """Seconds of processor time that the program has used."""
        with open(f"/proc/{self.process.pid}/stat", encoding="utf-8") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def settle(self, seconds=120):
        """Waits until the program does nothing for a second and a half; returns when it last did something."""
        end, used, busy = time.time() + seconds, self.processor_time(), time.time()
        while time.time() < end and time.time() - busy < 1.5:
            time.sleep(0.1)
            now = self.processor_time()
            if now > used + 0.02:
                used, busy = now, time.time()
        return busy

    def act(self, what, *command):
        """One action of a person."""
        start = time.time()
        run("xdotool", *map(str, command))
        taken = self.settle() - start
        self.actions.append(what)
        print(f"action {len(self.actions)}: {what} ({taken:.1f} s)", flush=True)
        return taken

    def click(self, what, place, key=None):
        held = ("keydown", key) if key else ()
        freed = ("keyup", key) if key else ()
        return self.act(what, "mousemove", *place, *held, "click", 1, *freed)

    def picture(self, path):
        """Takes a picture of the screen."""
        run("import", "-window", "root", f"PNG24:{path}")


def place_in(window, fraction):
    """A point of a window, which ParaView puts into the middle of its own, by fractions of its size."""
    lines = dict(line.split("=") for line in run("xdotool", "getwindowgeometry", "--shell", window).splitlines())
    return [round(int(lines[at]) + part * int(lines[size]))
            for at, size, part in (("X", "WIDTH", fraction[0]), ("Y", "HEIGHT", fraction[1]))]


def open_day(window, rows):
    """Opens all names that the dialog shows; returns the seconds from the last press to the picture."""
    window.click("the button Open", OPEN_BUTTON)
    dialog = window.wait_for("Open File")
    row = lambda index: place_in(dialog, (0.36, 0.182 + 0.0473 * index))
    window.click("the first name", row(0))
    window.click("the last name, with Shift", row(rows - 1), "shift")
    window.click("the button OK", place_in(dialog, (0.924, 0.866)))
    return window.click("the button Apply", APPLY)


def main():
    plugin, folder, picture = sys.argv[1:4]
    rows = len({name.rsplit("_", 1)[0] for name in os.listdir(folder)})
    with tempfile.TemporaryDirectory() as home, Window(plugin, folder, home) as window:
        open_day(window, rows)
        window.picture(picture)
        print(f"{len(window.actions)} actions")


if __name__ == "__main__":
    main()
