// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Scales/ColourScale.h"
#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkNexradTransferFunction;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace nexrad::scene
{

/// Throws Error for a volume without voxels, and, unless it is drawn as a map, for one of a single
/// layer: that has no thickness, and VTK draws nothing of it.
void RequireVoxels(vtkImageData* data, const SceneOptions& options);

/// The volume, with values in place of codes unless slices of one moment draw it.
vtkSmartPointer<vtkImageData> AsDrawn(vtkImageData* data, const SceneOptions& options);

/// A mapper of that kind; pre-integration is of the slices alone.
vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper(const SceneOptions& options);

/// About three slices for every eight voxels that the usual view meets one behind the other, of the
/// volume as it stands in the scene: 128 to 1024.
int SlicesFor(vtkImageData* placed);

/// Sets the number of slices, or of samples along the longest ray through the volume, whose length
/// is `diagonal` in scene units.
void SetSlices(vtkVolumeMapper* mapper, int slices, double diagonal);

/// Draws a volume, not surfaces, in pixels up to 1.5 times as wide as the picture's where each
/// voxel still has at least 3 of them across: less than half of the work for what cannot be told
/// apart.
void SetPixelSize(vtkVolumeMapper* mapper, double pixelsOfVoxel);

/// Lights the surfaces of a property, or none of it. `shadows`: whether what is drawn has any.
void ShadeSurfaces(vtkVolumeProperty* property, bool surfaces, bool shadows);

/// Draws the surfaces of the property's iso-values, or the volume, with shadows and ambient
/// occlusion, which VTK's ray caster does not have. The slices light surfaces by smoothed
/// gradients: the echo of a gate is noisy.
void SetLight(vtkVolumeMapper* mapper, const LightOptions& light, bool surfaces);

/// Brings the light up to date before the frame is drawn. How much of it arrives, as
/// vtkOpenGLTextureSliceVolumeMapper::GetLightVolume has it; nullptr: there are no shadows.
vtkImageData* UpdateLight(vtkVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

/// Colours and opacities (where another array gives the colours, opacities) as the options ask for,
/// for the moment of that array ("REF"; the preset of
/// any other array is that of reflectivity). Throws Error for a preset that does not exist or is of
/// another moment, and a file that is no colour map.
vtkSmartPointer<vtkNexradTransferFunction> MakeTransferFunction(
  const SceneOptions& options, const std::string& array = "REF");

/// The iso-values of a function, with their opacities.
std::vector<IsoValue> IsoValuesOf(vtkNexradTransferFunction* transferFunction);

/// The values in ascending order, each with an opacity: where none is given, from 0.35 for the
/// lowest to 0.95 for the highest value.
std::vector<IsoValue> WithOpacities(std::vector<IsoValue> isoValues);

/// Makes the opacities shells about values, and the values those of surfaces, WithOpacities.
void SetIsoValues(std::vector<IsoValue> isoValues, vtkNexradTransferFunction* transferFunction);

/// The boxes of the look's colour bar: its own steps, or one for each 5 dBZ (another round width
/// where the colours span less than 20 or more than 120).
ColourTable ColourStepsOf(vtkNexradTransferFunction* transferFunction);

/// How values are written where people read them: factor × value + offset in this unit.
struct LabelUnit
{
  std::string name;
  double factor = 1.0; ///< above 0
  double offset = 0.0; ///< in the unit

  double ToLabel(double value) const { return factor * value + offset; }
  double ToValue(double label) const { return (label - offset) / factor; }
};

/// The unit of a look's colour table, as knots; that of the data where the table has none, or has
/// another scale and no unit, as that would be misread. `look` may be nullptr.
LabelUnit LabelUnitOf(const vtkNexradTransferFunction* look, const std::string& ofData);

/// The scale of a moment, or of another array of that name, in the colours of a look: with the unit
/// and the labels of its colour table, where it has any.
ColourScale ScaleOf(const std::string& array, vtkNexradTransferFunction* transferFunction);

/// The lines that were passed over in the options' files of colours and opacities, each once.
std::vector<std::string> LinesPassedOver(const SceneOptions& options);

/// A property for volumes whose colours and opacities come from a transferFunction; the opacities
/// are those of OpacityUnitDistance until the scene sets another distance.
vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty();

} // namespace nexrad::scene
