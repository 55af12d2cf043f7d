// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoInterest.h"

#include <algorithm>

namespace nexrad
{

namespace
{

// The most interest in ground of a gate that is not known to stand still: less than it takes to be
// surely ground.
constexpr float mostUnknown = 0.58F;
constexpr float mostUnknownOfOnePolarisation = 0.56F;

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
    mean.Add(1.0F, Ramp(evidence.squares, 8.0F, 40.0F));
  }
  if (IsNumber(evidence.agreement))
  {
    mean.Add(0.5F, Ramp(evidence.agreement, 0.6F, 0.25F));
  }
}

// The vertical test. Side lobes see the ground about the radar at all tilts, and high tilts see it
// with side lobes alone.
void AddGradient(const GateEvidence& evidence, Mean& mean)
{
  if (IsNumber(evidence.gradient))
  {
    const float known =
      Ramp(evidence.range, 5'000.0F, 25'000.0F) * Ramp(evidence.elevation, 4.5F, 1.0F);
    mean.Add(known, Ramp(evidence.gradient, 3.0F, 15.0F));
  }
}

void AddVelocities(const GateEvidence& evidence, Mean& mean)
{
  if (IsNumber(evidence.still))
  {
    mean.Add(1.0F, Ramp(evidence.still, 0.1F, 0.6F));
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
  if (IsNumber(evidence.ownCorrelation))
  {
    mean.Add(1.0F, Ramp(evidence.ownCorrelation, 0.95F, 0.80F));
  }
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

// What lessens the interest in ground of a gate among ground: velocities about it are broad, it
// moves without being gone in the tilt above, or its own ρ_hv is that of weather.
float SignsOfAir(const GateEvidence& evidence, bool stands)
{
  const float moving = Ramp(evidence.ownSpeed, 2.0F, 5.0F) * Ramp(evidence.gradient, 20.0F, 10.0F);
  const float uniform = Ramp(evidence.ownCorrelation, 0.93F, 0.97F);
  const float broad = 1.0F - 0.3F * Ramp(evidence.width, 3.5F, 5.5F);
  return broad *
         (stands ? 1.0F - 0.2F * uniform : (1.0F - 0.25F * moving) * (1.0F - 0.55F * uniform));
}

// 0…1: velocities of both signs, as where weather turns past zero within a couplet.
float Shear(const GateEvidence& evidence)
{
  return IsNumber(evidence.speed) ? (1.0F - evidence.flow) * Ramp(evidence.speed, 3.0F, 8.0F)
                                  : 0.0F;
}

// A gate that stands still where all about it moves one way: a target that is stronger than the
// echo about it.
float LoneTarget(const GateEvidence& evidence)
{
  return IsNumber(evidence.ownStill) && evidence.flow > 0.7F
           ? evidence.ownStill * Ramp(evidence.speed, 2.0F, 5.0F)
           : 0.0F;
}

// Whether nothing that counts more than the vertical test can speak against weather: most gates of
// rain, at which the rest need not be worked out.
bool IsPlain(const GateEvidence& evidence)
{
  const bool moves = evidence.ownStill <= 0.0F && evidence.still < 0.1F;
  const bool even = evidence.squares < 8.0F && evidence.agreement > 0.6F;
  const bool uniform =
    !IsNumber(evidence.correlation) ||
    (evidence.correlation > 0.95F && evidence.ownCorrelation > 0.95F &&
      evidence.ratioSpread < 1.0F && evidence.phaseSpread < 12.0F && evidence.ratio < 3.0F);
  return moves && even && uniform;
}

} // namespace

EchoInterest InterestOf(const GateEvidence& evidence)
{
  EchoInterest interest;
  interest.polarimetric = IsNumber(evidence.correlation);
  if (IsPlain(evidence))
  {
    return interest;
  }
  Mean mean;
  AddTextures(evidence, mean);
  AddVelocities(evidence, mean);
  AddGradient(evidence, mean);
  if (interest.polarimetric)
  {
    interest.flight = NotWeather(evidence);
    mean.Add(2.0F, interest.flight);
  }
  // Nothing is surely ground that is not known to stand still.
  const bool stands = evidence.ownStill > 0.1F;
  const float ground = SignsOfAir(evidence, stands) * mean.Value();
  const float most = interest.polarimetric ? mostUnknown : mostUnknownOfOnePolarisation;
  interest.ground = stands ? ground : std::min(ground, most);
  interest.ground *= 1.0F - 0.5F * Shear(evidence);
  interest.ground = std::max(interest.ground, 0.8F * LoneTarget(evidence));
  return interest;
}

} // namespace nexrad
