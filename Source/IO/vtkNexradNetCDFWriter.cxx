// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFWriter.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradNetCDFOutput.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNexradNetCDFWriter);

vtkNexradNetCDFWriter::vtkNexradNetCDFWriter() = default;

vtkNexradNetCDFWriter::~vtkNexradNetCDFWriter() = default;

void vtkNexradNetCDFWriter::WriteVolume(const nexrad::GriddedVolume& volume)
{
  if (this->IsSeries())
  {
    const std::string path = this->FileOf(volume, ".nc");
    Attempt([&]() { vtkNexradWriteNetCDF(path, volume, this->History); });
    this->Written.push_back(path);
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

void vtkNexradNetCDFWriter::CompleteFile()
{
  Attempt([this]() { this->Output->Commit(); });
  this->Output.reset();
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
