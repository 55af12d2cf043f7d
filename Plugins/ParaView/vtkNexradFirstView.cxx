// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradFirstView.h"

#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Theme.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{

using nexrad::scene::CameraView;
using nexrad::scene::Colour;
using nexrad::scene::Theme;

const Theme& UsualTheme()
{
  return ThemeOf(nexrad::scene::SceneOptions().theme);
}

void SetTriple(vtkSMProxy* proxy, const char* property, const double* values)
{
  vtkSMPropertyHelper(proxy, property, true).Set(values, 3);
}

bool HasUsualSky(vtkSMProxy* view)
{
  Colour sky{};
  return view != nullptr && view->GetProperty("Background") != nullptr &&
         vtkSMPropertyHelper(view, "UseColorPaletteForBackground", true).GetAsInt() == 0 &&
         vtkSMPropertyHelper(view, "Background").Get(sky.data(), 3) == 3 &&
         sky == UsualTheme().skyBottom;
}

// Width over height; of ParaView's usual view where it has no size yet.
double AspectOf(vtkSMViewProxy* view)
{
  std::array<int, 2> size{};
  vtkSMPropertyHelper(view, "ViewSize", true).Get(size.data(), 2);
  return std::min(size[0], size[1]) > 0 ? static_cast<double>(size[0]) / size[1] : 1.5;
}

void Aim(vtkSMViewProxy* view, const CameraView& from, const std::array<double, 6>& box)
{
  // The legend stands at the right.
  constexpr nexrad::scene::PictureArea area = {-0.97, 0.80, -0.97, 0.97};
  vtkNew<vtkCamera> camera;
  PointCamera(camera, from, box, AspectOf(view), area);
  SetTriple(view, "CameraPosition", camera->GetPosition());
  SetTriple(view, "CameraFocalPoint", camera->GetFocalPoint());
  SetTriple(view, "CameraViewUp", camera->GetViewUp());
  vtkSMPropertyHelper(view, "CameraViewAngle", true).Set(camera->GetViewAngle());
  const std::array<double, 3> middle = {
    0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5])};
  SetTriple(view, "CenterOfRotation", middle.data());
}

} // namespace

bool vtkNexradShowsData(vtkSMViewProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    auto* each = vtkSMPVRepresentationProxy::SafeDownCast(shown.GetAsProxy(i));
    if (each && vtkSMPropertyHelper(each, "Visibility").GetAsInt() != 0)
    {
      return true;
    }
  }
  return false;
}

void vtkNexradDressView(vtkSMViewProxy* view, const std::array<double, 6>& box, bool fromAbove)
{
  vtkSMPropertyHelper(view, "UseColorPaletteForBackground", true).Set(0);
  vtkSMPropertyHelper(view, "BackgroundColorMode", true).Set("Gradient");
  SetTriple(view, "Background", UsualTheme().skyBottom.data());
  SetTriple(view, "Background2", UsualTheme().skyTop.data());
  CameraView from;
  if (fromAbove)
  {
    from.azimuth = 180.0;
    from.tilt = 90.0;
  }
  Aim(view, from, box);
  vtkNexradDressWords(view, {"OrientationAxesLabelColor"}, view);
  view->UpdateVTKObjects();
}

double vtkNexradLetterHeight(vtkSMViewProxy* view)
{
  constexpr double part = 0.035; // of the height of the picture; they lie on the ground
  std::array<double, 3> from{};
  std::array<double, 3> to{};
  vtkSMPropertyHelper(view, "CameraPosition").Get(from.data(), 3);
  vtkSMPropertyHelper(view, "CameraFocalPoint").Get(to.data(), 3);
  const double half =
    vtkMath::RadiansFromDegrees(0.5 * vtkSMPropertyHelper(view, "CameraViewAngle").GetAsDouble());
  return part * 2.0 * std::tan(half) *
         std::sqrt(vtkMath::Distance2BetweenPoints(from.data(), to.data()));
}

void vtkNexradDressWords(
  vtkSMProxy* proxy, std::initializer_list<const char*> properties, vtkSMProxy* view)
{
  if (HasUsualSky(view))
  {
    for (const char* property : properties)
    {
      SetTriple(proxy, property, UsualTheme().title.data());
    }
    proxy->UpdateVTKObjects();
  }
}
