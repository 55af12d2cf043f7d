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

// Nothing here branches: the compiler works on several gates at once.

constexpr std::size_t gatesTogether = 64;

float Known(float value)
{
  return IsNumber(value) ? 1.0F : 0.0F;
}

// A weighted mean. What is not known has no weight.
class Mean
{
public:
  void Add(float weight, float interest)
  {
    sum += weight * interest;
    weights += weight;
  }
  float Value() const { return sum / std::max(weights, 1.0e-6F); }

private:
  float sum = 0.0F;
  float weights = 0.0F;
};

void AddTextures(const GateEvidence& evidence, Mean& mean)
{
  mean.Add(Known(evidence.squares), Ramp(evidence.squares, 8.0F, 40.0F));
  mean.Add(0.5F * Known(evidence.agreement), Ramp(evidence.agreement, 0.6F, 0.25F));
}

void AddVelocities(const GateEvidence& evidence, Mean& mean)
{
  mean.Add(Known(evidence.still), Ramp(evidence.still, 0.1F, 0.6F));
  mean.Add(Known(evidence.ownStill), evidence.ownStill);
}

// The vertical test. Side lobes see the ground about the radar at all tilts, and high tilts see it
// with side lobes alone.
void AddGradient(const GateEvidence& evidence, Mean& mean)
{
  const float known =
    Ramp(evidence.range, 5'000.0F, 25'000.0F) * Ramp(evidence.elevation, 4.5F, 1.0F);
  mean.Add(known * Known(evidence.gradient), Ramp(evidence.gradient, 3.0F, 15.0F));
}

float NotWeather(const GateEvidence& evidence)
{
  Mean mean;
  mean.Add(1.0F, Ramp(evidence.correlation, 0.95F, 0.80F));
  mean.Add(Known(evidence.ownCorrelation), Ramp(evidence.ownCorrelation, 0.95F, 0.80F));
  mean.Add(1.0F, std::max(Ramp(evidence.ratio, 3.0F, 6.0F), Ramp(evidence.ratio, -2.0F, -4.0F)));
  const float spread = Known(evidence.ratioSpread);
  mean.Add(spread, Ramp(evidence.ratioSpread, 1.0F, 2.5F));
  mean.Add(spread, Ramp(evidence.phaseSpread, 12.0F, 30.0F));
  const float texture = 0.25F * Known(evidence.squares);
  mean.Add(texture, Ramp(evidence.squares, 30.0F, 70.0F));
  mean.Add(texture, Ramp(evidence.turns, 0.3F, 0.6F));
  return mean.Value();
}

// What lessens the interest in ground of a gate among ground: velocities about it are broad, it
// moves without being gone in the tilt above, or its own ρ_hv is that of weather.
float SignsOfAir(const GateEvidence& evidence, float stands)
{
  const float moving = Ramp(evidence.ownSpeed, 2.0F, 5.0F) * Ramp(evidence.gradient, 20.0F, 10.0F);
  const float uniform = Ramp(evidence.ownCorrelation, 0.93F, 0.97F);
  const float broad = 1.0F - 0.3F * Ramp(evidence.width, 3.5F, 5.5F);
  const float standing = 1.0F - 0.2F * uniform;
  const float passing = (1.0F - 0.25F * moving) * (1.0F - 0.55F * uniform);
  return broad * (passing + stands * (standing - passing));
}

// 0…1: velocities of both signs, as where weather turns past zero within a couplet.
float Shear(const GateEvidence& evidence)
{
  return Known(evidence.speed) * (1.0F - evidence.flow) * Ramp(evidence.speed, 3.0F, 8.0F);
}

// A gate that stands still where all about it moves one way: a target that is stronger than the
// echo about it.
float LoneTarget(const GateEvidence& evidence)
{
  const float oneWay = evidence.flow > 0.7F ? 1.0F : 0.0F;
  return oneWay * evidence.ownStill * Known(evidence.ownStill) * Ramp(evidence.speed, 2.0F, 5.0F);
}

// The depolarisation ratio (1 + z − 2ρ√z)/(1 + z + 2ρ√z), z the linear Z_DR (Ryzhkov et al. 2017,
// J. Appl. Meteor. Climatol. 56, 1877), is (1 − ρ₀)/(1 + ρ₀) with ρ₀ = ρ/cosh(ln(z)/2).
float RoundCorrelation(const GateEvidence& evidence)
{
  constexpr float halfLogarithm = 0.115129255F; // of the linear Z_DR, for each dB
  const float angle = halfLogarithm * evidence.ratio;
  const float square = angle * angle;
  const float cosh = 1.0F + square * (0.5F + square * (1.0F / 24.0F + square * (1.0F / 720.0F)));
  const float known = Known(evidence.correlation);
  return known * evidence.correlation / cosh + 1.0F - known;
}

float GroundOf(const GateEvidence& evidence, float notWeather)
{
  const float polarimetric = Known(evidence.correlation);
  Mean mean;
  AddTextures(evidence, mean);
  AddVelocities(evidence, mean);
  AddGradient(evidence, mean);
  mean.Add(2.0F * polarimetric, notWeather);
  // Nothing is surely ground that is not known to stand still.
  const float stands = evidence.ownStill > 0.1F ? 1.0F : 0.0F;
  const float all = SignsOfAir(evidence, stands) * mean.Value();
  const float most = mostUnknownOfOnePolarisation +
                     polarimetric * (mostUnknown - mostUnknownOfOnePolarisation) + stands;
  const float ground = std::min(all, most) * (1.0F - 0.5F * Shear(evidence));
  return std::max(ground, 0.8F * LoneTarget(evidence));
}

} // namespace

void FindInterest(const EvidenceRow& evidence, InterestRow& interest)
{
  const std::size_t gates = evidence.gates.size();
  interest.ground.resize(gates);
  interest.notWeather.resize(gates);
  interest.roundCorrelation.resize(gates);
  for (std::size_t first = 0; first < gates; first += gatesTogether)
  {
    // Arrays of this function's own: no other array can be the same memory.
    float ground[gatesTogether];
    float notWeather[gatesTogether];
    float roundCorrelation[gatesTogether];
    const std::size_t count = std::min(gatesTogether, gates - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      const GateEvidence gate = evidence.At(first + i);
      notWeather[i] = Known(gate.correlation) * NotWeather(gate);
      ground[i] = GroundOf(gate, notWeather[i]);
      roundCorrelation[i] = RoundCorrelation(gate);
    }
    std::copy_n(ground, count, interest.ground.data() + first);
    std::copy_n(notWeather, count, interest.notWeather.data() + first);
    std::copy_n(roundCorrelation, count, interest.roundCorrelation.data() + first);
  }
}

} // namespace nexrad
