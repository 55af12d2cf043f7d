# SPDX-License-Identifier: BSD-3-Clause
"""Weather radar volumes in VTK: NEXRAD Level II files to merged volumes and pictures.

Readers and writers: vtkNexradLevel2Reader, vtkNexradSeriesReader, vtkNexradVolumeReader,
vtkNexradVolumeWriter. Merging: vtkNexradDayReader, vtkNexradSiteMerge, vtkNexradVolumeResampler.
Drawing: vtkOpenGLTextureSliceVolumeMapper, vtkNexradTransferFunction,
vtkTextureSliceObjectFactory. The whole picture that nexrad3d draws: vtkNexradSession,
vtkNexradVolumeScene. They work beside VTK's own modules; help() of a class has its units,
defaults and errors.

Beside the classes, vtknexrad.data has what a script needs to get from them to numpy: update,
time_steps, array, axes, sweep, echo_classes. They are names of vtknexrad as well.
"""

import importlib.util

# Without these imports VTK's object factories have no OpenGL classes to give.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401

from .vtkNexradIO import *  # noqa: F401,F403
from .vtkNexradFilters import *  # noqa: F401,F403
from .vtkNexradRendering import *  # noqa: F401,F403
if importlib.util.find_spec(".vtkNexradScene", __name__) is not None:  # not in a build for ParaView
    from .vtkNexradScene import *  # noqa: F401,F403
from .data import array, axes, echo_classes, sweep, time_steps, update  # noqa: F401
