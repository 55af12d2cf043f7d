# SPDX-License-Identifier: BSD-3-Clause
"""Writes type stubs of the wrapped VTK classes: MakeStubs.py FOLDER MODULE...

FOLDER contains the package vtknexrad, and takes MODULE.pyi for each MODULE of it, as vtkNexradIO. The
signatures are those that VTK's wrappers put into the docstrings:

    SetDimensions(self, _arg1:int, _arg2:int, _arg3:int) -> None
    C++: virtual void SetDimensions(int _arg1, int _arg2, int _arg3)
"""

import importlib
import os
import re
import sys

NUMBERS = {"int": "int", "float": "float", "bool": "bool", "str": "str", "None": "None", "bytes": "bytes"}


class Module:
    """The text of the stub of one module."""

    def __init__(self, name):
        self.module = importlib.import_module(f"vtknexrad.{name}")
        self.imports = set()
        classes = [one for one in vars(self.module).values()
                   if isinstance(one, type) and one.__module__ == self.module.__name__ and one.__name__[0].isalpha()]
        classes.sort(key=lambda one: (len(one.__mro__), one.__name__))  # a base class before those derived of it
        self.text = "\n\n".join(self.class_text(one) for one in classes)

    def write(self, path):
        lines = ["# Made by MakeStubs.py of the signatures of the wrapped classes.",
                 "from typing import Any, MutableSequence, Sequence, overload", *sorted(self.imports), ""]
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n" + self.text + "\n")

    def class_text(self, wrapped):
        lines = [f"class {wrapped.__name__}({self.class_name(wrapped.__bases__[0])}):"]
        methods = []
        for name, member in sorted(vars(wrapped).items()):
            if isinstance(member, int) and not name.startswith("_"):
                lines.append(f"    {name}: int")
            elif isinstance(member, type):
                lines.append(f"    {name} = int")  # an enumeration: its values are ints
            elif callable(member) and not name.startswith("_"):
                methods += self.method_lines(name, member.__doc__ or "")
        return "\n".join(lines + methods + ([] if len(lines) > 1 or methods else ["    ..."]))

    def method_lines(self, name, doc):
        found = re.findall(rf"^{name}\((.*?)\)\s*(?:-> (.*?))?\nC\+\+:(.*?)(?=\n\n|\n{name}\(|\Z)", doc,
                           re.MULTILINE | re.DOTALL)
        if not found:
            return [f"    def {name}(self, *arguments: Any) -> Any: ..."]
        lines = []
        for arguments, result, native in dict.fromkeys(found):
            if len(set(found)) > 1:
                lines.append("    @overload")
            given = split(arguments)
            if given[:1] != ["self"] and native.split()[:1] == ["static"]:
                lines.append("    @staticmethod")
            parameters = ", ".join(self.parameter(one) for one in given)
            lines.append(f"    def {name}({parameters}) -> {self.type_text(result or 'None')}: ...")
        return lines

    def parameter(self, text):
        name, _, kind = text.partition(":")
        kind, _, default = kind.partition("=")
        if not kind:
            return name
        return f"{name}: {self.type_text(kind, True)}{' = ' + default if default else ''}"

    def type_text(self, text, given=False):
        text = " ".join(text.split())
        if text in NUMBERS:
            return NUMBERS[text]
        if text == "(float, ...)":
            return "Sequence[float]" if given else "tuple[float, ...]"
        if text[:1] == "(":
            inner = [self.type_text(one) for one in split(text[1:-1])]
            return f"Sequence[{inner[0]}]" if given else f"tuple[{', '.join(inner)}]"
        if text[:1] == "[":
            return f"MutableSequence[{self.type_text(split(text[1:-1])[0])}]"
        for module in [self.module, *(one for name, one in sorted(sys.modules.items())
                                      if name.startswith(("vtknexrad.vtk", "vtkmodules.vtk")))]:
            if isinstance(getattr(module, text, None), type):
                return self.class_name(getattr(module, text))
        return "Any"

    def class_name(self, wrapped):
        if wrapped.__module__ != self.module.__name__:
            self.imports.add(f"from {wrapped.__module__} import {wrapped.__name__}")
        return wrapped.__name__


def split(text):
    """The parts between commas that are in no brackets."""
    parts, depth = [""], 0
    for character in " ".join(text.split()):
        depth += (character in "([") - (character in ")]")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts if part.strip()]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder, names = sys.argv[1], sys.argv[2:]
    sys.path.insert(0, folder)
    for name in names:
        Module(name).write(os.path.join(folder, "vtknexrad", f"{name}.pyi"))


if __name__ == "__main__":
    main()
