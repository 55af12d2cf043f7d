// SPDX-License-Identifier: BSD-3-Clause
#include "ReadAhead.h"

#include <vtkImageData.h>

#include <future>
#include <utility>

namespace nexrad::application
{
namespace
{

class ReadAheadSeries : public VolumeSeries
{
public:
  explicit ReadAheadSeries(std::unique_ptr<VolumeSeries> source)
    : series(std::move(source))
  {
  }

  const std::vector<Time>& Times() const override { return series->Times(); }
  std::vector<std::string> Problems() const override { return series->Problems(); }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    vtkSmartPointer<vtkImageData> volume = this->Take(index);
    if (!volume)
    {
      volume = series->Load(index, progress);
    }
    const std::size_t count = series->Times().size();
    if (count > 1)
    {
      aheadIndex = (index + 1) % count;
      ahead = std::async(std::launch::async,
        [source = series.get(), next = aheadIndex] { return source->Load(next, {}); });
    }
    return volume;
  }

private:
  // What was loaded ahead, when it is that volume. Nothing else may run in the series meanwhile; a
  // failure is found again, and told, when that volume is asked for.
  vtkSmartPointer<vtkImageData> Take(std::size_t index)
  {
    if (!ahead.valid())
    {
      return nullptr;
    }
    ahead.wait();
    std::future<vtkSmartPointer<vtkImageData>> done = std::move(ahead);
    return aheadIndex == index ? done.get() : nullptr;
  }

  std::unique_ptr<VolumeSeries> series;
  std::size_t aheadIndex = 0;
  std::future<vtkSmartPointer<vtkImageData>> ahead; // ends before the series does
};

} // namespace

std::unique_ptr<VolumeSeries> ReadAhead(std::unique_ptr<VolumeSeries> series)
{
  if (!series->CanLoadAhead())
  {
    return series;
  }
  return std::make_unique<ReadAheadSeries>(std::move(series));
}

} // namespace nexrad::application
