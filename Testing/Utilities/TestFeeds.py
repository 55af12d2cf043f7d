# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of a feed: chunks from a bucket on loopback and from LDM, and a synthetic feed that `watch` follows."""

import http.server
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.parse

UTILITIES = pathlib.Path(os.environ["NEXRAD_UTILITIES"])
PROGRAM = os.environ["NEXRAD3D"]
PAGE = 3  # keys of one page of a listing


class BucketHandler(http.server.BaseHTTPRequestHandler):
    """Answers ListObjectsV2 and reads, from a dictionary."""

    def do_GET(self):
        address = urllib.parse.urlsplit(self.path)
        words = dict(urllib.parse.parse_qsl(address.query))
        if "list-type" in words:
            self.answer(self.listing(words).encode())
        elif urllib.parse.unquote(address.path[1:]) in self.server.objects:
            self.answer(self.server.objects[urllib.parse.unquote(address.path[1:])])
        else:
            self.send_error(404)

    def listing(self, words):
        prefix, delimiter = words.get("prefix", ""), words.get("delimiter")
        keys = sorted(key for key in self.server.objects if key.startswith(prefix))
        folders = sorted({prefix + key[len(prefix):].split(delimiter)[0] + delimiter for key in keys}) if delimiter else []
        entries = [f"<CommonPrefixes><Prefix>{each}</Prefix></CommonPrefixes>" for each in folders] or [
            f"<Contents><Key>{key}</Key></Contents>" for key in keys]
        begin = int(words.get("continuation-token", 0))
        more = begin + PAGE < len(entries)
        token = f"<NextContinuationToken>{begin + PAGE}</NextContinuationToken>" if more else ""
        return ('<?xml version="1.0"?><ListBucketResult xmlns="http://s3.amazonaws.com/doc/2006-03-01/">'
                f"<IsTruncated>{str(more).lower()}</IsTruncated>{token}{''.join(entries[begin:begin + PAGE])}"
                "</ListBucketResult>")

    def answer(self, content):
        self.send_response(200)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *arguments):
        pass


class Buckets(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.feed = pathlib.Path(self.folder.name)
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), BucketHandler)
        self.server.objects = {}
        self.thread = threading.Thread(target=self.server.serve_forever)
        self.thread.start()

    def tearDown(self):
        self.server.shutdown()
        self.thread.join()
        self.server.server_close()
        self.folder.cleanup()

    def stamp(self, age):
        return time.strftime("%Y%m%d-%H%M%S", time.gmtime(time.time() - age))

    def fill(self, radar, number, stamp, count):
        for i in range(count):
            key = f"{radar}/{number}/{stamp}-{i + 1:03d}-{'S' if i == 0 else 'I'}"
            self.server.objects[key] = key.encode() * 10

    def copy(self, *radars):
        url = f"http://127.0.0.1:{self.server.server_port}"
        return subprocess.run([sys.executable, UTILITIES / "copy-feed", "bucket", url, *radars, "-o", self.feed, "--once"],
                              capture_output=True, text=True, timeout=60, check=False)

    def files(self):
        return {str(path.relative_to(self.feed)): path.read_bytes() for path in self.feed.rglob("*") if path.is_file()}

    def test_new_chunks_of_the_radars_are_copied(self):
        recent, old = self.stamp(60), self.stamp(5 * 3600)
        self.fill("KLSX", 999, recent, 8)
        self.fill("KLSX", 7, old, 4)
        self.fill("KILX", 12, recent, 2)
        self.fill("KTLX", 1, recent, 2)
        self.assertEqual(self.copy("KLSX", "KILX").stdout, "10 chunks\n")
        wanted = {key: content for key, content in self.server.objects.items() if recent in key and "KTLX" not in key}
        self.assertEqual(self.files(), wanted)
        self.fill("KLSX", 999, recent, 9)
        self.assertEqual(self.copy("KLSX", "KILX").stdout, "1 chunks\n")

    def test_a_number_that_comes_again_loses_its_older_chunks(self):
        older, newer = self.stamp(1800), self.stamp(60)
        self.fill("KLSX", 1, older, 3)
        self.copy("KLSX")
        self.server.objects.clear()
        self.fill("KLSX", 1, newer, 2)
        self.copy("KLSX")
        self.assertEqual(self.files(), self.server.objects)

    def test_a_bucket_that_fails_is_named(self):
        self.server.objects = {"KLSX/1/" + self.stamp(60) + "-001-S": b""}
        self.server.shutdown()
        self.server.server_close()
        run = self.copy("KLSX")
        self.assertIn("KLSX", run.stderr)
        self.assertEqual(run.stdout, "0 chunks\n")
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), BucketHandler)
        self.thread = threading.Thread(target=self.server.serve_forever)
        self.thread.start()

    def test_a_product_of_ldm_gets_the_name_of_the_feed(self):
        def take(identifier):
            return subprocess.run([sys.executable, UTILITIES / "copy-feed", "ldm", identifier, "-o", self.feed],
                                  input=b"bytes", capture_output=True, timeout=60, check=False)
        self.assertEqual(take("L2-BZIP2/KABX/20120510173527/552/30/I/V06/0").returncode, 0)
        self.assertEqual(self.files(), {"KABX/552/20120510-173527-030-I": b"bytes"})
        refused = take("SDUS54 KLSX 121800")
        self.assertEqual(refused.returncode, 2)
        self.assertIn(b"names no chunk", refused.stderr)


class SyntheticFeed(unittest.TestCase):
    def test_watch_keeps_what_it_promises(self):
        """Ten minutes of three radars at 40 times real time, with every disorder, ended twice in between."""
        run = subprocess.run(
            [sys.executable, UTILITIES / "try-watch", "--program", PROGRAM, "--minutes", "0.25", "--speed", "40",
             "--dims", "64x64x32", "--kills", "2"], capture_output=True, text=True, timeout=280, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        report = json.loads(run.stdout)
        self.assertEqual(report["other_bytes"], [])
        self.assertGreaterEqual(report["files_of_grid"], 3)


if __name__ == "__main__":
    unittest.main()
