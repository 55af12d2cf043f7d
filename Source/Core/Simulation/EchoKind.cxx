// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/EchoKind.h"

#include "nexrad/System/Error.h"

#include <sstream>

namespace nexrad
{

namespace
{

EchoKind ParseEchoKind(const std::string& name)
{
  std::string known;
  for (const EchoKind kind : AddableEchoKinds())
  {
    if (name == ToString(kind))
    {
      return kind;
    }
    known += std::string(ToString(kind)) + ", ";
  }
  throw Error("'" + name + "' is no kind of echo; write " + known + "or all");
}

} // namespace

const char* ToString(EchoKind kind)
{
  constexpr const char* names[] = {"none", "weather", "clutter", "propagation", "biological", "sun",
    "interference", "test-pattern", "speckle"};
  return names[static_cast<std::size_t>(kind)];
}

const std::set<EchoKind>& AddableEchoKinds()
{
  static const std::set<EchoKind> kinds = {EchoKind::Clutter, EchoKind::AnomalousPropagation,
    EchoKind::Biological, EchoKind::Sun, EchoKind::Interference, EchoKind::TestPattern,
    EchoKind::Speckle};
  return kinds;
}

std::set<EchoKind> ParseEchoKinds(const std::string& text)
{
  if (text == "all")
  {
    return AddableEchoKinds();
  }
  std::set<EchoKind> kinds;
  std::istringstream names(text + ",");
  for (std::string name; std::getline(names, name, ',');)
  {
    kinds.insert(ParseEchoKind(name));
  }
  return kinds;
}

} // namespace nexrad
