// SPDX-License-Identifier: BSD-3-Clause
#include "Web/WebPage.h"

#include "Libraries/VtkErrors.h"
#include "Output/OutputFile.h"
#include "Scene/EchoFraming.h"
#include "Scene/Series/InputSeries.h"
#include "Scene/VolumeAppearance.h"
#include "Web/ColumnPacking.h"
#include "Web/PageFolder.h"
#include "Web/PageScene.h"
#include "Web/PageText.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

class PageMaker
{
public:
  explicit PageMaker(const scene::WebRequest& webRequest)
    : request(webRequest)
    , series(scene::OpenInputs(webRequest.input, webRequest.progress))
    , chosen(scene::ChooseTimes(*series, webRequest.input))
    , echo(scene::MeasureSeries(*series, chosen, webRequest.scene))
  {
  }

  scene::WebReport MakeSinglePage()
  {
    PageText text = MakePageWithLetters();
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      const PackedColumns packed = this->Pack(this->Load(i));
      text.AddPart("ends-" + std::to_string(i), packed.ends);
      text.AddPart("codes-" + std::to_string(i), packed.codes);
    }
    return this->Finish(std::move(text), request.output, {});
  }

  scene::WebReport MakeFolder()
  {
    const NamedFiles files = FindVolumeFiles(request.input.inputs);
    this->Load(0); // fails for a preset that the volumes cannot have before anything is written
    const VolumeFolder volumes = FillVolumeFolder(files, request.output);
    PageText text = MakePageWithLetters();
    text.AddWrittenFiles(volumes.written);
    scene::WebReport report =
      this->Finish(std::move(text), request.output / PageName, volumes.index);
    report.times = volumes.times;
    return report;
  }

private:
  vtkSmartPointer<vtkImageData> Load(std::size_t i)
  {
    const Progress drawing = ShareOf(request.progress, ScanShare, 1.0);
    const auto image = series->Load(chosen[i], ShareOf(drawing, i, chosen.size()));
    if (!image)
    {
      throw Error("stopped before the page was made");
    }
    if (!page)
    {
      page.emplace(request, image, echo);
    }
    times.push_back(CaptionsOf(image, series->Times()[chosen[i]], request.scene));
    return image;
  }

  PackedColumns Pack(vtkImageData* image) const
  {
    return PackColumns(page->Size(), page->Encode(image));
  }

  scene::WebReport Finish(PageText text, const fs::path& path, const std::string& index)
  {
    text.AddTextPart("scene", page->MakeText(times, index));
    text.AddPart("ground", page->GroundTexels());
    ThrowVtkErrors();
    const std::string html = text.Make(page->Title(times));
    WriteFile(path, reinterpret_cast<const unsigned char*>(html.data()), html.size());
    scene::WebReport report;
    report.page = path;
    report.bytes = html.size();
    report.times = times.size();
    report.notes = scene::LinesPassedOver(request.scene);
    report.problems = series->Problems();
    return report;
  }

  const scene::WebRequest& request;
  std::unique_ptr<scene::VolumeSeries> series;
  std::vector<std::size_t> chosen;
  std::optional<scene::EchoExtent> echo; ///< of all times, where there are several
  std::optional<PageScene> page;         ///< once the first volume is there
  std::vector<PageTime> times;
};

} // namespace

bool IsSinglePage(const fs::path& output)
{
  const bool isPage = output.extension() == ".html" || output.extension() == ".htm";
  return isPage && !fs::is_directory(output);
}

scene::WebReport MakeWebPage(const scene::WebRequest& request)
{
  PageMaker maker(request);
  return IsSinglePage(request.output) ? maker.MakeSinglePage() : maker.MakeFolder();
}

} // namespace nexrad::application
