// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/ValueRule.h"

namespace nexrad
{

ValueRule ValueRule::Of(MomentName moment, bool linearReflectivity)
{
  ValueRule rule;
  rule.nearest = IsRadialVelocity(moment);
  rule.zeroIsNone = moment == MomentName::REF;
  rule.linear = moment == MomentName::REF && linearReflectivity;
  rule.period = moment == MomentName::PHI ? 360.0F : 0.0F;
  return rule;
}

} // namespace nexrad
