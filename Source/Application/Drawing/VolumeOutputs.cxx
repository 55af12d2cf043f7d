// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/VolumeOutputs.h"

#include "Drawing/MovieOutput.h"
#include "Scene/Series/InputSeries.h"
#include "Scene/Series/VolumeSeries.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

namespace nexrad::scene
{

RenderReport WriteEachVolume(const RenderRequest& request,
  const std::function<void(const std::filesystem::path&, vtkImageData*)>& write)
{
  auto series = OpenInputs(request.input, request.progress);
  const std::vector<std::size_t> chosen = ChooseTimes(*series, request.input);
  const Progress writing = ShareOf(request.progress, ScanShare, 1.0);
  RenderReport report;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const Progress part = ShareOf(writing, i, chosen.size());
    const vtkSmartPointer<vtkImageData> volume = series->Load(chosen[i], part);
    if (!volume || (part && !part(1.0)))
    {
      throw Error("stopped before all files were written");
    }
    const Time time = series->Times()[chosen[i]];
    report.outputs.push_back(PictureName(request.output, time, chosen.size() > 1));
    write(report.outputs.back(), volume);
  }
  report.problems = series->Problems();
  return report;
}

} // namespace nexrad::scene
