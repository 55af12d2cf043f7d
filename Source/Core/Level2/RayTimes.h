// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/MomentChecks.h"
#include "nexrad/Model/RadarVolume.h"

namespace nexrad
{

/// Finds rays whose date or time of day is wrong, reports them, and gives them the time of the ray
/// before them (at the start: of the ray after). One wrong date would stretch a series over years.
///
/// Times that lie within an hour of each other form a group. The group of most rays is right (of
/// two alike the one nearest to the header's time). Others are right when they have thirty rays or
/// more within a day of it: files of several volumes may have gaps.
void MendRayTimes(RadarVolume& volume, const RayDamageReceiver& report);

} // namespace nexrad
