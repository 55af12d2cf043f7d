// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoInterest.h"

#include <algorithm>

namespace nexrad
{

namespace
{

// A weighted mean of what is known.
class Mean
{
public:
  void Add(float weight, float interest)
  {
    sum += weight * interest;
    weights += weight;
  }
  float Value() const { return weights > 0.0F ? sum / weights : 0.0F; }

private:
  float sum = 0.0F;
  float weights = 0.0F;
};

void AddTextures(const GateEvidence& evidence, Mean& mean)
{
  if (IsNumber(evidence.squares))
  {
    mean.Add(1.0F, Ramp(evidence.squares, 0.0F, 45.0F));
  }
  if (IsNumber(evidence.agreement))
  {
    mean.Add(0.5F, Ramp(evidence.agreement, 0.8F, 0.3F));
  }
}

void AddVelocities(const GateEvidence& evidence, Mean& mean)
{
  if (IsNumber(evidence.still))
  {
    mean.Add(1.0F, evidence.still);
    mean.Add(0.5F, Ramp(evidence.speed, 2.3F, 0.5F));
    mean.Add(0.5F, Ramp(evidence.width, 3.2F, 0.5F));
  }
  if (IsNumber(evidence.ownStill))
  {
    mean.Add(1.0F, evidence.ownStill);
  }
}

float NotWeather(const GateEvidence& evidence)
{
  Mean mean;
  mean.Add(1.0F, Ramp(evidence.correlation, 0.95F, 0.80F));
  mean.Add(1.0F, std::max(Ramp(evidence.ratio, 3.0F, 6.0F), Ramp(evidence.ratio, -2.0F, -4.0F)));
  if (IsNumber(evidence.ratioSpread))
  {
    mean.Add(1.0F, Ramp(evidence.ratioSpread, 1.0F, 2.5F));
    mean.Add(1.0F, Ramp(evidence.phaseSpread, 12.0F, 30.0F));
  }
  if (IsNumber(evidence.squares))
  {
    mean.Add(0.25F, Ramp(evidence.squares, 30.0F, 70.0F));
    mean.Add(0.25F, Ramp(evidence.turns, 0.3F, 0.6F));
  }
  return mean.Value();
}

} // namespace

EchoInterest InterestOf(const GateEvidence& evidence)
{
  EchoInterest interest;
  Mean mean;
  AddTextures(evidence, mean);
  AddVelocities(evidence, mean);
  const float single = mean.Value();
  interest.polarimetric = IsNumber(evidence.correlation);
  if (!interest.polarimetric)
  {
    interest.ground = single;
    return interest;
  }
  const float notWeather = NotWeather(evidence);
  interest.ground = 0.5F * (notWeather + single);
  interest.flight = notWeather;
  return interest;
}

} // namespace nexrad
