# SPDX-License-Identifier: BSD-3-Clause
"""Checks the folders of the sources: who includes whom, and how a source is named.

Each check takes the root of a source tree and returns the faults that it finds, a line each.
"""

import collections
import fnmatch
import os
import pathlib
import re

# The modules of Source, and those that each may include. Plugins counts as one more.
MAY_INCLUDE = {
    "Core": [],
    "Rendering": [],
    "IO": ["Core"],
    "Filters": ["Core", "IO"],
    "Scene": ["Core", "IO", "Filters", "Rendering"],
    "Application": ["Core", "IO", "Filters", "Rendering", "Scene"],
    "Python": [],
    "Plugins": ["Core", "IO", "Filters", "Rendering", "Scene"],
}

# Sources without a header of their own name, and why: the first pattern that fits the path counts.
NO_HEADER = {
    "*/main.cxx": "holds main alone",
    "Source/Application/*Command.cxx": "is declared in Commands/CommandLine.h",
    "*LibraryEntry.cxx": "holds the functions that a program finds in a library by name",
    "Source/Rendering/Override/vtkTextureSliceOverride.cxx": "runs by being loaded",
    "Testing/*/Test*.cxx": "is a test",
    "Testing/Benchmarks/Benchmark*.cxx": "is a program",
    "Testing/Filters/MergeInProcesses.cxx": "is a program",
    "Testing/Fuzz/*.cxx": "is half of a program, which a fuzzer's library can replace",
    "Testing/Package/*/*.cxx": "is a program of somebody else",
}

# The mapper of slices and the parts that it hands itself to: they draw a frame together, and count as one file.
MAPPER = {"Source/Rendering/" + name for name in (
    "vtkOpenGLTextureSliceVolumeMapper", "vtkTextureSliceEmptySpace", "vtkTextureSliceParts", "vtkTextureSliceRequest",
    "vtkTextureSliceShadows", "vtkTextureSliceTarget", "vtkTextureSliceWays")}

SOURCES = (".c", ".cxx", ".glsl", ".h", ".hxx", ".py")
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.MULTILINE)


def source_files(root, *tops):
    """Paths below the top folders, with slashes, relative to the root."""
    root = pathlib.Path(root)
    return sorted(path.relative_to(root).as_posix() for top in tops for path in (root / top).rglob("*")
                  if path.suffix in SOURCES and path.is_file())


class Includes:
    """Which file of the tree includes which other; files of other projects are left out."""

    def __init__(self, root):
        self.files = source_files(root, "Source", "Plugins")
        self.by_name = collections.defaultdict(list)
        for file in self.files:
            self.by_name[os.path.basename(file)].append(file)
        self.of_tree = []   # pairs of paths
        self.of_others = []  # path, included name
        for file in self.files:
            for name in INCLUDE.findall((pathlib.Path(root) / file).read_text(encoding="utf-8")):
                found = self.find(file, name)
                if found is None:
                    self.of_others.append((file, name))
                else:
                    self.of_tree.append((file, found))

    def find(self, includer, name):
        """The file that the name means in that file: nearest first, as the compiler looks."""
        if name.startswith("nexrad/"):
            name = "Core/" + name[len("nexrad/"):]
        fitting = [file for file in self.by_name[os.path.basename(name)] if ("/" + file).endswith("/" + name)]
        return max(fitting, key=lambda file: len(os.path.commonpath([file, includer])), default=None)


def folder_of(file):
    return os.path.dirname(file)


def module_of(file):
    """Core, IO, ...; None for a file in Source itself."""
    parts = file.split("/")
    if parts[0] == "Plugins":
        return "Plugins"
    return parts[1] if len(parts) > 2 else None


def core_order(root):
    """The folders of Source/Core in the order in which its CMakeLists.txt names them."""
    text = (pathlib.Path(root) / "Source/Core/CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"foreach\s*\(folder IN ITEMS ([^)]*)\)", text)
    if found is None:
        raise ValueError("Source/Core/CMakeLists.txt names its folders in no foreach(folder IN ITEMS ...)")
    return ["Source/Core/" + name for name in found.group(1).split()]


