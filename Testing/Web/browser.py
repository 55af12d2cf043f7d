# SPDX-License-Identifier: BSD-3-Clause
"""Runs a browser without a window and controls it by WebDriver BiDi (W3C): Firefox speaks it itself, Chromium through
chromedriver. Graphics are those of the processor."""

import base64
import contextlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import urllib.request

import websocket

START_TIMEOUT = 60  # s
REPLY_TIMEOUT = 180  # s; drawing takes long on a processor

CHROMIUM_ARGUMENTS = [
    "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--hide-scrollbars", "--disable-background-networking", "--force-color-profile=srgb"]
FIREFOX_PREFERENCES = """\
user_pref("webgl.force-enabled", true);
user_pref("webgl.disabled", false);
user_pref("app.update.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("toolkit.telemetry.enabled", false);
user_pref("gfx.color_management.mode", 0);
user_pref("remote.active-protocols", 1);
"""


def find_chromium():
    """Paths of Chromium and of its driver; None where one is missing."""
    names = ("chromium", "chromium-browser", "google-chrome")
    browser = next((path for path in map(shutil.which, names) if path), None)
    driver = shutil.which("chromedriver")
    return (browser, driver) if browser and driver else None


def find_firefox():
    return next((path for path in map(shutil.which, ("firefox", "firefox-esr")) if path), None)


def available():
    """Names of the browsers of this machine that can be controlled."""
    return [name for name, found in (("chromium", find_chromium()), ("firefox", find_firefox())) if found]


def wait_for_line(file, pattern):
    """What the pattern finds in a file that a process writes."""
    end = time.monotonic() + START_TIMEOUT
    while time.monotonic() < end:
        found = re.search(pattern, pathlib.Path(file).read_text(errors="replace"))
        if found:
            return found.group(1)
        time.sleep(0.1)
    raise TimeoutError(f"the browser does not start: {pathlib.Path(file).read_text(errors='replace')[-2000:]}")


class Browser:
    """A browser with one page. `messages`: what the page wrote to its console, errors with the word "error" before;
    `requests`: the addresses that it asked for."""

    def __init__(self, name, size=(1280, 720), webgl=True):
        self.cleanup = contextlib.ExitStack()
        self.folder = self.cleanup.enter_context(tempfile.TemporaryDirectory(prefix="nexrad-browser-",
                                                                             ignore_cleanup_errors=True))
        self.size = size
        self.webgl = webgl
        self.count = 0
        self.messages = []
        self.requests = []
        try:
            address = self.start_chromium() if name == "chromium" else self.start_firefox()
            self.socket = websocket.WebSocket(address, REPLY_TIMEOUT)
            if name == "firefox":
                self.call("session.new", {"capabilities": {}})
            self.open_page()
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *ignored):
        self.close()

    def start(self, command):
        log = pathlib.Path(self.folder) / "log"
        stream = self.cleanup.enter_context(open(log, "wb"))
        process = subprocess.Popen(command, stdout=stream, stderr=subprocess.STDOUT)
        self.cleanup.callback(self.end, process)
        return log

    @staticmethod
    def end(process):
        process.terminate()
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def start_chromium(self):
        browser, driver = find_chromium()
        log = self.start([driver, "--port=0"])
        port = wait_for_line(log, r"started successfully on port (\d+)")
        arguments = CHROMIUM_ARGUMENTS + [f"--window-size={self.size[0]},{self.size[1]}",
                                          f"--user-data-dir={self.folder}/profile"]
        if not self.webgl:
            arguments = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-3d-apis",
                         f"--user-data-dir={self.folder}/profile"]
        body = {"capabilities": {"alwaysMatch": {
            "webSocketUrl": True, "goog:chromeOptions": {"binary": browser, "args": arguments}}}}
        self.driver = f"http://127.0.0.1:{port}/session"
        session = self.post(self.driver, body)["value"]
        self.driver += "/" + session["sessionId"]
        self.cleanup.callback(self.quit_chromium)
        return session["capabilities"]["webSocketUrl"]

    @staticmethod
    def post(address, body=None, method="POST"):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(address, data, {"Content-Type": "application/json"}, method=method)
        with urllib.request.urlopen(request, timeout=START_TIMEOUT) as reply:
            return json.load(reply)

    def quit_chromium(self):
        with contextlib.suppress(OSError):
            self.post(self.driver, method="DELETE")

    def start_firefox(self):
        profile = pathlib.Path(self.folder) / "profile"
        profile.mkdir()
        preferences = FIREFOX_PREFERENCES
        if not self.webgl:
            preferences += 'user_pref("webgl.disabled", true);\n'
        (profile / "user.js").write_text(preferences)
        headless = [] if "DISPLAY" in os.environ else ["--headless"]  # which has no WebGL without a graphics card
        log = self.start([find_firefox(), *headless, "--no-remote", "--profile", str(profile),
                          "--remote-debugging-port", "0", "--width", str(self.size[0]), "--height", str(self.size[1])])
        return wait_for_line(log, r"WebDriver BiDi listening on (ws://\S+)") + "/session"

    def open_page(self):
        self.call("session.subscribe", {"events": ["log.entryAdded", "network.beforeRequestSent"]})
        tree = self.call("browsingContext.getTree", {})
        self.page = tree["contexts"][0]["context"]
        self.call("browsingContext.setViewport", {
            "context": self.page, "viewport": {"width": self.size[0], "height": self.size[1]}, "devicePixelRatio": 1})

    def note(self, event):
        if event["method"] == "log.entryAdded":
            entry = event["params"]
            self.messages.append(f"{entry['level']}: {entry['text']}")
        elif event["method"] == "network.beforeRequestSent":
            self.requests.append(event["params"]["request"]["url"])

    def call(self, method, parameters):
        """The result of a command."""
        self.count += 1
        self.socket.send(json.dumps({"id": self.count, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.receive())
            if message.get("type") == "event":
                self.note(message)
            elif message.get("id") == self.count:
                if message.get("type") == "error":
                    raise RuntimeError(f"{method}: {message['error']}: {message['message']}")
                return message["result"]

    def open(self, address):
        self.requests.clear()
        self.messages.clear()
        self.call("browsingContext.navigate", {"context": self.page, "url": address, "wait": "complete"})

    def run(self, script):
        """What an expression in the page gives, once a promise is fulfilled; as JSON has it."""
        result = self.call("script.evaluate", {
            "expression": f"(async () => JSON.stringify(await ({script})))()", "target": {"context": self.page},
            "awaitPromise": True})
        if result["type"] == "exception":
            raise RuntimeError(result["exceptionDetails"]["text"])
        return json.loads(result["result"].get("value", "null"))

    def wait(self, script, seconds=120):
        """Until an expression in the page is true."""
        end = time.monotonic() + seconds
        while not self.run(script):
            if time.monotonic() > end:
                raise TimeoutError(f"{script}; the page says: {self.messages}")
            time.sleep(0.1)

    def act(self, *sources):
        """Input as WebDriver describes it (input.performActions)."""
        self.call("input.performActions", {"context": self.page, "actions": list(sources)})
        self.call("input.releaseActions", {"context": self.page})

    def press(self, key):
        self.act({"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": key},
                                                           {"type": "keyUp", "value": key}]})

    def picture(self, path):
        """Writes what the page shows as PNG."""
        data = self.call("browsingContext.captureScreenshot", {"context": self.page})["data"]
        pathlib.Path(path).write_bytes(base64.b64decode(data))

    def close(self):
        with contextlib.suppress(OSError, AttributeError):
            self.socket.close()
        self.cleanup.close()
