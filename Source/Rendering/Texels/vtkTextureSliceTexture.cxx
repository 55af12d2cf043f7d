// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace
{

/// Mesa's software renderer interpolates bytes in eight bits, and shorts as floats. Codes need
/// that: their values are a byte's steps apart, and what lies between two of them is drawn as such.
bool IsLlvmpipe()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer != nullptr && std::strstr(renderer, "llvmpipe") != nullptr;
}

/// Takes the errors that OpenGL keeps of calls before, one of each kind.
void ForgetErrors()
{
  constexpr int kinds = 8; // without a context there is no end of them
  for (int i = 0; i < kinds && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

std::string ToText(const std::array<int, 3>& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
         std::to_string(size[2]);
}

/// Whether scalars of that number and type can become a texture.
bool Check(const vtkTextureSliceScalars& source, std::string& error)
{
  const auto [nx, ny, nz] = source.Size;
  const auto expected = static_cast<vtkIdType>(nx) * ny * nz;
  if (source.Scalars->GetNumberOfTuples() != expected)
  {
    error = "the scalars have " + std::to_string(source.Scalars->GetNumberOfTuples()) +
            " values, the image needs " + std::to_string(expected);
    return false;
  }
  bool isNumber = false;
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(isNumber = std::is_arithmetic_v<VTK_TT>);
  }
  if (!isNumber)
  {
    error = std::string("scalars of type ") + source.Scalars->GetDataTypeAsString() +
            " cannot be drawn: convert them to a number type";
  }
  return isNumber;
}

} // namespace

vtkStandardNewMacro(vtkTextureSliceChecksums);
vtkInformationKeyMacro(vtkTextureSliceChecksums, PREPARED, ObjectBase);

vtkTextureSliceChecksums::Key vtkTextureSliceChecksums::MakeKey(
  const vtkTextureSliceScalars& source)
{
  return {source.Scalars, source.Scalars->GetMTime(), source.Ghosts,
    source.Ghosts != nullptr ? source.Ghosts->GetMTime() : 0, source.Size, source.CellData,
    source.Codes, source.Places};
}

