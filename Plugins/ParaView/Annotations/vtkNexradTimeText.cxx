// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTimeText.h"

#include "Scene/Captions/EchoShown.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Model/Time.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradTransferFunction.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <optional>

vtkStandardNewMacro(vtkNexradTimeText);

namespace
{

std::optional<double> TimeOf(vtkDataObject* data)
{
  vtkFieldData* field = data->GetFieldData();
  for (const char* name : {"TimeValue", "StartTime"})
  {
    if (const auto time = vtkNexradGetValue(field, name))
    {
      return time;
    }
  }
  vtkInformation* info = data->GetInformation();
  return info->Has(vtkDataObject::DATA_TIME_STEP())
           ? std::optional(info->Get(vtkDataObject::DATA_TIME_STEP()))
           : std::nullopt;
}

std::vector<std::string> RadarsOf(vtkFieldData* field)
{
  std::vector<std::string> radars = vtkNexradGetTexts(field, "Sites");
  return radars.empty() ? vtkNexradGetTexts(field, "Site") : radars;
}

// "2006-03-12T18:05:00Z" as people read it; parts of seconds stay out.
std::string ReadableTime(double seconds)
{
  std::string text = nexrad::FormatIso8601(nexrad::FromSeconds(seconds)).substr(0, 19);
  text[10] = ' ';
  return text + " UTC";
}

// What there is in a volume of which its moment's usual preset shows nothing; else nothing.
std::string WordsFor(vtkImageData* volume)
{
  using namespace nexrad::scene;
  if (volume == nullptr || ArrayOf(volume).empty())
  {
    return "";
  }
  const auto usual = MakeTransferFunction(SceneOptions(), ArrayOf(volume));
  return WordsForNothing(
    volume, std::nullopt, usual, ReadVolumeInformation(volume).biologicalShare, false);
}

} // namespace

vtkNexradTimeText::vtkNexradTimeText() = default;

vtkNexradTimeText::~vtkNexradTimeText() = default;

int vtkNexradTimeText::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkNexradTimeText::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  output->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkNexradTimeText::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* data = vtkDataObject::GetData(input[0], 0);
  const std::optional<double> time = TimeOf(data);
  std::string text = time ? ReadableTime(*time) : std::string("no time");
  std::string radars;
  for (const std::string& radar : RadarsOf(data->GetFieldData()))
  {
    radars += (radars.empty() ? "" : " ") + radar;
  }
  if (this->Radars && !radars.empty())
  {
    text += "\n" + radars;
  }
  if (vtkNexradGetValue(data->GetFieldData(), "Synthetic").value_or(0.0) != 0.0)
  {
    text += "\nSYNTHETIC";
  }
  // A process that has a part of a volume does not know of the others.
  const int parts = output->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  const std::string nothing = parts > 1 ? "" : WordsFor(vtkImageData::SafeDownCast(data));
  text += nothing.empty() ? "" : "\n" + nothing;
  vtkNew<vtkStringArray> column;
  column->SetName("Text");
  column->InsertNextValue(text);
  vtkTable::GetData(output)->AddColumn(column);
  return 1;
}

void vtkNexradTimeText::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radars: " << this->Radars << "\n";
}
