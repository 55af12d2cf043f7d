// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeFile.h"

#include "nexrad/Codec/NxvReader.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"

void vtkNexradReadVolumeFile(const vtkNexradVolumeFile& file, vtkImageData* image)
{
  nexrad::NxvReadOptions options;
  options.bytesBesides = vtkNexradImageBytesPerVoxel + file.BytesBesides;
  options.leaveOut = file.LeaveOut;
  options.moments = file.Moments;
  options.loop = vtkNexradRangeLoop();
  options.block = file.Block;
  options.level = file.Level;
  if (!nexrad::HasNxvCodes(file.FileName, options, !file.Codes))
  {
    vtkNexradVolumeToImage(nexrad::ReadNxv(file.FileName, options), image);
    return;
  }
  nexrad::CodedVolume coded = nexrad::ReadNxvCodes(file.FileName, options).value();
  if (file.Codes)
  {
    vtkNexradCodesToImage(coded, image);
  }
  else
  {
    vtkNexradCodesToValues(coded, image);
  }
}
