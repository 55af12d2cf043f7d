// SPDX-License-Identifier: BSD-3-Clause
// The light volume of a mapper as the shader reads it.
#ifndef vtkTextureSliceShadows_h
#define vtkTextureSliceShadows_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceLightVolume.h"
#include "vtkType.h"

#include <array>
#include <optional>
#include <tuple>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkTextureSliceParts;

/// Keeps a vtkTextureSliceLightVolume up to date with scalars, transfer functions, mask, cuts and
/// directions of light, and in texture memory.
class vtkTextureSliceShadows
{
public:
  /// @param source all of it must be up to date: the mapper's settings, volume, functions, mask and
  /// cuts.
  /// @param interactive whether a change asks for a coarse volume.
  void Update(vtkTextureSliceParts& source, bool interactive);

  /// Whether the last Update was asked for shadow or occlusion, and the blend mode has them.
  bool IsUsed() const { return this->Used; }
  /// Brings the light into texture memory.
  /// @param joined whether what is left of a colour is one channel, which costs half to look up.
  void Upload(vtkOpenGLRenderWindow* window, bool joined);
  vtkTextureObject* GetTexture() const { return this->Texture; }
  void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceParts& uniforms) const;

  /// The volume in data coordinates, of two components; nullptr if not used.
  vtkImageData* GetImage() const { return this->Used ? this->Image.Get() : nullptr; }

private:
  /// All that the volume depends on but its resolution. Pointers hold while it is built alone.
  struct Key
  {
    std::array<vtkMTimeType, 2> Times{}; ///< of scalars and mask
    vtkTextureSliceLightCells::Source Cells;
    vtkTextureSliceLightVolume::Lights From;
  };

  void SetSurfaces(vtkShaderProgram* program, const vtkTextureSliceParts& uniforms) const;
  void MakeImage(vtkImageData* volume, bool cellData);

  bool Used = false;
  bool Coarse = false;
  Key Last;
  std::optional<vtkTextureSliceLightCells> Cells; ///< kept for other lights
  vtkTextureSliceLightVolume Volume;
  std::array<float, 2> Strength{};
  float Exposure = 1.0f;
  /// Of the texture: whether it is joined, exposure and strengths.
  std::tuple<bool, float, std::array<float, 2>> Uploaded{};
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkImageData> Image;
};

#endif
