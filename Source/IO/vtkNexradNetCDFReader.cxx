// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFReader.h"

#include "nexrad/System/Error.h"
#include "vtkNexradArrayChoice.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradNetCDFInput.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVolumeSteps.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

vtkStandardNewMacro(vtkNexradNetCDFReader);

vtkNexradNetCDFReader::vtkNexradNetCDFReader() = default;

vtkNexradNetCDFReader::~vtkNexradNetCDFReader() = default;

int vtkNexradNetCDFReader::CanReadFile(const char* path)
{
  if (vtkNexradPathError(path) != vtkErrorCode::NoError || fs::is_directory(path))
  {
    return 0;
  }
  try
  {
    vtkNexradReadNetCDFContents(vtkNexradListedSteps(path).front().File);
    return 1;
  }
  catch (const nexrad::Error&)
  {
    return 0;
  }
}

vtkNexradVolumeSteps vtkNexradNetCDFReader::ListSteps()
{
  vtkNexradVolumeSteps steps;
  for (const vtkNexradVolumeStep& listed : vtkNexradListedSteps(this->FileName))
  {
    const fs::path& path = listed.File;
    const vtkNexradNetCDFContents contents = vtkNexradReadNetCDFContents(path);
    if (steps.Steps.empty())
    {
      steps.Grid = contents.Grid;
      steps.OfOneRadar = contents.OfOneRadar;
      steps.Ancillary = contents.Ancillary;
    }
    else if (contents.Grid != steps.Grid)
    {
      throw nexrad::Error(path.string() + ": its grid is not that of the first file of the series");
    }
    for (std::size_t i = 0; i < contents.Times.size(); ++i)
    {
      steps.Steps.push_back({nexrad::ToSeconds(contents.Times[i]), path, i});
    }
  }
  std::sort(steps.Steps.begin(), steps.Steps.end(),
    [](const auto& a, const auto& b) { return a.Time < b.Time; });
  return steps;
}

void vtkNexradNetCDFReader::ReadStep(const vtkNexradVolumeStep& step, vtkImageData* image)
{
  const vtkNexradNetCDFRequest request{step.Index, vtkNexradMomentsToRead(this->Moments),
    vtkNexradNamesToLeaveOut(this->GetAncillaryArraySelection())};
  const nexrad::GriddedVolume volume = vtkNexradReadNetCDF(step.File, request);
  if (volume.grid != this->OpenedSteps().Grid)
  {
    throw nexrad::Error(step.File.string() + ": its grid has changed since it was opened");
  }
  vtkNexradVolumeToImage(volume, image);
}

void vtkNexradNetCDFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
