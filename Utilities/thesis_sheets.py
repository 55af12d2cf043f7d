"""Draws experiments of the thesis as sheets of pictures, for make-pictures. Each picture is WxH pixels.

  thesis_sheets.py resolution SHEET.png WxH VOLUME.nxv...  one time in volumes of several sizes, the finest last
  thesis_sheets.py slices SHEET.png WxH VOLUME.nxv         one volume by 16 to 2048 slices
  thesis_sheets.py times SHEET.png WxH VOLUME.nxv...       several times in one frame, 20 degrees from the vertical
  thesis_sheets.py sweeps SHEET.png WxH VOLUME.nxv FILE    the sweeps of a radar file on the map of its volume

Differences are means over red, green and blue (0 to 255) of the pixels that the volume covers: those in which the
picture of reference differs from the picture without the volume. Slices take one sample each, as the thesis drew them.
Needs the Python package of the build, Pillow and matplotlib, and a display.
"""

import sys

import matplotlib.font_manager
import numpy
import vtknexrad
from PIL import Image, ImageDraw, ImageFont
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkBillboardTextActor3D, vtkColorTransferFunction, vtkDataSetMapper,
                                         vtkPolyDataMapper, vtkRenderWindow, vtkWindowToImageFilter)

LEAST_ECHO = 5.0  # dBZ, the first step of the colours
REACH = 230e3  # m along the ray
TOP = 20e3  # m above mean sea level


class Pictures:
    """A scene off screen, with slices of one sample each."""

    def __init__(self, size):
        self.scene = vtknexrad.vtkNexradVolumeScene()
        self.scene.SetOption("classification", "sampled")
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(4)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.scene.GetRenderer())

    def draw(self, volume_is_shown=True):
        self.window.Render()
        volumes = self.scene.GetRenderer().GetVolumes()
        for number in range(volumes.GetNumberOfItems()):
            volumes.GetItemAsObject(number).SetVisibility(volume_is_shown)
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        image = grabber.GetOutput()
        width, height = image.GetDimensions()[:2]
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]


def difference(picture, reference, ground):
    covered = (reference != ground).any(axis=2)
    return numpy.abs(picture.astype(int) - reference)[covered].mean()


