// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/Framing.h"

#include <optional>
#include <vector>

namespace nexrad::scene
{

/// A side for each label, in their order: the first on which it lies within the picture, over no
/// box that is taken, over no label before it and over no point of another label; where there is
/// none, that which covers the least. Nothing for an optional label that would cover any or come
/// nearer than its gap, whose dot would, that would come nearer than its room to another one with
/// room, or that would not lie wholly over the ground, whose corners are given one after the other.
std::vector<std::optional<LabelSide>> ChooseSides(const std::vector<Label>& labels,
  const std::array<ScenePoint, 4>& ground, const Projection& project, TextPictures& pictures,
  std::vector<PixelBox> taken);

} // namespace nexrad::scene
