// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexture.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace
{

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

/// Why scalars of that number or type cannot become a texture; or an empty text.
std::string FindUnsupported(const vtkTextureSliceScalars& source)
{
  const auto [nx, ny, nz] = source.Size;
  const auto expected = static_cast<vtkIdType>(nx) * ny * nz;
  if (source.Scalars->GetNumberOfTuples() != expected)
  {
    return "the scalars have " + std::to_string(source.Scalars->GetNumberOfTuples()) +
           " values, the image needs " + std::to_string(expected);
  }
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(if (std::is_arithmetic_v<VTK_TT>) { return ""; });
  }
  return std::string("scalars of type ") + source.Scalars->GetDataTypeAsString() +
         " cannot be drawn: convert them to a number type";
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

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Make(
  const vtkTextureSliceScalars& source)
{
  auto checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
  checksum->Made = MakeKey(source);
  checksum->Bricks.Build(source);
  checksum->Texels = {source, checksum->Bricks};
  checksum->Blocks.Build(source);
  return checksum;
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Prepare(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  // The array makes its information when it is first asked, and counts as changed by that.
  vtkInformation* information = source.Scalars->GetInformation();
  const auto checksum = Make(source);
  // Pages are chosen when it is known what OpenGL takes.
  const bool mayBePaged =
    checksum->Texels.CountBytes(source.Size) > vtkTextureSlicePages::UsualMemory;
  if (before != nullptr && !mayBePaged)
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
  return checksum != nullptr && checksum->Made == MakeKey(source) ? checksum : Make(source);
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

std::size_t vtkTextureSliceTexture::CountBytes() const
{
  return this->Texels.CountBytes({this->Allocated[0], this->Allocated[1], this->Allocated[2]});
}

bool vtkTextureSliceTexture::TryPages(vtkOpenGLRenderWindow* window,
  const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks, std::string& error)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  const bool beyond = *std::max_element(source.Size.begin(), source.Size.end()) > limit;
  const std::size_t bytes = this->Texels.CountBytes(source.Size);
  // The bricks of a rectilinear grid are parts of its box, not of its points.
  if (this->MostBytes == 0 || !source.Places.front().empty() ||
      (!beyond && bytes <= this->MostBytes))
  {
    return false;
  }
  const bool fits = this->Pages.Build(source.Size, bricks, limit);
  if (beyond && !fits)
  {
    error = "what differs among " + ToText(source.Size) +
            " voxels does not fit into a texture of this OpenGL: fewer voxels need less (nexrad3d "
            "grid --dims)";
  }
  constexpr double most = 0.75; // pages take longer to look up
  const auto ofPages = static_cast<double>(this->Texels.CountBytes(this->Pages.GetAtlasSize()));
  return fits && (beyond || ofPages < most * static_cast<double>(bytes));
}

std::string vtkTextureSliceTexture::Update(vtkOpenGLRenderWindow* window,
  const vtkTextureSliceScalars& source, bool nearest, std::size_t mostBytes)
{
  vtkTextureSliceSetSampling(this->Texture, nearest);
  const vtkTextureSliceChecksums::Key key = vtkTextureSliceChecksums::MakeKey(source);
  const bool there = this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window;
  if (there && this->Checksum != nullptr && key == this->Last && mostBytes == this->MostBytes)
  {
    return "";
  }
  this->MostBytes = mostBytes;
  // Nothing is known of the texture, should an error leave it half made.
  const auto before = std::exchange(this->Checksum, nullptr);
  std::string error = FindUnsupported(source);
  if (!error.empty())
  {
    return error;
  }
  const auto checksum = vtkTextureSliceChecksums::Get(source);
  this->Texels = checksum->Texels;
  if (this->Texels.CountChannels() > 4)
  {
    return "four components with hidden points, or with scalars that are not finite, are not "
           "supported: leave out a component or the ghost array";
  }
  const bool wasPaged = std::exchange(this->Paged, false);
  this->Paged = this->TryPages(window, source, checksum->Bricks, error);
  if (!error.empty())
  {
    return error;
  }
  const auto allocated = this->Allocated;
  error = this->Allocate(window, this->Paged ? this->Pages.GetAtlasSize() : source.Size);
  if (!error.empty())
  {
    return error;
  }
  const bool kept = there && !wasPaged && allocated == this->Allocated;
  this->Upload(window, this->Paged ? this->Texels.Encode(source, this->Pages.GetBoxes())
                                   : checksum->TakeChanges(source, kept ? before : nullptr));
  this->Checksum = checksum;
  this->Last = key;
  return "";
}

void vtkTextureSliceTexture::Upload(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceChanges& changes)
{
  if (this->Paged)
  {
    this->Pages.Upload(window);
  }
  const int scalarType = this->Texels.ScalarType;
  const unsigned int format =
    this->Texture->GetDefaultFormat(scalarType, this->Texels.CountChannels(), false);
  const auto type = static_cast<unsigned int>(this->Texture->GetDefaultDataType(scalarType));
  this->Texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t i = 0; i < changes.Boxes.size(); ++i)
  {
    const auto& [begin, end] = changes.Boxes[i];
    const std::array<int, 3>& place = this->Paged ? this->Pages.GetPlaces()[i] : begin;
    glTexSubImage3D(GL_TEXTURE_3D, 0, place[0], place[1], place[2], end[0] - begin[0],
      end[1] - begin[1], end[2] - begin[2], format, type, changes.Bytes.get() + changes.Begins[i]);
  }
  this->Texture->Deactivate();
}

std::string vtkTextureSliceTexture::Allocate(
  vtkOpenGLRenderWindow* window, const std::array<int, 3>& size)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(size.begin(), size.end()) > limit)
  {
    return "the volume has " + ToText(size) + " voxels, this OpenGL takes at most " +
           std::to_string(limit) + " along an axis: resample it to " +
           ToText({std::min(size[0], limit), std::min(size[1], limit), std::min(size[2], limit)}) +
           " or less (nexrad3d grid --dims)";
  }
  const int channels = this->Texels.CountChannels();
  const int scalarType = this->Texels.ScalarType;
  this->Texture->SetContext(window);
  // It interpolates bytes in eight bits, and shorts as floats. Codes need that: their values are a
  // byte's steps apart, and what lies between two of them is drawn as such.
  const bool wide = this->Texels.AreCodeBytes() && vtkTextureSliceIsLlvmpipe();
  const unsigned int format = this->Texture->GetDefaultInternalFormat(
    wide ? VTK_UNSIGNED_SHORT : scalarType, channels, false);
  const std::array<int, 4> wanted{size[0], size[1], size[2], static_cast<int>(format)};
  if (this->Texture->GetHandle() != 0 && wanted == this->Allocated)
  {
    return "";
  }
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(format);
  ForgetErrors();
  const bool created = this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), channels, scalarType,
    nullptr);
  if (!created || glGetError() != GL_NO_ERROR)
  {
    return "OpenGL could not make a texture of " + ToText(size) +
           " voxels: it may lack the memory; fewer voxels need less (nexrad3d grid --dims)";
  }
  this->Allocated = wanted;
  return "";
}