def write_sheet(path, title, panels, columns):
    """Pictures in rows, each below its label, under a title."""
    height, width = panels[0][0].shape[:2]
    letters = max(10, height // 28)
    gap, strip = letters // 2, 2 * letters
    rows = -(-len(panels) // columns)
    sheet = Image.new("RGB", (columns * (width + gap) + gap, rows * (height + strip + gap) + strip), (31, 33, 38))
    draw = ImageDraw.Draw(sheet)

    def write(place, text, size, weight):
        face = matplotlib.font_manager.findfont(matplotlib.font_manager.FontProperties("DejaVu Sans", weight=weight))
        draw.text(place, text, fill=(242, 245, 250), font=ImageFont.truetype(face, size), anchor="lm")

    write((gap, strip // 2), title, letters * 6 // 5, "bold")
    for number, (picture, label) in enumerate(panels):
        left = gap + number % columns * (width + gap)
        top = strip + number // columns * (height + strip + gap)
        write((left, top + strip // 2), label, letters, "normal")
        sheet.paste(Image.fromarray(picture), (left, top + strip))
    sheet.save(path, optimize=True)


def name_of(volume):
    return "x".join(map(str, volume.image.GetDimensions())) + " voxels"


def resolution(size, *volumes):
    drawn = []
    for volume in volumes:
        pictures = Pictures(size)
        pictures.scene.SetVolume(volume.image)
        drawn.append((pictures.draw(), pictures.draw(False)))
    panels = []
    for volume, (picture, _) in zip(volumes, drawn):
        east, north, up = (spacing / 1e3 for spacing in volume.image.GetSpacing())
        label = f"{name_of(volume)} of {east:.1f} x {north:.1f} x {up:.2f} km"
        if volume is not volumes[-1]:
            label += f"; {difference(picture, *drawn[-1]):.1f} of 255 from the finest"
        panels.append((picture, label))
    return "One time merged into volumes of several sizes, 256 slices (as figure 4.3 of the thesis)", panels, 2


def slices(size, volume):
    pictures = Pictures(size)
    pictures.scene.SetVolume(volume.image)

    def draw(count, volume_is_shown=True):
        pictures.scene.SetOption("slices", float(count))
        return pictures.draw(volume_is_shown)

    reference, ground = draw(2048), draw(2048, False)
    panels = []
    for count in (16, 32, 64, 128, 256, 512, 1024):
        picture = draw(count)
        panels.append((picture, f"{count} slices; {difference(picture, reference, ground):.2f} of 255 from 2048"))
    panels.append((reference, "2048 slices"))
    return f"One volume of {name_of(volume)} by more and more slices (as figure 4.4 of the thesis)", panels, 4


def times(size, *volumes):
    pictures = Pictures(size)
    pictures.scene.SetAzimuth(180.0)
    pictures.scene.SetTilt(70.0)
    for volume in volumes:
        pictures.scene.AddToFrame(volume.image)
    panels = []
    for volume in volumes:
        pictures.scene.SetVolume(volume.image)
        panels.append((pictures.draw(), f"{str(volume.time)[11:16]} UTC"))
    return f"Seen 20 degrees from the vertical, {name_of(volumes[0])} (as figure 4.1 of the thesis)", panels, 2


def layers_of(radar):
    """The sweeps with reflectivity from the lowest on, one of each elevation, as points, values and elevation."""
    layers = {}
    for sweep in radar:
        if "REF" in sweep and not any(abs(sweep.elevation - other) < 0.25 for other in layers):
            points = sweep.xyz("REF") + (0.0, 0.0, radar.position[2])
            field = sweep["REF"]
            gates = (field.ranges <= REACH) & (points[0, :, 2] <= TOP)
            values = field.values.filled(numpy.nan)[:, gates]
            # A circle ends with its first ray.
            layers[sweep.elevation] = [numpy.concatenate((rows, rows[:1])) for rows in (points[:, gates], values)]
    return [(elevation, *layers[elevation]) for elevation in sorted(layers)]


def actor_of(mapper, to_scene):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetUserTransform(to_scene)
    actor.GetProperty().LightingOff()
    return actor


def echo_of(points, values, colours):
    """The echo of a sweep in the colours of the scene."""
    grid = vtkStructuredGrid()
    grid.SetDimensions(points.shape[1], points.shape[0], 1)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points.reshape(-1, 3), deep=True))
    grid.SetPoints(places)
    array = numpy_to_vtk(values.ravel(), deep=True)
    array.SetName("REF")
    grid.GetPointData().SetScalars(array)
    echo = vtkThreshold()
    echo.SetInputData(grid)
    echo.SetInputArrayToProcess(0, 0, 0, 0, "REF")
    echo.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    echo.SetUpperThreshold(LEAST_ECHO)
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(echo.GetOutputPort())
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    return mapper


def ring_of(points):
    """The last gates of a sweep."""
    line = vtkLineSource()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points[:, -1]), deep=True))
    line.SetPoints(places)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(line.GetOutputPort())
    return mapper


def add_layers(pictures, radar):
    scene, renderer = pictures.scene, pictures.scene.GetRenderer()
    zero, one = [0.0] * 3, [0.0] * 3
    scene.VolumeToScene((0.0, 0.0, 0.0), zero)
    scene.VolumeToScene((1e3, 1e3, 1e3), one)
    to_scene = vtkTransform()
    to_scene.Translate(zero)
    to_scene.Scale([(b - a) / 1e3 for a, b in zip(zero, one)])
    colours = vtkColorTransferFunction()
    scene.GetTransferFunction().FillSteppedColorFunction(colours)
    for number, (elevation, points, values) in enumerate(layers_of(radar)):
        renderer.AddActor(actor_of(echo_of(points, values, colours), to_scene))
        ring = actor_of(ring_of(points), to_scene)
        ring.GetProperty().SetColor(0.45, 0.55, 0.62)
        renderer.AddActor(ring)
        # East and west by turns, so that neighbours do not cover each other's labels.
        azimuth = numpy.radians(50 + 10 * number if number % 2 == 0 else 310 - 10 * number)
        last = points[:, -1]
        towards = last[:, 0] * numpy.sin(azimuth) + last[:, 1] * numpy.cos(azimuth)
        label = vtkBillboardTextActor3D()
        label.SetInput(f"{elevation:.1f}\N{DEGREE SIGN}")
        label.SetPosition(to_scene.TransformPoint(last[towards.argmax()]))
        label.GetTextProperty().SetColor(0.2, 0.25, 0.3)
        label.GetTextProperty().SetFontSize(max(9, pictures.window.GetSize()[1] // 45))
        renderer.AddActor(label)


def sweeps(size, volume, radar):
    panels = []
    for label, tilt in (("From the side, looking north", 8.0), ("From above", 90.0)):
        pictures = Pictures(size)
        pictures.scene.SetVolume(volume.image)
        pictures.scene.SetOption("frame", "domain")
        pictures.scene.SetAzimuth(180.0)
        pictures.scene.SetTilt(tilt)
        pictures.scene.SetParallelProjection(tilt == 90.0)
        pictures.draw()
        add_layers(pictures, radar)
        panels.append((pictures.draw(False), label))
    begin = str(radar.time)[:19]
    return f"The sweeps of {radar.radar}, {begin}Z, to 230 km and 20 km height (as figure 3.8 of the thesis)", panels, 2


def main(task, sheet, size, *inputs):
    opened = [vtknexrad.Volume.open(name) if name.endswith(".nxv") else vtknexrad.RadarVolume(name) for name in inputs]
    experiment = {"resolution": resolution, "slices": slices, "times": times, "sweeps": sweeps}[task]
    title, panels, columns = experiment([int(part) for part in size.split("x")], *opened)
    write_sheet(sheet, title + (", SYNTHETIC" if opened[0].synthetic else ""), panels, columns)
    print(title, *(label for _, label in panels), sep="\n")


main(*sys.argv[1:])
