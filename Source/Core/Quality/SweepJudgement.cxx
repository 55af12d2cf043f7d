// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SweepJudgement.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// The most interest in ground of a gate that is not known to stand still: less than it takes to be
// surely ground.
constexpr float mostUnknown = 0.58F;
constexpr float mostUnknownOfOnePolarisation = 0.56F;

// What the evidence of a gate speaks for (Formulas Q1 and Q2). Everything that is known counts,
// with fixed weights. Nothing here branches: the compiler works on several gates at once.

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
  mean.Add(Known(evidence.squares), Ramp(evidence.squares, 8.0F, 40.0F));
  mean.Add(0.5F * Known(evidence.agreement), Ramp(evidence.agreement, 0.6F, 0.25F));
  mean.Add(Known(evidence.still), Ramp(evidence.still, 0.1F, 0.6F));
  mean.Add(Known(evidence.ownStill), evidence.ownStill);
  // The vertical test. Side lobes see the ground about the radar at all tilts, and high tilts see
  // it with side lobes alone.
  const float telling =
    Ramp(evidence.range, 5'000.0F, 25'000.0F) * Ramp(evidence.elevation, 4.5F, 1.0F);
  mean.Add(telling * Known(evidence.gradient), Ramp(evidence.gradient, 3.0F, 15.0F));
  mean.Add(2.0F * polarimetric, notWeather);
  // Nothing is surely ground that is not known to stand still.
  const float stands = evidence.ownStill > 0.1F ? 1.0F : 0.0F;
  const float all = SignsOfAir(evidence, stands) * mean.Value();
  const float most = mostUnknownOfOnePolarisation +
                     polarimetric * (mostUnknown - mostUnknownOfOnePolarisation) + stands;
  const float ground = std::min(all, most) * (1.0F - 0.5F * Shear(evidence));
  return std::max(ground, 0.8F * LoneTarget(evidence));
}

constexpr double halfBeam = 0.5;          // degrees
constexpr double surelyNear = 20'000.0;   // m, range where side lobes see the ground
constexpr float lowGround = 1000.0F;      // m, lower beam edge
constexpr float highGround = 5000.0F;     // m, from which on ground takes the most interest
constexpr float highestGround = 15000.0F; // m: higher up not even side lobes show ground
constexpr double effectiveRadius = 4.0 / 3.0 * EarthRadius; // m, of the earth
constexpr float surelyGround = 0.59F;                       // interest of gates that are low
constexpr float ofOnePolarisation = 0.02F; // less interest is enough without two polarisations
constexpr float surelyHighGround = 0.65F;  // interest of gates from highGround on
constexpr float likely = 0.15F;            // less interest is enough for likely ground
constexpr float overNoise = 4.0F;          // dB that echo must have over the weakest

constexpr float surelyNotWeather = 0.6F; // interest in what is not weather
constexpr float surelyFlight = 0.776F;   // ρ₀: a depolarisation ratio of −9 dB
constexpr float likelyFlight = 0.868F;   // ρ₀: a depolarisation ratio of −11.5 dB
constexpr float uniformTargets = 0.95F;  // ρ_hv from which on targets are all alike
constexpr float couplet = 8.0F;          // m/s, mean |V|
constexpr float highestFlight = 3500.0F; // m, lower beam edge
constexpr float strongCore = 45.0F;      // dBZ
constexpr float filtered = 30.0F;        // dB that the clutter filter removed
constexpr float debris = 35.0F;          // dBZ

// The power that the weakest echo of a sweep has, dBZ at 1 km: of nine rays in ten the weakest one
// is stronger. Where birds fill most rays, few show how weak echo can be.
float WeakestPower(const EchoGrid& grid, const std::vector<float>& spreading)
{
  std::vector<float> powers;
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    const float* row = grid.Row(place);
    const GateRange held = grid.Held(place);
    const std::size_t end = std::min(spreading.size(), held.end);
    float least = -NoNumber;
    for (std::size_t gate = held.begin; gate < end; ++gate)
    {
      const float power = IsNumber(row[gate]) ? row[gate] - spreading[gate] : -NoNumber;
      least = power < least ? power : least;
    }
    if (least < -NoNumber)
    {
      powers.push_back(least);
    }
  }
  if (powers.empty())
  {
    return NoNumber;
  }
  const auto tenth = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 10);
  std::nth_element(powers.begin(), tenth, powers.end());
  return *tenth;
}

// How much more interest in ground it takes at a strong core: where the tilt above has it, too, and
// where ρ_hv about it is that of weather, so that a gate which stands still is no lone target.
float CoreMargin(const GateEvidence& evidence)
{
  const float above =
    Ramp(evidence.gradient, 12.0F, 6.0F) * Ramp(evidence.range, 10'000.0F, 25'000.0F);
  const float uniform = Ramp(evidence.correlation, 0.90F, uniformTargets);
  return evidence.reflectivity < strongCore ? 0.0F : 0.2F * (above + uniform);
}

// Whether two polarisations can tell what a gate is: the echo is strong enough, and low.
bool IsTelling(const GateEvidence& evidence, const SweepJudgement& sweep, std::size_t gate)
{
  return IsNumber(evidence.correlation) && sweep.heights[gate] <= highestFlight &&
         evidence.reflectivity >= sweep.weakest[gate] + overNoise;
}

EchoReason WeatherOf(float reflectivity)
{
  return reflectivity >= strongCore ? EchoReason::StrongCore : EchoReason::Plain;
}

