// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/RadarVote.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace nexrad
{

namespace
{

// Damaged rays may all have different senders; no file needs more groups than this.
constexpr std::size_t mostGroups = 100;

// Numbers that are none are alike, too: a damaged position is one.
bool AreAlike(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool HaveOnePosition(const ArrivedRay& a, const ArrivedRay& b)
{
  if (!a.position || !b.position)
  {
    return a.position.has_value() == b.position.has_value();
  }
  const StoredPosition& one = *a.position;
  const StoredPosition& other = *b.position;
  return AreAlike(one.latitude, other.latitude) && AreAlike(one.longitude, other.longitude) &&
         one.siteHeight == other.siteHeight && one.feedhornHeight == other.feedhornHeight;
}

bool HaveOneSender(const ArrivedRay& a, const ArrivedRay& b)
{
  return a.messageType == b.messageType && a.siteName == b.siteName && HaveOnePosition(a, b);
}

// Rays that have something in common, by the first of them.
struct Group
{
  void Add(const ArrivedRay& ray)
  {
    first = first != nullptr ? first : &ray;
    ++rays;
  }

  const ArrivedRay* first = nullptr;
  std::size_t rays = 0;
};

std::vector<Group> GroupBySender(const RayList& rays)
{
  std::vector<Group> groups;
  std::size_t latest = 0; // group of the ray before
  for (const ArrivedRay* ray : rays)
  {
    if (latest >= groups.size() || !HaveOneSender(*groups[latest].first, *ray))
    {
      const auto same = std::find_if(groups.begin(), groups.end(),
        [ray](const Group& group) { return HaveOneSender(*group.first, *ray); });
      latest = static_cast<std::size_t>(same - groups.begin());
      if (same == groups.end())
      {
        if (groups.size() == mostGroups)
        {
          continue;
        }
        groups.emplace_back();
      }
    }
    groups[latest].Add(*ray);
  }
  return groups;
}

// Of two that have as many rays the one that came first.
const ArrivedRay& FindWinner(
  const std::vector<Group>& groups, std::size_t rays, const std::string& headerName)
{
  constexpr std::size_t share = 10;
  const auto isSmaller = [&](const Group& a, const Group& b)
  {
    const auto isNamed = [&](const Group& group)
    {
      return !headerName.empty() && group.first->siteName == headerName &&
             group.rays * share >= rays;
    };
    return isNamed(a) != isNamed(b) ? isNamed(b) : a.rays < b.rays;
  };
  return *std::max_element(groups.begin(), groups.end(), isSmaller)->first;
}

enum class Sender
{
  Radar,         // the one that the file is of
  OtherName,     // it stands where the radar does, under another name
  OtherPosition, // it has the radar's name, and stands elsewhere
  Other
};

Sender SenderOf(const ArrivedRay& ray, const ArrivedRay& winner)
{
  if (ray.messageType != winner.messageType)
  {
    return Sender::Other;
  }
  const bool sameName = ray.siteName == winner.siteName;
  if (HaveOnePosition(ray, winner))
  {
    return sameName ? Sender::Radar : ray.position ? Sender::OtherName : Sender::Other;
  }
  return sameName ? Sender::OtherPosition : Sender::Other;
}

bool AreNear(const ArrivedRay* before, const ArrivedRay* after)
{
  return before == nullptr || after == nullptr ||
         (after->ray.time >= before->ray.time && after->ray.time - before->ray.time <= LongestStep);
}

// Whether each ray is the radar's. Those with another position are judged from the first to the
// last, and then from the last to the first, beside those that were found to be the radar's.
class OwnRays
{
public:
  OwnRays(const RayList& theRays, const ArrivedRay& winner)
    : rays(theRays)
    , isOwn(theRays.size())
  {
    for (std::size_t index = 0; index < rays.size(); ++index)
    {
      const Sender sender = SenderOf(*rays[index], winner);
      isOwn[index] = sender == Sender::Radar || sender == Sender::OtherName;
      mayBeOwn.push_back(sender == Sender::OtherPosition);
    }
    this->FindForwards();
    this->FindBackwards();
  }

  bool operator[](std::size_t index) const { return isOwn[index]; }

private:
  bool Fits(const ArrivedRay* before, std::size_t index, const ArrivedRay* after) const
  {
    const ArrivedRay& ray = *rays[index];
    return BelongsBetween(before, ray, ray, after) && AreNear(before, &ray) && AreNear(&ray, after);
  }

  void FindForwards()
  {
    const ArrivedRay* before = nullptr;
    std::size_t next = 0; // the next own ray
    for (std::size_t index = 0; index < rays.size(); ++index)
    {
      for (next = std::max(next, index + 1); next < rays.size() && !isOwn[next]; ++next)
      {
      }
      const ArrivedRay* after = next < rays.size() ? rays[next] : nullptr;
      isOwn[index] = isOwn[index] || (mayBeOwn[index] && this->Fits(before, index, after));
      before = isOwn[index] ? rays[index] : before;
    }
  }

  // What lies before the first own ray; the rest was judged.
  void FindBackwards()
  {
    const auto first = std::find(isOwn.begin(), isOwn.end(), true);
    for (auto index = static_cast<std::size_t>(first - isOwn.begin()); index > 0; --index)
    {
      if (index < rays.size() && mayBeOwn[index - 1] && isOwn[index])
      {
        isOwn[index - 1] = this->Fits(nullptr, index - 1, rays[index]);
      }
    }
  }

  const RayList& rays;
  std::vector<bool> isOwn;
  std::vector<bool> mayBeOwn;
};

std::string NameOf(const ArrivedRay& ray)
{
  std::ostringstream text;
  text << (ray.siteName.empty() ? "without a name" : ray.siteName);
  if (ray.position)
  {
    text << std::fixed << std::setprecision(3) << " at " << ray.position->latitude << ", "
         << ray.position->longitude << " degrees";
  }
  return text.str();
}

// Leaves in `rays` those of the radar that sent `winner`, and reports the others, and those that
// state another name or position.
void KeepRaysOf(const ArrivedRay& winner, RayList& rays, const ArrivedDamage& report)
{
  const OwnRays isOwn(rays, winner);
  RayList own;
  Group names;     // of the radar, under another name
  Group positions; // of the radar, at another place
  Group others;    // of other radars
  for (std::size_t index = 0; index < rays.size(); ++index)
  {
    const ArrivedRay& ray = *rays[index];
    if (!isOwn[index])
    {
      others.Add(ray);
      continue;
    }
    own.push_back(rays[index]);
    if (ray.siteName != winner.siteName)
    {
      names.Add(ray);
    }
    else if (!HaveOnePosition(ray, winner))
    {
      positions.Add(ray);
    }
  }
  const auto tell = [&](const Group& group, const std::string& what)
  {
    if (group.rays > 0)
    {
      report(*group.first,
        std::to_string(group.rays) + " of " + std::to_string(rays.size()) + " rays " + what);
    }
  };
  tell(names, "state another name of the radar than most do: that of most is used");
  tell(positions, "state another position of the radar than most do: that of most is used");
  if (others.rays > 0)
  {
    tell(others, "are not of the radar of the file (" + NameOf(winner) + ") but of another one (" +
                   NameOf(*others.first) + "): left out");
  }
  rays = std::move(own);
}

} // namespace

RadarOfRays KeepOneRadar(RayList& rays, const std::string& headerName, const ArrivedDamage& report)
{
  if (rays.empty())
  {
    return {};
  }
  const ArrivedRay* winner = rays.front();
  const bool oneSender = std::all_of(rays.begin(), rays.end(),
    [winner](const ArrivedRay* ray) { return HaveOneSender(*ray, *winner); });
  if (!oneSender)
  {
    winner = &FindWinner(GroupBySender(rays), rays.size(), headerName);
    KeepRaysOf(*winner, rays, report);
  }
  return {winner->siteName, winner->position};
}

} // namespace nexrad
