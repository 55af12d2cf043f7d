// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFWriter.h"

#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradNetCDFOutput.h"

#include "vtkObjectFactory.h"

#include <filesystem>

vtkStandardNewMacro(vtkNexradNetCDFWriter);

vtkNexradNetCDFWriter::vtkNexradNetCDFWriter() = default;

vtkNexradNetCDFWriter::~vtkNexradNetCDFWriter() = default;

void vtkNexradNetCDFWriter::BeginSteps()
{
  this->Output.reset();
  this->Index.clear();
}

void vtkNexradNetCDFWriter::WriteVolume(const nexrad::GriddedVolume& volume)
{
  if (this->IsSeries())
  {
    const std::string name = nexrad::FormatForFileName(volume.time) + ".nc";
    const auto path = std::filesystem::path(this->FileName).parent_path() / name;
    Attempt([&]() { vtkNexradWriteNetCDF(path, volume, this->History); });
    this->Index.emplace_back(name, nexrad::ToSeconds(volume.time));
    this->Written.push_back(path.string());
    return;
  }
  const auto add = [&]()
  {
    if (!this->Output)
    {
      this->Output = std::make_unique<vtkNexradNetCDFOutput>(this->FileName, this->History);
    }
    this->Output->Add(volume);
  };
  Attempt(add);
}

void vtkNexradNetCDFWriter::EndSteps()
{
  if (this->IsSeries())
  {
    Attempt([this]() { nexrad::WriteNxvSeries(this->FileName, this->Index); });
  }
  else
  {
    Attempt([this]() { this->Output->Commit(); });
    this->Output.reset();
  }
  this->Written.emplace_back(this->FileName);
}

void vtkNexradNetCDFWriter::GiveUp()
{
  this->Output.reset();
}

void vtkNexradNetCDFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AllTimeSteps: " << this->AllTimeSteps << "\n";
  os << indent << "History: " << this->History << "\n";
}
