// SPDX-License-Identifier: BSD-3-Clause
// What a mapper and a volume's property ask for, translated for the shaders.
#ifndef vtkTextureSliceRequest_h
#define vtkTextureSliceRequest_h

#include "vtkTextureSliceFeatures.h"
#include "vtkTextureSliceTables.h"
#include "vtkTextureSliceTexture.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkImageData;
class vtkPlane;
class vtkShaderProgram;
class vtkVolumeProperty;

/// How one component is coloured.
struct vtkTextureSliceSurface
{
  float InverseUnitDistance = 1.0f; ///< one over the data length that its opacity stands for
  float Weight = 1.0f;
  /// How much of a light it returns: vtkVolumeProperty's ambient, diffuse, specular and specular
  /// power.
  std::array<float, 4> Material{};
};

struct vtkTextureSliceRequest
{
  vtkVolumeProperty* Property = nullptr;
  int BlendMode = 0;  ///< vtkVolumeMapper::BlendModes
  int Components = 0; ///< 0: not known yet, before the source has run
  int ScalarType = VTK_FLOAT;
  /// The scalars that an average counts.
  std::array<double, 2> AverageRange{0.0, 1.0};
  /// Whether the functions' own ranges clamp the scalar (vtkGPUVolumeRayCastMapper::NATIVE).
  bool NativeColor = false;
  bool NativeOpacity = false;
  bool NativeGradientOpacity = false;
  bool PreIntegration = false;
  /// The contours of the first component at which rays begin (UseDepthPass); none: where they
  /// enter the volume.
  std::vector<double> Contours;
  bool BinaryMask = false; ///< there is a mask, and it says what is seen
  bool SmoothGradient = false;
  /// Components of the array that two-dimensional functions have in place of the gradient
  /// magnitude. 0: none is named; -1: the volume does not have it.
  int SecondArray = 0;
  bool LabelMap = false; ///< there is a mask, and it says which functions hold

  /// One line that says what cannot be drawn and what could, nullptr if everything can. The
  /// property may be nullptr. Nothing is said of components that are not known.
  const char* FindUnsupported() const;
  /// The same for what only the scalars' ranges tell.
  const char* FindUnsupportedRange(const std::vector<vtkTextureSliceComponent>& components) const;
  /// The values of the isosurfaces, ascending; none in other blend modes.
  std::vector<double> GetIsoValues() const;
  /// The same, 0 to 1 as the scalars are.
  std::vector<float> FindIsoValues(const std::vector<vtkTextureSliceComponent>& components) const;
  /// The plane that slice blending shows; nullptr in other blend modes.
  vtkPlane* GetSlicePlane() const;
  /// Whether nothing is to be seen: isosurfaces without values.
  bool IsEmpty() const;
  /// Whether scalars are not interpolated.
  bool IsNearest() const;
  /// Whether each component has its own functions.
  bool IsIndependent() const;
  /// Whether the blend mode shows places, not projected scalars.
  bool ShowsPlaces() const;
  /// Whether samples are lit: only where places are shown.
  bool IsShaded() const;
  /// What these ask of the shaders; what the frame and the texture add is left out.
  vtkTextureSliceFeatures GetFeatures() const;
  std::vector<vtkTextureSliceRow> MakeRows(
    const std::vector<vtkTextureSliceComponent>& components) const;
  /// For the table of labels: from label 1 on.
  std::vector<vtkTextureSliceRow> MakeLabelRows(
    const std::vector<vtkTextureSliceComponent>& components) const;
  /// One for each set of functions.
  std::vector<vtkImageData*> MakeTables2D() const;
  /// Whether two-dimensional functions read a second array.
  bool ReadsSecondArray() const { return this->Has2D() && this->SecondArray > 0; }

  /// Sets what follows from the request and the scalars: how texels become 0 to 1, average range,
  /// iso-values.
  void SetUniforms(
    const std::vector<vtkTextureSliceComponent>& components, vtkShaderProgram* program) const;
  /// The same for the components of the second array.
  static void SetSecondArray(
    const std::vector<vtkTextureSliceComponent>& components, vtkShaderProgram* program);
  /// One for each component.
  std::vector<vtkTextureSliceSurface> MakeSurfaces() const;

private:
  const char* FindUnsupportedSecondArray() const;
  /// Whether slabs are integrated over: where samples are blended by one-dimensional functions of
  /// scalars that are interpolated.
  bool IntegratesSlabs() const;
  /// Whether a gradient opacity is other than 1 somewhere: VTK's fixed-point ray caster gives
  /// properties one that is not.
  bool HasGradientOpacity() const;
  bool Has2D() const;
  int CountLabels() const;
  vtkTextureSliceRow MakeRow(int functions, const vtkTextureSliceComponent& color,
    const vtkTextureSliceComponent& opacity) const;
};

#endif
