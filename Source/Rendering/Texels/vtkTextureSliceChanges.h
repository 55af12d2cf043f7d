// SPDX-License-Identifier: BSD-3-Clause
// What of a texture has to be uploaded.
#ifndef vtkTextureSliceChanges_h
#define vtkTextureSliceChanges_h

#include "vtkTextureSliceBlocks.h"
#include "vtkTextureSliceTexels.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

/// Boxes of a texture and their texels, which take as much memory as they do in the texture.
class vtkTextureSliceChanges
{
public:
  using Box = vtkTextureSliceBlocks::Box;

  /// Encodes the texels of the boxes, on several threads.
  void Build(const vtkTextureSliceScalars& source, const vtkTextureSliceTexels& texels,
    const std::vector<Box>& boxes);

  /// Hands each box with its texels to a function, in their order.
  void ForEach(const std::function<void(const Box& box, const unsigned char* texels)>& take) const;

private:
  std::vector<Box> Boxes;
  std::vector<std::size_t> Begins; ///< of each box in Data
  /// Not set to 0 first: the threads that encode are the first to touch it.
  std::unique_ptr<unsigned char[]> Data;
};

#endif
