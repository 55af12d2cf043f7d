# SPDX-License-Identifier: BSD-3-Clause
"""Measured figures and their bounds in the list of tolerances, as Testing/Support/Tolerance.h has them for C++."""

import os


def at_least(test, measured, bound, what, reason=""):
    """Asserts measured >= bound; appends a line to the file that NEXRAD_TOLERANCES names."""
    _record(test, what, measured, bound, "least", reason)
    test.assertGreaterEqual(measured, bound, what)


def at_most(test, measured, bound, what, reason=""):
    """Asserts measured <= bound; appends a line to the file that NEXRAD_TOLERANCES names."""
    _record(test, what, measured, bound, "most", reason)
    test.assertLessEqual(measured, bound, what)


def _record(test, *columns):
    path = os.environ.get("NEXRAD_TOLERANCES")
    if path:
        line = "\t".join([test.id(), *map(str, columns)]) + "\n"
        file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
        try:
            os.write(file, line.encode())  # in one write: other processes append too
        finally:
            os.close(file)
