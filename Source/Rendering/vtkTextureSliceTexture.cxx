// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace
{

/// Texels as they go to OpenGL.
struct Texels
{
  int ScalarType = VTK_FLOAT; ///< VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT or VTK_FLOAT
  const void* Data = nullptr; ///< the scalars themselves, or Storage
  std::vector<unsigned char> Storage;
};

/// The scalars of a volume, component after component of each point (or cell).
template <typename Scalar>
struct Tuples
{
  const Scalar* Data = nullptr;
  std::size_t Count = 0;
  std::size_t Components = 1;
};

/// 1 at visible places, 0 at hidden ones; empty if all are visible.
template <typename Scalar>
std::vector<std::uint8_t> MakeMask(
  const Tuples<Scalar>& tuples, vtkUnsignedCharArray* ghosts, unsigned char hiddenBit)
{
  std::vector<std::uint8_t> mask;
  const auto hide = [&](std::size_t i)
  {
    if (mask.empty())
    {
      mask.assign(tuples.Count, 1);
    }
    mask[i] = 0;
  };
  if (ghosts != nullptr)
  {
    const unsigned char* flags = ghosts->GetPointer(0);
    for (std::size_t i = 0; i < tuples.Count; ++i)
    {
      if ((flags[i] & hiddenBit) != 0)
      {
        hide(i);
      }
    }
  }
  if constexpr (std::is_floating_point_v<Scalar>)
  {
    for (std::size_t i = 0; i < tuples.Count * tuples.Components; ++i)
    {
      if (!std::isfinite(tuples.Data[i]))
      {
        hide(i / tuples.Components);
      }
    }
  }
  return mask;
}

/// Scalars to texels by convert(scalar, component), each tuple followed by its visibility if there
/// is a mask.
template <typename Texel, typename Scalar, typename Convert>
void Encode(const Tuples<Scalar>& tuples, const std::vector<std::uint8_t>& mask, Convert convert,
  Texels& texels)
{
  // What OpenGL reads as 1.
  constexpr Texel visible =
    std::is_floating_point_v<Texel> ? Texel{1} : std::numeric_limits<Texel>::max();
  const std::size_t channels = tuples.Components + (mask.empty() ? 0 : 1);
  texels.Storage.resize(tuples.Count * channels * sizeof(Texel));
  texels.Data = texels.Storage.data();
  auto* out = reinterpret_cast<Texel*>(texels.Storage.data());
  const Scalar* in = tuples.Data;
  for (std::size_t i = 0; i < tuples.Count; ++i)
  {
    const bool isVisible = mask.empty() || mask[i] != 0;
    for (std::size_t c = 0; c < tuples.Components; ++c)
    {
      const Scalar scalar = *in++;
      *out++ = isVisible ? convert(scalar, c) : Texel{0};
    }
    if (!mask.empty())
    {
      *out++ = isVisible ? visible : Texel{0};
    }
  }
}

/// Texels of scalars whose type is theirs already; copied only to stand beside a mask.
template <typename Scalar>
void EncodeSame(const Tuples<Scalar>& tuples, const std::vector<std::uint8_t>& mask, Texels& texels)
{
  texels.Data = tuples.Data;
  if (!mask.empty())
  {
    Encode<Scalar>(
      tuples, mask, [](Scalar s, std::size_t) { return s; }, texels);
  }
}

/// Integers of 8 and 16 bits: what is stored is the distance from the type's least value.
template <typename Scalar>
void EncodeShort(const Tuples<Scalar>& tuples, const std::vector<std::uint8_t>& mask,
  std::vector<vtkTextureSliceComponent>& components, Texels& texels)
{
  using Texel = std::conditional_t<sizeof(Scalar) == 1, std::uint8_t, std::uint16_t>;
  constexpr int lowest = std::numeric_limits<Scalar>::lowest();
  texels.ScalarType = sizeof(Scalar) == 1 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT;
  for (vtkTextureSliceComponent& component : components)
  {
    component.Scale = std::numeric_limits<Texel>::max();
    component.Bias = lowest;
  }
  if constexpr (lowest == 0)
  {
    EncodeSame(tuples, mask, texels);
  }
  else
  {
    Encode<Texel>(
      tuples, mask, [](Scalar s, std::size_t) { return static_cast<Texel>(s - lowest); }, texels);
  }
}

/// Types that a float cannot hold: each component's range is spread over 0 to 1.
template <typename Scalar>
void EncodeWide(const Tuples<Scalar>& tuples, const std::vector<std::uint8_t>& mask,
  std::vector<vtkTextureSliceComponent>& components, Texels& texels)
{
  for (vtkTextureSliceComponent& component : components)
  {
    const auto [low, high] = component.Range;
    component.Scale = high > low ? high - low : 1.0;
    component.Bias = low;
  }
  const auto convert = [&components](Scalar s, std::size_t c) {
    return static_cast<float>((static_cast<double>(s) - components[c].Bias) / components[c].Scale);
  };
  Encode<float>(tuples, mask, convert, texels);
}

/// @param components their ranges are given, how texels become scalars is set.
template <typename Scalar>
Texels MakeTexels(const Tuples<Scalar>& tuples, const std::vector<std::uint8_t>& mask,
  std::vector<vtkTextureSliceComponent>& components)
{
  Texels texels;
  if constexpr (std::is_integral_v<Scalar> && sizeof(Scalar) <= 2)
  {
    EncodeShort(tuples, mask, components, texels);
  }
  else if constexpr (std::is_same_v<Scalar, float>)
  {
    EncodeSame(tuples, mask, texels);
  }
  else
  {
    EncodeWide(tuples, mask, components, texels);
  }
  return texels;
}

template <typename Scalar>
Texels MakeTexels(const Scalar* scalars, std::size_t count, vtkUnsignedCharArray* ghosts,
  unsigned char hiddenBit, std::vector<vtkTextureSliceComponent>& components, bool& masked)
{
  const Tuples<Scalar> tuples{scalars, count, components.size()};
  const auto mask = MakeMask(tuples, ghosts, hiddenBit);
  masked = !mask.empty();
  return MakeTexels(tuples, mask, components);
}

/// The format of a texture of 1 to 4 components.
unsigned int InternalFormat(int scalarType, int channels)
{
  constexpr std::array<unsigned int, 4> bytes{GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
  constexpr std::array<unsigned int, 4> shorts{GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
  constexpr std::array<unsigned int, 4> floats{GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
  const auto index = static_cast<std::size_t>(channels - 1);
  switch (scalarType)
  {
  case VTK_UNSIGNED_CHAR:
    return bytes[index];
  case VTK_UNSIGNED_SHORT:
    return shorts[index];
  default:
    return floats[index];
  }
}

/// The format of the texels that are handed over.
unsigned int TexelFormat(int channels)
{
  constexpr std::array<unsigned int, 4> formats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return formats[static_cast<std::size_t>(channels - 1)];
}

unsigned int TexelType(int scalarType)
{
  switch (scalarType)
  {
  case VTK_UNSIGNED_CHAR:
    return GL_UNSIGNED_BYTE;
  case VTK_UNSIGNED_SHORT:
    return GL_UNSIGNED_SHORT;
  default:
    return GL_FLOAT;
  }
}

/// The ghost array; nullptr if there is none of one flag for each texel.
vtkUnsignedCharArray* FindGhosts(vtkImageData* image, bool cellData)
{
  vtkDataSetAttributes* attributes =
    cellData ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const vtkIdType texels = cellData ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  return ghosts != nullptr && ghosts->GetNumberOfTuples() == texels ? ghosts : nullptr;
}

} // namespace

std::array<int, 3> vtkTextureSliceTexture::GetSize(vtkImageData* image, bool cellData)
{
  std::array<int, 3> size;
  image->GetDimensions(size.data());
  for (int& texels : size)
  {
    texels -= cellData ? 1 : 0;
  }
  return size;
}

vtkTextureSliceTexture::Source vtkTextureSliceTexture::MakeSource(
  vtkImageData* image, vtkDataArray* scalars, bool cellData)
{
  vtkUnsignedCharArray* ghosts = FindGhosts(image, cellData);
  Source source;
  source.Scalars = scalars;
  source.ScalarsTime = scalars->GetMTime();
  source.Ghosts = ghosts;
  source.GhostsTime = ghosts != nullptr ? ghosts->GetMTime() : 0;
  source.Size = GetSize(image, cellData);
  return source;
}

bool vtkTextureSliceTexture::Update(vtkOpenGLRenderWindow* window, vtkImageData* image,
  vtkDataArray* scalars, bool cellData, std::string& error)
{
  const Source source = MakeSource(image, scalars, cellData);
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window &&
      source == this->Last)
  {
    return true;
  }
  this->Last = Source(); // nothing, should an error leave the texture half made
  const auto [nx, ny, nz] = source.Size;
  const auto expected = static_cast<vtkIdType>(nx) * ny * nz;
  if (scalars->GetNumberOfTuples() != expected)
  {
    error = "the scalars have " + std::to_string(scalars->GetNumberOfTuples()) +
            " values, the image needs " + std::to_string(expected);
    return false;
  }

  this->Components.assign(static_cast<std::size_t>(scalars->GetNumberOfComponents()), {});
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    scalars->GetFiniteRange(this->Components[c].Range.data(), static_cast<int>(c));
  }
  unsigned char hidden = vtkDataSetAttributes::HIDDENPOINT;
  if (cellData)
  {
    hidden = vtkDataSetAttributes::HIDDENCELL;
  }
  Texels texels;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(texels = MakeTexels(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)),
                       static_cast<std::size_t>(expected), FindGhosts(image, cellData), hidden,
                       this->Components, this->Masked));
  default:
    error = std::string("scalars of type ") + scalars->GetDataTypeAsString() +
            " cannot be drawn: convert them to a number type";
    return false;
  }
  if (this->CountChannels() > 4)
  {
    error = "four components with hidden points, or with scalars that are not finite, are not "
            "supported: leave out a component or the ghost array";
    return false;
  }
  if (!this->Allocate(window, source.Size, texels.ScalarType, error))
  {
    return false;
  }
  this->Texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, nx, ny, nz, TexelFormat(this->CountChannels()),
    TexelType(texels.ScalarType), texels.Data);
  this->Texture->Deactivate();
  this->Bricks.Build({scalars, source.Size, cellData, FindGhosts(image, cellData), hidden});
  this->Last = source;
  return true;
}