// The reasons of all gates that have a value.
std::vector<EchoReason> AllWeather(const EchoGrid& grid)
{
  std::vector<EchoReason> reasons(grid.Count(), EchoReason::None);
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    const float* row = grid.Row(place);
    const GateRange held = grid.Held(place);
    EchoReason* own = reasons.data() + grid.Index(place, 0);
    for (std::size_t gate = held.begin; gate < held.end; ++gate)
    {
      own[gate] = IsNumber(row[gate]) ? WeatherOf(row[gate]) : EchoReason::None;
    }
  }
  return reasons;
}

EchoReason ReasonOf(
  const GateEvidence& evidence, float notWeather, const SweepJudgement& sweep, std::size_t gate)
{
  const float value = evidence.reflectivity;
  const EchoReason weather = WeatherOf(value);
  if (!IsTelling(evidence, sweep, gate))
  {
    return weather;
  }
  const bool unsteady = IsNumber(evidence.speed) && evidence.flow < 0.5F;
  if (notWeather >= surelyNotWeather && unsteady)
  {
    return value >= debris && evidence.speed > couplet ? EchoReason::Debris
           : evidence.filterPower >= filtered          ? EchoReason::GroundFilter
                                                       : weather;
  }
  const bool melts = evidence.correlation < 0.96F && evidence.correlation > 0.7F &&
                     value >= 15.0F && value < strongCore && sweep.heights[gate] > 500.0F &&
                     evidence.gradient < 15.0F && evidence.squares < 30.0F;
  return melts && notWeather < surelyNotWeather ? EchoReason::MeltingLayer : weather;
}

std::uint8_t FlightOf(const GateEvidence& evidence, float roundCorrelation,
  const SweepJudgement& sweep, std::size_t gate)
{
  if (!IsTelling(evidence, sweep, gate) || evidence.correlation >= uniformTargets ||
      evidence.reflectivity >= StrongestBiologicalEcho)
  {
    return FlightSign::None;
  }
  return roundCorrelation <= surelyFlight   ? FlightSign::Sure
         : roundCorrelation <= likelyFlight ? FlightSign::Likely
                                            : FlightSign::None;
}

// `ground` and `notWeather`: interest in them.
void JudgeGate(SweepJudgement& sweep, std::size_t index, std::size_t gate,
  const GateEvidence& evidence, float ground, float notWeather, float roundCorrelation)
{
  const float limit = sweep.limits[gate] + CoreMargin(evidence) -
                      (IsNumber(evidence.correlation) ? 0.0F : ofOnePolarisation);
  sweep.signs[index] = ground >= limit            ? GroundSign::Sure
                       : ground >= limit - likely ? GroundSign::Likely
                                                  : GroundSign::None;
  sweep.speeds[index] =
    IsNumber(evidence.ownSpeed) ? SpeedCode(evidence.ownSpeed) : std::uint8_t(0);
  sweep.gradients[index] = static_cast<std::int8_t>(std::clamp(evidence.gradient, -100.0F, 100.0F));
  sweep.reasons[index] = ReasonOf(evidence, notWeather, sweep, gate);
  if (sweep.IsPolarimetric() && sweep.reasons[index] != EchoReason::GroundFilter)
  {
    sweep.flights[index] = FlightOf(evidence, roundCorrelation, sweep, gate);
  }
}

} // namespace

double BeamHeight(double range, double elevation)
{
  return range * std::sin(elevation * RadiansPerDegree) + range * range / (2.0 * effectiveRadius);
}

double JudgedRange(double elevation)
{
  // Where BeamHeight is highestGround.
  const double sine = effectiveRadius * std::sin((elevation - halfBeam) * RadiansPerDegree);
  const double range = std::sqrt(sine * sine + 2.0 * effectiveRadius * highestGround) - sine;
  return std::max(range, surelyNear);
}

void SweepJudgement::Set(const PolarSweep& sweep, const SweepSources& sources)
{
  if (sweep.rays.empty() || sweep.gates == 0 || !(sweep.gateSpacing > 0.0))
  {
    return;
  }
  grid = std::make_unique<EchoGrid>(sweep);
  reasons = AllWeather(*grid);
  if (sources.surveillance)
  {
    return;
  }
  std::vector<float> spreading;
  const double farthest = JudgedRange(grid->Elevation());
  for (; judged < grid->Gates() && grid->RangeOf(judged) <= farthest; ++judged)
  {
    const double range = grid->RangeOf(judged);
    const auto height = static_cast<float>(BeamHeight(range, grid->Elevation() - halfBeam));
    const float part = range < surelyNear ? 0.0F : Ramp(height, lowGround, highGround);
    heights.push_back(height);
    limits.push_back(surelyGround + part * (surelyHighGround - surelyGround));
    spreading.push_back(static_cast<float>(20.0 * std::log10(std::max(range, 1000.0) / 1000.0)));
  }
  const float power = WeakestPower(*grid, spreading);
  for (const float each : spreading)
  {
    weakest.push_back(power + each);
  }
  signs.assign(reasons.size(), GroundSign::None);
  flights.assign(sources.correlation.sweep ? reasons.size() : 0, FlightSign::None);
  speeds.assign(reasons.size(), 0);
  gradients.assign(reasons.size(), 0);
}

RowJudge::RowJudge(
  SweepJudgement& theSweep, const SweepSources& sources, const std::vector<GateRange>& wanted)
  : sweep(theSweep)
  , reader(*theSweep.grid, theSweep.above, sources, theSweep.judged, wanted)
{
}

void RowJudge::Judge(std::size_t place)
{
  constexpr std::size_t gatesTogether = 64;
  reader.Read(place, evidence);
  const std::size_t gates = evidence.gates.size();
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
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t gate = evidence.gates[first + i];
      JudgeGate(sweep, sweep.grid->Index(place, gate), gate, evidence.At(first + i), ground[i],
        notWeather[i], roundCorrelation[i]);
    }
  }
}

} // namespace nexrad
