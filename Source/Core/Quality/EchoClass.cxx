// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoClass.h"

#include <array>

namespace nexrad
{

const char* ToString(QualityLevel level)
{
  constexpr std::array<const char*, 3> names = {"off", "standard", "strict"};
  return names[static_cast<std::size_t>(level)];
}

EchoClass ClassOf(EchoReason reason)
{
  switch (reason)
  {
  case EchoReason::None:
    return EchoClass::None;
  case EchoReason::Plain:
  case EchoReason::StrongCore:
  case EchoReason::MeltingLayer:
  case EchoReason::Debris:
    return EchoClass::Weather;
  case EchoReason::GroundTexture:
  case EchoReason::GroundRegion:
  case EchoReason::GroundHeight:
  case EchoReason::GroundPolarimetry:
  case EchoReason::GroundFilter:
    return EchoClass::Ground;
  case EchoReason::FlightPolarimetry:
  case EchoReason::ClearAir:
    return EchoClass::Biological;
  case EchoReason::ConstantPower:
    return EchoClass::Spike;
  case EchoReason::ConstantValue:
    return EchoClass::ReceiverFault;
  case EchoReason::FewGates:
    return EchoClass::Speckle;
  }
  return EchoClass::None;
}

const char* ToString(EchoClass echoClass)
{
  constexpr std::array<const char*, EchoClassCount> names = {
    "none", "weather", "ground", "biological", "spike", "receiver fault", "speckle"};
  return names[static_cast<std::size_t>(echoClass)];
}

const char* ToString(EchoReason reason)
{
  constexpr std::array<const char*, EchoReasonCount> names = {"none", "plain", "strong core",
    "melting layer", "debris", "ground texture", "ground region", "ground height",
    "ground polarimetry", "ground filter", "flight polarimetry", "clear air", "constant power",
    "constant value", "few gates"};
  return names[static_cast<std::size_t>(reason)];
}

} // namespace nexrad