int vtkTextureSliceTexture::CountChannels() const
{
  return static_cast<int>(this->Components.size()) + (this->Masked ? 1 : 0);
}

bool vtkTextureSliceTexture::Allocate(
  vtkOpenGLRenderWindow* window, const std::array<int, 3>& size, int scalarType, std::string& error)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(size.begin(), size.end()) > limit)
  {
    error = "the volume has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
            std::to_string(size[2]) + " voxels, this OpenGL takes at most " +
            std::to_string(limit) + " along an axis: resample it to " +
            std::to_string(std::min(size[0], limit)) + " x " +
            std::to_string(std::min(size[1], limit)) + " x " +
            std::to_string(std::min(size[2], limit)) + " or less";
    return false;
  }
  const int channels = this->CountChannels();
  const std::array<int, 5> wanted{size[0], size[1], size[2], scalarType, channels};
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window &&
      wanted == this->Allocated)
  {
    return true;
  }
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(InternalFormat(scalarType, channels));
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  if (!this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), channels,
        scalarType, nullptr))
  {
    error = "OpenGL could not make a texture of " + std::to_string(size[0]) + " x " +
            std::to_string(size[1]) + " x " + std::to_string(size[2]) + " voxels";
    return false;
  }
  this->Allocated = wanted;
  return true;
}

void vtkTextureSliceTexture::SetNearest(bool nearest)
{
  const int filter = nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  this->Texture->SetMagnificationFilter(filter);
  this->Texture->SetMinificationFilter(filter);
}

void vtkTextureSliceTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
