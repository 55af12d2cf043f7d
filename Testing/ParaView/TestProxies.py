# SPDX-License-Identifier: BSD-3-Clause
"""Every proxy: it can be made, has the class's settings with the class's defaults, and explains them."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

import Plugin
import vtknexrad
from paraview import simple

# What a class can be told that is no setting of a user.
NOT_SETTINGS = {
    "SetOption",  # each option is a property of its own
    "SetController",  # processes that read together: the application's matter
    "SetScalarsAsCodes",  # ParaView's own filters take each number for a value, never for a code
    "SetBeginTime", "SetEndTime",  # the panel takes them as text
}
# What the plugin decides otherwise than the class: the processes of a server share the work.
OTHER_DEFAULTS = {"SetUseGlobalController": 1}
# Calls that set an option of the merge, which GetOption tells. Python.Merge compares the properties that call SetOption.
OPTIONS = {"SetDimensions": "dims", "SetRange": "range", "SetHeightRange": "height"}
# A number is understood with one of these words beside it.
UNITS = re.compile(r"metre|degree|second|byte|dBZ|unit|pixel|opacity|over the earth", re.IGNORECASE)


def properties(proxy):
    """Names and properties of a proxy of the server manager, as XML defines them."""
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def settings(proxy):
    """The properties that a user sets and that end in a call SetX of the class, by that call."""
    return {one.GetCommand(): one for _, one in properties(proxy)
            if (one.GetCommand() or "").startswith("Set") and one.GetCommand() != "SetOption"
            and not one.GetInformationOnly()
            and one.GetClassName() not in ("vtkSMInputProperty", "vtkSMProxyProperty")}


def values(one):
    elements = [one.GetElement(i) for i in range(one.GetNumberOfElements())]
    return elements[0] if len(elements) == 1 else elements


def own_setters(name):
    """The calls SetX of a class of this project, and of its bases here, for which there is a GetX or an option."""
    ours = [one for one in getattr(vtknexrad, name).__mro__ if one.__module__.startswith("vtknexrad")]
    calls = {call for one in ours for call in vars(one)}
    return {call for call in calls
            if call in OPTIONS or call.startswith("Set") and "Get" + call[3:] in calls} - NOT_SETTINGS


class Settings(unittest.TestCase):
    proxies = [("sources", name, kind) for name, kind in Plugin.SOURCES.items()] + \
        [("filters", name, kind) for name, kind in Plugin.FILTERS.items()] + \
        [("nexrad_internal", "VolumeFile", "vtkNexradVolumeReader"),
         ("writers", "NexradVolumeWriter", "vtkNexradVolumeWriter")]

    def test_defaults_are_those_of_the_classes(self):
        for group, name, kind in self.proxies:
            made = getattr(vtknexrad, kind)()
            for call, one in settings(Plugin.make(group, name)).items():
                with self.subTest(proxy=name, call=call):
                    if call in OPTIONS:
                        key, given = OPTIONS[call], values(one)
                        default = made.GetOption(key)
                        getattr(made, call)(*(given if isinstance(given, list) else [given]))
                        self.assertEqual(made.GetOption(key), default)
                        continue
                    default = getattr(made, "Get" + call[3:])()
                    default = list(default) if isinstance(default, tuple) else default
                    if call == "SetFileName":
                        self.assertIsNone(default)
                        continue
                    self.assertEqual(values(one), OTHER_DEFAULTS.get(call, default))

    def test_every_setting_of_a_class_is_a_property(self):
        for group, name, kind in self.proxies:
            with self.subTest(proxy=name):
                missing = own_setters(kind) - set(settings(Plugin.make(group, name)))
                if kind != "vtkNexradEchoClasses":  # which has no settings
                    self.assertGreaterEqual(len(own_setters(kind)), 2)
                self.assertEqual(missing, set())

    def test_properties_explain_themselves_with_units(self):
        for group, name, _ in self.proxies + [("filters", "NexradMap", ""), ("filters", "NexradTimeText", ""),
                                             ("representations", "NexradTextureSliceRepresentation", "")]:
            base = Plugin.make("representations", "UniformGridVolumeRepresentation")
            theirs = {key for key, _ in properties(base)} if group == "representations" else set()
            for key, one in properties(Plugin.make(group, name)):
                if one.GetInformationOnly() or key in theirs or key == "FileName":
                    continue
                with self.subTest(proxy=name, property=key):
                    text = one.GetDocumentation() and one.GetDocumentation().GetDescription()
                    self.assertTrue(text and len(text) > 20, text)
                    if one.GetClassName() == "vtkSMDoubleVectorProperty":
                        self.assertRegex(text, UNITS)

    def test_every_proxy_is_a_name_of_paraview_simple(self):
        for name in ("NEXRADRadarDay", "NEXRADLevelIISeries", "NEXRADLevelIIReader",
                     "NEXRADTwoFields", "NEXRADVolumeReader", "NEXRADEchoOnly", "NEXRADMap", "NEXRADTime"):
            self.assertTrue(hasattr(simple, name), name)


# Writes the opacity of the plugin's "NEXRAD hail" at 60 dBZ; then, as an earlier version of the plugin might have, gives
# the preset another opacity, which ParaView writes to the user's settings at its end.
OTHER_VERSION = """
import os
from paraview import servermanager, simple
simple.LoadPlugin(os.environ["NEXRAD_PLUGIN"], remote=False)
opacity = simple.GetOpacityTransferFunction("a moment")
assert opacity.ApplyPreset("NEXRAD hail", False)
print("opacity", opacity.GetClientSideObject().GetValue(60.0))
presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
presets.RemovePreset([presets.GetPresetName(i) for i in range(presets.GetNumberOfPresets())].index("NEXRAD hail"))
presets.AddPreset("NEXRAD hail", '{"Name": "NEXRAD hail", "RGBPoints": [0, 0, 0, 0, 80, 1, 1, 1], '
                                 '"Points": [0, 0.25, 0.5, 0, 80, 0.25, 0.5, 0]}')
