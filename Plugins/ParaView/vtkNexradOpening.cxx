// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradOpening.h"

#include <pqApplicationCore.h>
#include <pqObjectBuilder.h>
#include <pqPipelineSource.h>

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMProxySelectionModel.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>

#include <QPointer>
#include <QStringList>
#include <QTimer>

#include <cstring>

namespace
{

// Of sweeps that are opened in the window REF alone is read, until other moments are ticked:
// moments with other gates are separate grids at the same places.
void ReadReflectivityAlone(pqPipelineSource* made)
{
  vtkSMProxy* sweeps = made->getProxy();
  if (std::strcmp(sweeps->GetXMLName(), "NexradLevel2Series") != 0)
  {
    return;
  }
  const vtkSMPropertyHelper moments(sweeps, "MomentsInfo");
  vtkSMPropertyHelper wanted(sweeps, "Moments");
  for (unsigned int i = 0; i + 1 < moments.GetNumberOfElements(); i += 2)
  {
    const char* name = moments.GetAsString(i);
    wanted.SetStatus(name, std::strcmp(name, "REF") == 0 ? 1 : 0);
  }
  sweeps->UpdateVTKObjects();
}

bool IsRadarDay(const pqPipelineSource* source)
{
  return std::strcmp(source->getProxy()->GetXMLName(), "NexradRadarDay") == 0;
}

// The files that are opened by one press of a button: all sources of them are made before the
// window handles another event.
class OpenedTogether
{
public:
  void Add(pqPipelineSource* made)
  {
    if (!IsRadarDay(made))
    {
      return;
    }
    if (!first)
    {
      first = made;
      QTimer::singleShot(0, made, [this] { this->Finish(); });
      return;
    }
    const vtkSMPropertyHelper files(made->getProxy(), "FileNames");
    for (unsigned int i = 0; i < files.GetNumberOfElements(); ++i)
    {
      more << QString(files.GetAsString(i));
    }
    surplus << made;
  }

private:
  void Finish()
  {
    if (first && !more.empty())
    {
      this->GiveFilesToFirst();
    }
    for (const QPointer<pqPipelineSource>& each : surplus)
    {
      if (each)
      {
        pqApplicationCore::instance()->getObjectBuilder()->destroy(each);
      }
    }
    if (first)
    {
      vtkSMProxy* day = first->getProxy();
      vtkSMProxySelectionModel* active =
        day->GetSessionProxyManager()->GetSelectionModel("ActiveSources");
      active->SetCurrentProxy(day, vtkSMProxySelectionModel::CLEAR_AND_SELECT);
    }
    first.clear();
    more.clear();
    surplus.clear();
  }

  void GiveFilesToFirst()
  {
    vtkSMProxy* day = first->getProxy();
    vtkSMPropertyHelper files(day, "FileNames");
    unsigned int count = files.GetNumberOfElements();
    for (const QString& file : more)
    {
      files.Set(count, file.toLocal8Bit().constData());
      ++count;
    }
    day->UpdateVTKObjects();
    vtkSMSourceProxy::SafeDownCast(day)->UpdatePipelineInformation();
    first->rename("RadarDay");
  }

  QPointer<pqPipelineSource> first;
  QStringList more;
  QList<QPointer<pqPipelineSource>> surplus;
};

} // namespace

void vtkNexradWatchOpening()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  if (!core)
  {
    return;
  }
  static OpenedTogether opened;
  QObject::connect(core->getObjectBuilder(),
    qOverload<pqPipelineSource*, const QStringList&>(&pqObjectBuilder::readerCreated), core,
    [](pqPipelineSource* made, const QStringList&) { opened.Add(made); });
  QObject::connect(core->getObjectBuilder(), &pqObjectBuilder::sourceCreated, core,
    [](pqPipelineSource* made) { ReadReflectivityAlone(made); });
}