def check_core_order(root):
    order = core_order(root)
    includes = Includes(root)
    faults = []
    unnamed = {folder_of(file) for file in includes.files if file.startswith("Source/Core/")} - set(order)
    faults += [f"{folder}: Source/Core/CMakeLists.txt does not name it" for folder in sorted(unnamed)]
    for includer, included in includes.of_tree:
        here, there = folder_of(includer), folder_of(included)
        if here in order and there in order and order.index(there) > order.index(here):
            faults.append(f"{includer}: includes {included}, which stands later in Source/Core/CMakeLists.txt")
    return faults


def check_core_without_vtk(root):
    return [f"{includer}: includes {name}; Core does without VTK" for includer, name in Includes(root).of_others
            if module_of(includer) == "Core" and re.match(r"vtk", os.path.basename(name))]


def check_modules(root):
    faults = []
    includes = Includes(root)
    for module in sorted({module_of(file) for file in includes.files} - set(MAY_INCLUDE), key=str):
        faults.append(f"Source/{module}: is no module that Testing/Layers/layers.py knows")
    for includer, included in includes.of_tree:
        here, there = module_of(includer), module_of(included)
        if here != there and there not in MAY_INCLUDE.get(here, []):
            faults.append(f"{includer}: includes {included}; {here} may not include {there}")
    return faults


def reachable(start, arrows):
    seen = set()
    waiting = [start]
    while waiting:
        for part in arrows.get(waiting.pop(), ()):
            if part not in seen:
                seen.add(part)
                waiting.append(part)
    return seen


def find_circles(root, part_of):
    """Parts (folders, say) of the tree that include each other, directly or by way of others."""
    arrows = collections.defaultdict(dict)
    for includer, included in Includes(root).of_tree:
        if part_of(includer) != part_of(included):
            arrows[part_of(includer)].setdefault(part_of(included), f"{includer} includes {included}")
    reach = {part: reachable(part, arrows) for part in list(arrows)}
    faults = []
    told = set()
    for part in sorted(reach):
        if part in reach[part] and part not in told:
            circle = [other for other in sorted(reach) if other in reach[part] and part in reach[other]]
            told.update(circle)
            examples = [text for one in circle for other, text in sorted(arrows[one].items()) if other in circle]
            faults.append(f"{', '.join(circle)}: include each other in a circle: {'; '.join(examples)}")
    return faults


def check_circles_of_folders(root):
    return find_circles(root, folder_of)


def check_circles_of_files(root):
    """A header and its source count as one, and so do those of MAPPER."""
    def file_of(path):
        name = os.path.splitext(path)[0]
        return min(MAPPER) if name in MAPPER else name
    return find_circles(root, file_of)


def sources_without_header(root):
    files = set(source_files(root, "Source", "Plugins", "Testing"))
    return [file for file in sorted(files)
            if file.endswith(".cxx") and file[:-len("cxx")] + "h" not in files]


def check_own_headers(root):
    return [f"{file}: has no header of its own name beside it" for file in sources_without_header(root)
            if not any(fnmatch.fnmatchcase(file, pattern) for pattern in NO_HEADER)]


def check_exceptions(root):
    """Exceptions that nothing needs any more."""
    files = sources_without_header(root)
    return [f"{pattern}: no source needs this exception; take it out of Testing/Layers/layers.py"
            for pattern in NO_HEADER if not any(fnmatch.fnmatchcase(file, pattern) for file in files)]


def check_vtk_components(root):
    """What CMake looks for in VTK is what some target links."""
    root = pathlib.Path(root)
    text = (root / "CMake/NexradVTK.cmake").read_text(encoding="utf-8")
    found = re.search(r"find_package\(VTK [0-9.]+ REQUIRED COMPONENTS(.*?)OPTIONAL_COMPONENTS", text, re.DOTALL)
    if found is None:
        raise ValueError("CMake/NexradVTK.cmake looks for no components of VTK")
    lists = [path for top in ("Source", "Testing") for name in ("CMakeLists.txt", "vtk.module")
             for path in (root / top).rglob(name)]
    linked = set(re.findall(r"VTK::(\w+)", "\n".join(path.read_text(encoding="utf-8") for path in lists)))
    return [f"CMake/NexradVTK.cmake: looks for {name}, which no target links"
            for name in found.group(1).split() if name not in linked]
