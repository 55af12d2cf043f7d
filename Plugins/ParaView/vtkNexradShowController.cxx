// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradShowController.h"

#include "nexrad/Model/Moment.h"
#include "vtkNexradAppearance.h"
#include "vtkNexradFirstView.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <string>

vtkStandardNewMacro(vtkNexradShowController);

namespace
{

// Makes the controllers of ParaView's client ours.
class ShowFactory : public vtkObjectFactory
{
public:
  static ShowFactory* New()
  {
    auto* made = new ShowFactory;
    made->InitializeObjectBase();
    return made;
  }
  vtkTypeMacro(ShowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "Shows radar volumes"; }

private:
  ShowFactory()
  {
    this->RegisterOverride("vtkSMParaViewPipelineControllerWithRendering",
      "vtkNexradShowController", "Shows radar volumes", 1,
      []() -> vtkObject* { return vtkNexradShowController::New(); });
  }
};

// Volume, sweeps, map, …; empty for what is not of this plugin.
std::string KindOf(vtkSMProxy* producer)
{
  vtkPVXMLElement* hints = producer ? producer->GetHints() : nullptr;
  vtkPVXMLElement* show = hints ? hints->FindNestedElementByName("NexradShow") : nullptr;
  return show ? show->GetAttributeOrEmpty("kind") : "";
}

bool IsRenderView(vtkSMViewProxy* view)
{
  return view && std::string(view->GetXMLName()) == "RenderView";
}

// Whether the view shows the output of a source of that kind.
bool ShowsKind(vtkSMViewProxy* view, const std::string& kind)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* representation = shown.GetAsProxy(i);
    if (representation && representation->GetProperty("Input") &&
        KindOf(vtkSMPropertyHelper(representation, "Input").GetAsProxy()) == kind)
    {
      return true;
    }
  }
  return false;
}

// The preset of the moment whose function is registered as "REF.PiecewiseFunction", or as
// "Separate_123_REF.PiecewiseFunction" where a representation has a colour map of its own.
std::string PresetOf(const std::string& name)
{
  const std::string array = name.substr(0, name.find('.'));
  const std::string moment = array.substr(array.rfind('_') + 1);
  return nexrad::ParseMomentName(moment) ? vtkSMSettings::GetInstance()->GetSettingAsString(
                                             (".standard_presets." + moment).c_str(), "")
                                         : std::string();
}

// That in which a person works; nullptr where there is none.
vtkSMProxy* ActiveView(vtkSMProxy* proxy)
{
  vtkSMProxySelectionModel* active =
    proxy->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  return active != nullptr ? active->GetCurrentProxy() : nullptr;
}

} // namespace

vtkSMProxy* vtkNexradShowController::Show(
  vtkSMSourceProxy* producer, int outputPort, vtkSMViewProxy* view, const char* representationType)
{
  const std::string kind = KindOf(producer);
  const bool isFirst =
    !kind.empty() && IsRenderView(view) && !view->FindRepresentation(producer, outputPort);
  const bool isAlone = isFirst && !vtkNexradShowsData(view);
  vtkSMProxy* shown = this->Superclass::Show(producer, outputPort, view, representationType);
  if (!isFirst || !shown)
  {
    return shown;
  }
  if (kind == "map")
  {
    vtkNexradDressMap(shown, view);
  }
  else if (kind == "time")
  {
    vtkNexradDressWords(shown, {"Color"}, view);
  }
  else if (kind == "volume" || kind == "sweeps")
  {
    const auto box =
      kind == "volume" ? vtkNexradDressVolume(shown, view) : vtkNexradDressSweeps(shown);
    if (box && isAlone)
    {
      vtkNexradDressView(view, *box, kind == "sweeps");
    }
  }
  return shown;
}

vtkSMViewProxy* vtkNexradShowController::ShowInPreferredView(
  vtkSMSourceProxy* producer, int outputPort, vtkSMViewProxy* view)
{
  const bool isFirst = view && producer && !view->FindRepresentation(producer, outputPort);
  vtkSMViewProxy* used = this->Superclass::ShowInPreferredView(producer, outputPort, view);
  const std::string kind = KindOf(producer);
  if (isFirst && used == view && IsRenderView(view) && (kind == "volume" || kind == "sweeps"))
  {
    if (kind == "volume" && !ShowsKind(view, "map"))
    {
      this->ShowCompanion(producer, view, "NexradMap", "Map");
    }
    if (!ShowsKind(view, "time"))
    {
      this->ShowCompanion(producer, view, "NexradTimeText", "Time");
    }
  }
  return used;
}

bool vtkNexradShowController::PostInitializeProxy(vtkSMProxy* proxy)
{
  if (!this->Superclass::PostInitializeProxy(proxy))
  {
    return false;
  }
  if (std::string(proxy->GetXMLName()) == "ScalarBarWidgetRepresentation")
  {
    vtkSMProxy* table = vtkSMPropertyHelper(proxy, "LookupTable").GetAsProxy();
    const char* name =
      table ? table->GetSessionProxyManager()->GetProxyName("lookup_tables", table) : nullptr;
    if (!PresetOf(name ? name : "").empty())
    {
      for (const char* format : {"LabelFormat", "RangeLabelFormat"})
      {
        vtkSMPropertyHelper(proxy, format, true).Set("%-.4g");
      }
      vtkSMPropertyHelper(proxy, "AutomaticLabelFormat", true).Set(0);
      proxy->UpdateVTKObjects();
      vtkNexradDressWords(proxy, {"TitleColor", "LabelColor"}, ActiveView(proxy));
    }
  }
  return true;
}

bool vtkNexradShowController::RegisterOpacityTransferFunction(vtkSMProxy* proxy, const char* name)
{
  const std::string preset = PresetOf(name ? name : "");
  if (!preset.empty())
  {
    vtkSMTransferFunctionProxy::ApplyPreset(proxy, preset.c_str(), false);
  }
  return this->Superclass::RegisterOpacityTransferFunction(proxy, name);
}

void vtkNexradShowController::ShowCompanion(
  vtkSMSourceProxy* producer, vtkSMViewProxy* view, const char* filter, const char* name)
{
  vtkSMSessionProxyManager* manager = producer->GetSessionProxyManager();
  const auto made = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("filters", filter));
  auto* companion = vtkSMSourceProxy::SafeDownCast(made);
  if (!companion)
  {
    return;
  }
  this->PreInitializeProxy(companion);
  vtkSMPropertyHelper(companion, "Input").Set(producer);
  if (KindOf(companion) == "map")
  {
    vtkNexradSizeLetters(companion, view);
  }
  this->PostInitializeProxy(companion);
  const std::string unique = manager->GetUniqueProxyName("sources", name, false);
  // Without the controller, which would make the companion the active source: the window would make
  // its panel, and then again that of what was applied.
  manager->RegisterProxy("sources", unique.c_str(), companion);
  companion->UpdateVTKObjects();
  this->Show(companion, 0, view);
}

void vtkNexradStartShowController()
{
  const vtkProcessModule::ProcessTypes process = vtkProcessModule::GetProcessType();
  if (process != vtkProcessModule::PROCESS_CLIENT && process != vtkProcessModule::PROCESS_BATCH)
  {
    return;
  }
  static const auto factory = vtkSmartPointer<ShowFactory>::Take(ShowFactory::New());
  vtkObjectFactory::RegisterFactory(factory);
}
