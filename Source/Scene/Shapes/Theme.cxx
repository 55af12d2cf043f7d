// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Shapes/Theme.h"

namespace nexrad::scene
{
namespace
{

Theme MakeDark()
{
  Theme theme;
  theme.skyBottom = {0.13, 0.145, 0.165};
  theme.skyTop = {0.07, 0.085, 0.11};
  theme.ground = {0.30, 0.32, 0.34};
  theme.notScanned = {0.17, 0.16, 0.16};
  theme.rangeFolded = {0.42, 0.22, 0.52};
  theme.filtered = {0.30, 0.22, 0.12};
  theme.country = {0.72, 0.77, 0.82};
  theme.state = {0.62, 0.66, 0.71};
  theme.county = {0.41, 0.435, 0.46};
  theme.ring = {0.46, 0.60, 0.70};
  theme.marker = {1.0, 1.0, 1.0};
  theme.placeName = {0.66, 0.71, 0.77};
  theme.frame = {0.44, 0.47, 0.51};
  theme.wall = {0.30, 0.33, 0.365};
  theme.scale = {0.82, 0.86, 0.90};
  theme.title = {0.95, 0.96, 0.98};
  theme.note = {0.74, 0.78, 0.83};
  theme.warning = {1.0, 0.78, 0.10};
  theme.rim = {0.02, 0.025, 0.03};
  theme.water = {0.040, 0.062, 0.095};
  theme.relief = 0.35;
  return theme;
}

Theme MakeLight()
{
  Theme theme;
  theme.skyBottom = {1.0, 1.0, 1.0};
  theme.skyTop = {0.94, 0.955, 0.975};
  theme.ground = {0.90, 0.905, 0.895};
  theme.notScanned = {0.72, 0.72, 0.72};
  theme.rangeFolded = {0.62, 0.45, 0.72};
  theme.filtered = {0.80, 0.74, 0.64};
  theme.country = {0.25, 0.29, 0.33};
  theme.state = {0.38, 0.42, 0.46};
  theme.county = {0.70, 0.715, 0.72};
  theme.ring = {0.36, 0.48, 0.58};
  theme.marker = {0.05, 0.06, 0.08};
  theme.placeName = {0.30, 0.34, 0.39};
  theme.frame = {0.62, 0.65, 0.68};
  theme.wall = {0.80, 0.82, 0.84};
  theme.scale = {0.20, 0.23, 0.27};
  theme.title = {0.07, 0.08, 0.10};
  theme.note = {0.29, 0.32, 0.37};
  theme.warning = {0.76, 0.32, 0.0};
  theme.rim = {1.0, 1.0, 1.0};
  theme.water = {0.78, 0.835, 0.885};
  return theme;
}

} // namespace

const Theme& ThemeOf(ThemeChoice choice)
{
  static const Theme dark = MakeDark();
  static const Theme light = MakeLight();
  return choice == ThemeChoice::Light ? light : dark;
}

} // namespace nexrad::scene
