// SPDX-License-Identifier: BSD-3-Clause
// What a mapper and a volume's property ask for, and what the shaders must be able to do for it.
#ifndef vtkTextureSliceRequest_h
#define vtkTextureSliceRequest_h

#include "vtkTextureSliceTables.h"
#include "vtkTextureSliceTexture.h"
#include "vtkType.h"
#include "vtkVolumeProperty.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkOpenGLTextureSliceVolumeMapper;
class vtkPlane;
class vtkShaderProgram;

/// Each combination is a shader program of its own, which compiles only what it needs.
struct vtkTextureSliceFeatures
{
  int BlendMode = 0; ///< vtkVolumeMapper::BlendModes
  int Components = 1;
  /// Sets of transfer functions: 1, or the number of components if each has its own.
  int Functions = 1;
  bool Masked = false;      ///< the volume's last component is its mask
  bool Paged = false;       ///< the volume's texture is an atlas of pages
  bool Blanked = false;     ///< there are cells, or points, whose ghost flags hide samples
  bool Rectilinear = false; ///< the distances of the points differ
  bool Cropped = false;     ///< samples must be tested against the cropping regions
  bool Parallel = false;
  bool GradientOpacity = false;
  bool SmoothGradient = false;
  bool ClippedScalars = false; ///< gradients take one scalar for what is clipped away
  bool Table2D = false;        ///< functions over scalar and gradient magnitude, or a second array
  int SecondArray = 0;         ///< components of the second array; 0: there is none
  bool SecondMasked = false;
  bool BinaryMask = false; ///< samples outside of the mask are left out
  int Labels = 0;          ///< labels that have functions of their own
  bool Selection = false;  ///< what is seen gets the one colour that a hardware selection asks for
  bool Shadows = false;    ///< the light volume says how much light arrives
  int Lights = -1;         ///< -1: unlit; 0: a single headlight; else the number of lights
  int IsoValues = 0;
  int Contours = 0; ///< rays begin at the first contour of these values; 0: where they enter
  /// Several slabs are faster together, but rays that end in the first one pay for all of them.
  static constexpr int SlabsOfPiece = 3;
  bool Slabs = false;         ///< the functions are integrated over slabs (Formulas L1)
  bool ExtremeSample = false; ///< components are those of the sample with the last one's extreme
  int ClippingPlanes = 0;
  bool Skipping = false; ///< rays leap over empty bricks
  bool Places = false;   ///< the picture is of the first places that are seen, not of colours
  int Peel = 0;          ///< vtkTextureSlicePeeling::Stage

  /// Rows of functions in the transfer table: the sets, then those of the labels.
  int CountFunctions() const { return this->Functions + this->Labels; }
  /// All its rows: functions, then their gradient opacities.
  int CountRows() const { return this->CountFunctions() * (this->GradientOpacity ? 2 : 1); }
  bool NeedsGradient() const
  {
    return this->GradientOpacity || (this->Table2D && this->SecondArray == 0) ||
           this->Lights >= 0 || (this->Shadows && this->IsoValues > 0);
  }
  /// Whether the shader reads the depth of the opaque geometry; peeling has depths of its own.
  bool NeedsDepth() const { return this->Peel == 0; }
  bool HasMask() const { return this->BinaryMask || this->Labels > 0; }
  /// Whether shadow and occlusion darken colours alike: without shading and surfaces.
  bool HasJoinedLight() const { return this->Lights < 0 && this->IsoValues == 0; }
  /// The first lines of the fragment shaders.
  std::string GetDefines() const;
};

struct vtkTextureSliceRequest
{
  vtkOpenGLTextureSliceVolumeMapper* Mapper = nullptr;
  vtkVolumeProperty* Property = nullptr;
  int BlendMode = 0;  ///< vtkVolumeMapper::BlendModes
  int Components = 0; ///< 0: not known yet, before the source has run
  int ScalarType = VTK_FLOAT;
  /// Whether two-dimensional functions name an array in place of the gradient magnitude, and that
  /// array; nullptr: the volume does not have it.
  bool NamesSecondArray = false;
  vtkDataArray* SecondArray = nullptr;

  /// One line that says what cannot be drawn and what could, nullptr if everything can. The
  /// property may be nullptr. Nothing is said of components that are not known.
  const char* FindUnsupported() const;
  /// The contours of the first component at which rays begin (UseDepthPass); none: where they
  /// enter the volume.
  std::vector<double> GetContours() const;
  /// The values of the isosurfaces, ascending; none in other blend modes.
  std::vector<double> GetIsoValues() const;
  /// The same, 0 to 1 as the scalars are.
  std::vector<float> FindIsoValues(const std::vector<vtkTextureSliceComponent>& components) const;
  /// The plane that slice blending shows; nullptr in other blend modes.
  vtkPlane* GetSlicePlane() const;
  bool IsNearest() const
  {
    return this->Property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  }
  /// Whether each component has its own functions.
  bool IsIndependent() const { return this->Property->GetIndependentComponents() != 0; }
  /// Whether the blend mode shows places, not projected scalars.
  bool ShowsPlaces() const;
  /// Whether samples are lit: only where places are shown.
  bool IsShaded() const { return this->ShowsPlaces() && this->Property->GetShade(0) != 0; }
  /// What these ask of the shaders; what the frame and the texture add is left out.
  vtkTextureSliceFeatures GetFeatures() const;
  std::vector<vtkTextureSliceRow> MakeRows(
    const std::vector<vtkTextureSliceComponent>& components) const;
  /// One for each set of functions.
  std::vector<vtkImageData*> MakeTables2D() const;
  bool ReadsSecondArray() const { return this->Has2D() && this->SecondArray != nullptr; }
  /// Texture memory for the volume's scalars beyond which they are stored in pages.
  std::size_t CountMostBytes() const;

  /// The functions of a component: its own, or the first ones.
  int GetFunctions(int component) const { return this->IsIndependent() ? component : 0; }
  /// The data length that a component's opacity stands for.
  double GetUnitDistance(int component) const
  {
    return this->Property->GetScalarOpacityUnitDistance(this->GetFunctions(component));
  }
  double GetWeight(int component) const;

  /// Sets what follows from the request and the scalars: how texels become 0 to 1, average range,
  /// iso-values, and how components are coloured.
  /// @param second components of the second array
  void SetUniforms(const std::vector<vtkTextureSliceComponent>& components,
    const std::vector<vtkTextureSliceComponent>& second, vtkShaderProgram* program) const;

private:
  void SetMaterials(vtkShaderProgram* program) const;
  bool HasMask(int type) const;
  /// Whether a gradient opacity is other than 1 somewhere.
  bool HasGradientOpacity() const;
  bool Has2D() const
  {
    return this->Property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
  }
  int CountLabels() const;
  /// Label 0: the functions of a set.
  vtkTextureSliceRow MakeRow(int functions, int label, const vtkTextureSliceComponent& color,
    const vtkTextureSliceComponent& opacity) const;
};

#endif
