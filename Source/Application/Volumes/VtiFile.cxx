// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/VtiFile.h"

#include "Output/OutputFile.h"
#include "nexrad/System/MessageText.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradMessages.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <string>

namespace nexrad::application
{

void WriteVti(const std::filesystem::path& path, const GriddedVolume& volume)
{
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  vtkNexradAddRadarView(image);
  vtkNew<vtkXMLImageDataWriter> writer;
  vtkNexradMessages messages;
  messages.Watch(writer);
  writer->SetInputData(image);
  // To memory first: VTK's writer leaves a cut file behind when the disk is full.
  writer->WriteToOutputStringOn();
  writer->Write();
  if (!messages.Errors().empty())
  {
    throw FileError(path, messages.Errors().front());
  }
  const std::string bytes = writer->GetOutputString();
  WriteFile(path, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

GridSpecification ReadVtiGrid(const std::filesystem::path& path)
{
  vtkNew<vtkXMLImageDataReader> reader;
  vtkNexradMessages messages;
  messages.Watch(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!messages.Errors().empty())
  {
    throw FileError(path, messages.Errors().front());
  }
  return vtkNexradImageToGrid(reader->GetOutput());
}

} // namespace nexrad::application