"""


class Presets(unittest.TestCase):
    def test_presets_of_another_version_in_the_settings_are_replaced(self):
        function = vtknexrad.vtkNexradTransferFunction()
        function.ApplyPreset("hail")
        with tempfile.TemporaryDirectory() as home:
            for _ in range(2):
                done = subprocess.run([os.environ["NEXRAD_PVPYTHON"], "-c", OTHER_VERSION], env={**os.environ, "HOME": home},
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100)
                sys.stdout.write(done.stdout)
                self.assertEqual(done.returncode, 0)
                found = re.search(r"^opacity (\S+)$", done.stdout, re.MULTILINE)
                self.assertAlmostEqual(float(found.group(1)), function.Evaluate(3, 60.0), delta=0.02)
            self.assertTrue(any("Settings" in name for _, _, names in os.walk(home) for name in names))

    def test_colour_maps_are_the_transfer_function_s(self):
        lut = simple.GetColorTransferFunction("a moment")
        lut.Discretize = 0
        opacity = simple.GetOpacityTransferFunction("a moment")
        for i in range(vtknexrad.vtkNexradTransferFunction.GetNumberOfPresets()):
            name = vtknexrad.vtkNexradTransferFunction.GetPresetName(i)
            function = vtknexrad.vtkNexradTransferFunction()
            function.ApplyPreset(name)
            self.assertTrue(lut.ApplyPreset("NEXRAD " + name, False), name)
            self.assertTrue(opacity.ApplyPreset("NEXRAD " + name, False), name)
            for dBZ in range(-20, 80, 3):
                color = [0.0, 0.0, 0.0]
                lut.GetClientSideObject().GetColor(dBZ, color)
                for channel in range(3):
                    self.assertAlmostEqual(color[channel], function.Evaluate(channel, dBZ), delta=0.02)
                self.assertAlmostEqual(opacity.GetClientSideObject().GetValue(dBZ),
                                       function.Evaluate(3, dBZ), delta=0.02)
            # Few enough for a person to edit them.
            self.assertLess(len(lut.RGBPoints) // 4, 80, name)
            self.assertLess(len(opacity.Points) // 4, 45, name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
