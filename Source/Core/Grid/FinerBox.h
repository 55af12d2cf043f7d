// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Time.h"

#include <array>
#include <optional>

namespace nexrad
{

/// A box of a domain that is to be merged in voxels of another size.
struct BoxRequest
{
  std::array<double, 4> faces = {0.0, 0.0, 0.0, 0.0}; ///< west, east, south, north: x and y of the
                                                      ///< domain, m or degrees
  double spacing = 250.0;                             ///< m, side of a voxel; above 0
  int mostVoxels = 240; ///< along x and along y, from 1 on; a wider box that is merged has larger
                        ///< voxels
  std::optional<Time> followedFrom =
    std::nullopt; ///< when the box has these faces: before and after, it moves
                  ///< with the echo in it. Empty: it stays
};

bool operator==(const BoxRequest& a, const BoxRequest& b);

/// All of a domain in at most 128 × 128 columns of voxels that are at least 312.5 m high, and no
/// finer than its own: where echo is, is found in them at an eighth of the work of the usual grid.
BoxRequest CoarseDomain(const GridSpecification& domain);

/// A grid that reaches over a domain, and the block of it that is the box. Boxes of one domain with
/// voxels of one size have one grid: the faces are moved by half a voxel at most. The box is as
/// high as the domain.
struct FinerBox
{
  GridSpecification grid;
  VoxelBlock block;
};

/// The part of the box that lies in the domain, moved along x and y by `moved` (in the domain's
/// units), but not out of the domain. Its size and its voxels do not depend on where it has moved.
/// Throws Error when no part of the box lies in the domain, and for a spacing or a number of voxels
/// out of their ranges.
FinerBox MakeFinerBox(const GridSpecification& domain, const BoxRequest& request,
  const std::array<double, 2>& moved = {0.0, 0.0});

/// The voxels of a grid over the domain that the part of the box in it covers by half; two or more
/// along x and y, where the grid has them. Throws Error when no part of the box lies in the domain.
VoxelBlock VoxelsOfBox(const GridSpecification& grid, const BoxRequest& request);

/// Whether the voxels of a grid are at most half as wide as those that the box asks for.
bool IsFinerThanAsked(const GridSpecification& grid, const BoxRequest& request);

/// How far a box can move along x and y within the domain: towards west, east, south and north, in
/// the domain's units; west and south are 0 or less.
std::array<double, 4> RoomToMove(const GridSpecification& domain, const BoxRequest& request);

} // namespace nexrad