void vtkTextureSliceChecksums::Build(const vtkTextureSliceScalars& source)
{
  this->Made = MakeKey(source);
  this->Bricks.Build(source);
  this->Texels = {source, this->Bricks};
  this->Blocks.Build(source);
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Prepare(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  // The array makes its information when it is first asked, and counts as changed by that.
  vtkInformation* information = source.Scalars->GetInformation();
  auto checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
  checksum->Build(source);
  if (before != nullptr)
  {
    checksum->Prepared = checksum->TakeChanges(source, before);
    checksum->PreparedOver = before->Made;
  }
  information->Set(PREPARED(), checksum);
  return checksum;
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Get(
  const vtkTextureSliceScalars& source)
{
  vtkSmartPointer<vtkTextureSliceChecksums> checksum;
  if (source.Scalars->HasInformation())
  {
    checksum =
      vtkTextureSliceChecksums::SafeDownCast(source.Scalars->GetInformation()->Get(PREPARED()));
  }
  if (checksum == nullptr || checksum->Made != MakeKey(source))
  {
    checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
    checksum->Build(source);
  }
  return checksum;
}

vtkTextureSliceChanges vtkTextureSliceChecksums::TakeChanges(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  auto prepared = std::exchange(this->Prepared, std::nullopt);
  if (prepared && before != nullptr && before->Made == this->PreparedOver)
  {
    return std::move(*prepared);
  }
  const bool comparable = before != nullptr && this->Texels.IsLike(before->Texels);
  return this->Texels.Encode(
    source, this->Blocks.FindChanges(comparable ? &before->Blocks : nullptr));
}

bool vtkTextureSliceTexture::Update(vtkOpenGLRenderWindow* window,
  const vtkTextureSliceScalars& source, bool nearest, std::string& error)
{
  vtkTextureSliceSetSampling(this->Texture, nearest);
  const vtkTextureSliceChecksums::Key key = vtkTextureSliceChecksums::MakeKey(source);
  const bool there = this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window;
  if (there && this->Checksum != nullptr && key == this->Last)
  {
    return true;
  }
  // Nothing is known of the texture, should an error leave it half made.
  const auto before = std::exchange(this->Checksum, nullptr);
  if (!Check(source, error))
  {
    return false;
  }
  const auto checksum = vtkTextureSliceChecksums::Get(source);
  this->Texels = checksum->GetTexels();
  if (this->Texels.CountChannels() > 4)
  {
    error = "four components with hidden points, or with scalars that are not finite, are not "
            "supported: leave out a component or the ghost array";
    return false;
  }
  const auto allocated = this->Allocated;
  if (!this->Allocate(window, source.Size, error))
  {
    return false;
  }
  const bool kept = there && allocated == this->Allocated;
  this->Upload(window, checksum->TakeChanges(source, kept ? before : nullptr));
  this->Checksum = checksum;
  this->Last = key;
  return true;
}

void vtkTextureSliceTexture::Upload(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceChanges& changes)
{
  const int scalarType = this->Texels.GetScalarType();
  const unsigned int format =
    this->Texture->GetDefaultFormat(scalarType, this->Texels.CountChannels(), false);
  const auto type = static_cast<unsigned int>(this->Texture->GetDefaultDataType(scalarType));
  this->Texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t i = 0; i < changes.Boxes.size(); ++i)
  {
    const auto& [begin, end] = changes.Boxes[i];
    glTexSubImage3D(GL_TEXTURE_3D, 0, begin[0], begin[1], begin[2], end[0] - begin[0],
      end[1] - begin[1], end[2] - begin[2], format, type, changes.Bytes.get() + changes.Begins[i]);
  }
  this->Texture->Deactivate();
}

bool vtkTextureSliceTexture::Allocate(
  vtkOpenGLRenderWindow* window, const std::array<int, 3>& size, std::string& error)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(size.begin(), size.end()) > limit)
  {
    error = "the volume has " + ToText(size) + " voxels, this OpenGL takes at most " +
            std::to_string(limit) + " along an axis: resample it to " +
            ToText({std::min(size[0], limit), std::min(size[1], limit), std::min(size[2], limit)}) +
            " or less (nexrad3d grid --dims)";
    return false;
  }
  const int channels = this->Texels.CountChannels();
  const int scalarType = this->Texels.GetScalarType();
  this->Texture->SetContext(window);
  const bool wide = this->Texels.AreCodeBytes() && IsLlvmpipe();
  const unsigned int format = this->Texture->GetDefaultInternalFormat(
    wide ? VTK_UNSIGNED_SHORT : scalarType, channels, false);
  const std::array<int, 4> wanted{size[0], size[1], size[2], static_cast<int>(format)};
  if (this->Texture->GetHandle() != 0 && wanted == this->Allocated)
  {
    return true;
  }
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(format);
  ForgetErrors();
  const bool created = this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), channels, scalarType,
    nullptr);
  if (!created || glGetError() != GL_NO_ERROR)
  {
    error = "OpenGL could not make a texture of " + ToText(size) +
            " voxels: it may lack the memory; fewer voxels need less (nexrad3d grid --dims)";
    return false;
  }
  this->Allocated = wanted;
  return true;
}

bool vtkTextureSliceBlanks::Update(
  vtkOpenGLRenderWindow* window, vtkImageData* image, bool cellData, std::string& error)
{
  vtkUnsignedCharArray* flags = vtkTextureSliceScalars::FindGhosts(image, !cellData);
  this->Used = flags != nullptr && flags->GetRange()[1] > 0.0;
  if (!this->Used)
  {
    return true;
  }
  const auto size = vtkTextureSliceScalars::GetSize(image, !cellData);
  const auto texels = vtkTextureSliceScalars::GetSize(image, cellData);
  // Scalars of points: half a texel before the first cell. Scalars of cells: half a point after.
  const float offset = cellData ? 0.5f : -0.5f;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Scale[axis] = static_cast<float>(texels[axis]) / static_cast<float>(size[axis]);
    this->Bias[axis] = offset / static_cast<float>(size[axis]);
  }
  return this->Texture.Update(window, {flags, size}, true, error);
}

void vtkTextureSliceBlanks::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniform3f("blankScale", this->Scale.data());
  program->SetUniform3f("blankBias", this->Bias.data());
}
