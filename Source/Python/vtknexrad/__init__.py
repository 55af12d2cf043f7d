# SPDX-License-Identifier: BSD-3-Clause
"""Weather radar volumes: NEXRAD Level II files to sweeps, merged volumes and pictures.

`open` opens every file of the project, `merge` merges radar files. What they give has numpy arrays,
datetime64 times and units, and to_xarray:

>>> radar = vtknexrad.open("KLSX20060312_180145")
>>> bool(radar[0]["REF"].values.max() > 40.0)
True
>>> series = vtknexrad.merge("KLSX", dims=(64, 64, 32))
>>> series[0]["REF"].values.shape
(32, 64, 64)

The examples use SYNTHETIC files: `nexrad3d simulate KLSX --sites KLSX --hours 0.2` makes the folder
KLSX, from which KLSX20060312_180145 is taken, and `nexrad3d grid KLSX -o volumes --dims 64x64x32`
the folder volumes.

Below them are the VTK classes. Readers and writers: vtkNexradLevel2Reader, vtkNexradSeriesReader,
vtkNexradVolumeReader, vtkNexradVolumeWriter. Merging: vtkNexradDayReader. Drawing:
vtkOpenGLTextureSliceVolumeMapper, vtkNexradTransferFunction, vtkTextureSliceObjectFactory. The
whole picture that nexrad3d draws: vtkNexradSession, vtkNexradVolumeScene. They work beside VTK's own modules; help() of a class has its units,
defaults and errors. vtknexrad.data has what a script needs to get from them to numpy: update,
time_steps, array, axes, sweep, echo_classes. They are names of vtknexrad as well.

`from vtknexrad import *` leaves Python's own `open` as it is.
"""

# Without these imports VTK's object factories have no OpenGL classes to give.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401

from .vtkNexradIO import *  # noqa: F401,F403
from .vtkNexradFilters import *  # noqa: F401,F403
from .vtkNexradRendering import *  # noqa: F401,F403
from .vtkNexradScene import *  # noqa: F401,F403
from ._version import __version__ as __version__
from .data import (array as array, axes as axes, echo_classes as echo_classes, sweep as sweep,
                   time_steps as time_steps, update as update)
from .errors import (DamageWarning as DamageWarning, Error as Error, OutOfRange as OutOfRange,
                     UnknownName as UnknownName, errors_of as errors_of)
from .fields import Field as Field, State as State
from .merging import merge as merge
from .opening import open as open
from .pictures import colours as colours
from .radar import RadarVolume as RadarVolume, Sweep as Sweep
from .series import VolumeSeries as VolumeSeries
from .volume import Volume as Volume

__all__ = [_name for _name, _thing in globals().items()
           if not _name.startswith("_") and _name != "open" and type(_thing).__name__ != "module"]


def __dir__() -> list[str]:
    """The names of the package without its modules: what completion offers."""
    return [*__all__, "open", "__version__"]
