# SPDX-License-Identifier: BSD-3-Clause
"""The documents: links, headings and files that they name exist, and so do the program's commands and options."""

import functools
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["NEXRAD_SOURCE"])
PROGRAM = os.environ["NEXRAD3D"]

LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.+?) *$", re.MULTILINE)
CODE_BLOCK = re.compile(r"^ *```.*?^ *```", re.MULTILINE | re.DOTALL)
CODE_SPAN = re.compile(r"`([^`\n]+)`")
FOLDERS = "Source|Testing|Utilities|Documentation|Data|Plugins|CMake"
NAMED_FILE = re.compile(rf"(?:{FOLDERS})/[\w./-]*")
# The name, as a command line or a sentence has it, and what follows up to the end of the command.
COMMAND = re.compile(r"(?:^|[\s/])nexrad3d +([a-z]+)\b([^\n|&#`]*)")
NAMED_ROW = re.compile(r"Formulas ([A-Z]\d+[a-z]?)\b")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


def documents():
    return sorted([*ROOT.glob("*.md"), *ROOT.glob("Data/*.md"), *ROOT.glob("Documentation/**/*.md")])


def anchors(text):
    """The targets that GitHub makes of the headings."""
    headings = HEADING.findall(CODE_BLOCK.sub("", text))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(document):
    broken = []
    for target in LINK.findall(CODE_BLOCK.sub("", document.read_text())):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = document.parent / path if path else document
        if not file.exists():
            broken.append(f"{target}: no such file")
        elif anchor and anchor not in anchors(file.read_text()):
            broken.append(f"{target}: no such heading")
    return broken


def missing_files(text):
    """Files of the project in code font that do not exist; those of commands as well."""
    code = CODE_SPAN.findall(CODE_BLOCK.sub("", text)) + CODE_BLOCK.findall(text)
    named = {name for piece in code for name in NAMED_FILE.findall(" " + piece)
             if re.search(rf"(?<![\w/.]){re.escape(name)}", " " + piece)}
    return sorted(name for name in named if not (ROOT / name.rstrip(".")).exists())


@functools.lru_cache(maxsize=None)
def help_of(*command):
    """What `--help` of the program or of one of its commands prints; empty when there is no such command."""
    if command and not re.search(rf"^  {command[0]} ", help_of(), re.MULTILINE):
        return ""  # the program's own help is what it prints after a word that is no command
    return subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, timeout=60,
                          check=True).stdout


def wrong_commands(text):
    wrong = []
    for command, arguments in COMMAND.findall("\n".join(CODE_SPAN.findall(text) + CODE_BLOCK.findall(text))):
        text_of_help = help_of(command)
        if not text_of_help:
            wrong.append(f"nexrad3d {command}: no such command")
        for option in OPTION.findall(arguments):
            if text_of_help and option not in OPTION.findall(text_of_help):
                wrong.append(f"nexrad3d {command} {option}: no such option")
    return wrong


def rows_of_merging():
    """The table of the options of merging, as `grid --help` describes them."""
    group = help_of("grid").partition("\nMerging radar files:\n")[2].partition("\n\n")[0]
    lines = re.sub(r"\n {10,}", "   ", group)  # a sentence begins a line of its own after a long option
    found = re.findall(r"^  (--[a-z-]+)(?: [A-Zx][A-Zx.,]*(?:=(\S+))?)?(?: Excludes: \S+)? +(\S.*)$", lines,
                       re.MULTILINE)
    return [f"| `{option}` | {default} | {sentence} |" for option, default, sentence in found]


class Documents(unittest.TestCase):
    def each(self, faults):
        self.assertGreater(len(documents()), 15)
        for document in documents():
            with self.subTest(str(document.relative_to(ROOT))):
                self.assertEqual(faults(document), [])

    def test_links(self):
        self.each(broken_links)

    def test_named_files(self):
        self.each(lambda document: missing_files(document.read_text()))

    def test_commands(self):
        self.each(lambda document: wrong_commands(document.read_text()))

    def test_the_table_of_merging_is_that_of_the_program(self):
        page = (ROOT / "Documentation" / "User" / "3-merging.md").read_text()
        self.assertGreater(len(rows_of_merging()), 15)
        self.assertIn("\n".join(rows_of_merging()), page)

    def test_pages_begin_with_what_they_are_for(self):
        """A heading, then a paragraph: no list, table, picture or second heading."""
        for document in documents():
            with self.subTest(str(document.relative_to(ROOT))):
                heading, _, rest = document.read_text().partition("\n")
                self.assertRegex(heading, r"^# \S")
                self.assertRegex(rest.lstrip(), r"^[A-Z`][^|!]")

    def test_rows_of_the_formulas(self):
        """Each row that a comment names ("Formulas B2") is there."""
        text = (ROOT / "Documentation" / "Developer" / "formulas.md").read_text()
        rows = set(re.findall(r"^(?:\| |### )([A-Z]\d+[a-z]?)\b", text, re.MULTILINE))
        named = {row for folder in ("Source", "Testing") for file in (ROOT / folder).rglob("*")
                 if file.suffix in (".h", ".cxx", ".glsl") for row in NAMED_ROW.findall(file.read_text())}
        self.assertGreater(len(named), 30)
        self.assertEqual(sorted(named - rows), [])

    def test_user_guide_is_in_order(self):
        """Each page leads to the next one."""
        pages = sorted((ROOT / "Documentation" / "User").glob("[0-9]*.md"))
        for page, following in zip(pages, pages[1:]):
            with self.subTest(page.name):
                self.assertIn(following.name, page.read_text().rstrip().rsplit("\n", 1)[-1])


class TheChecksThemselves(unittest.TestCase):
    def test_find_broken_links(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("# One `page`\n[a](#one-page) [b](#two) ![c](no.png) [d](page.md#one-page)\n"
                            "```\n[e](in-code.md)\n```\n")
            self.assertEqual(broken_links(page), ["#two: no such heading", "no.png: no such file"])

    def test_find_missing_files(self):
        text = "`Utilities/run-tests`, `Source/Nothing.h`, `PREFIX/Data/none`\n```\nUtilities/none FOLDER\n```\n"
        self.assertEqual(missing_files(text), ["Source/Nothing.h", "Utilities/none"])

    def test_find_wrong_commands(self):
        text = "`nexrad3d fly`\n```\nbin/nexrad3d grid IN --wings 3 -o DIR && nexrad3d info --json\n```\n"
        self.assertEqual(wrong_commands(text),
                         ["nexrad3d fly: no such command", "nexrad3d grid --wings: no such option"])


if __name__ == "__main__":
    unittest.main()
