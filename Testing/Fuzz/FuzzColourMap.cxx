// SPDX-License-Identifier: BSD-3-Clause
// Feeds texts to the readers of colour maps: ParaView's JSON, .pal tables and .csv tables. The
// first byte of an input says which; the rest is the text.
#include "FuzzTarget.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkNexradTransferFunction.h"
#include "vtkObject.h"
#include "vtkPiecewiseFunction.h"

#include <array>
#include <cmath>

using namespace nexrad::testing;

namespace
{

constexpr int channels = 4;

bool IsShare(double value)
{
  return value >= 0.0 && value <= 1.0;
}

void LookAtNodes(vtkNexradTransferFunction* function)
{
  for (int channel = 0; channel < channels; ++channel)
  {
    double before = 0.0;
    for (int i = 0; i < function->GetNumberOfNodes(channel); ++i)
    {
      double node[2];
      Require(function->GetNode(channel, i, node), "nodes that are counted are there");
      Require(std::isfinite(node[0]) && IsShare(node[1]), "nodes are numbers, values 0 to 1");
      Require(i == 0 || before < node[0], "nodes ascend");
      Require(IsShare(function->Evaluate(channel, node[0])), "values at nodes are 0 to 1");
      Require(i == 0 || IsShare(function->Evaluate(channel, before + 0.5 * (node[0] - before))),
        "values between nodes are 0 to 1");
      before = node[0];
    }
  }
}

void LookAtBins(vtkNexradTransferFunction* function)
{
  double before = 0.0;
  for (int i = 0; i < function->GetNumberOfBins(); ++i)
  {
    double range[2];
    double lower[3];
    double upper[3];
    Require(function->GetBin(i, range, lower, upper), "bins that are counted are there");
    Require(std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1],
      "bins have a width");
    Require(i == 0 || before <= range[0], "bins ascend");
    for (int channel = 0; channel < 3; ++channel)
    {
      Require(IsShare(lower[channel]) && IsShare(upper[channel]), "colours are 0 to 1");
    }
    before = range[0];
  }
}

void LookAtFunctions(vtkNexradTransferFunction* function)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  function->FillColorFunction(colors);
  function->FillOpacityFunction(opacities);
  function->FillSteppedColorFunction(colors);
  for (int i = 0; i < function->GetNumberOfIsoValues(); ++i)
  {
    Require(std::isfinite(function->GetIsoValue(i)), "iso-values are numbers");
  }
}

void WriteAndReadAgain(vtkNexradTransferFunction* function)
{
  static const InputFile json("again.json");
  static const InputFile palette("again.pal");
  vtkNew<vtkNexradTransferFunction> copy;
  Require(function->WriteFile(json.Path().c_str()) && copy->ReadFile(json.Path().c_str()),
    "a map that was read is written, and read again");
  Require(copy->IsEqual(function), "a map comes back as it was written");
  Require(function->WriteFile(palette.Path().c_str()), "a map that was read is written as a table");
}

Bytes SeedOf(std::uint8_t kind, const std::string& text)
{
  return Join({{kind}, BytesOf(text)});
}

std::string PresetText(const char* name)
{
  vtkNew<vtkNexradTransferFunction> function;
  function->ApplyPreset(name);
  return function->FormatJSON();
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  return {
    SeedOf(0, R"([{"Name":"x","ColorSpace":"Lab","RGBPoints":[0,0,0,1,30,0.5,0.25,0,70,1,1,1],)"
              R"("Points":[0,0,0.5,0,40,0.25,0.3,0.1,70,1,0.5,0]}])"),
    SeedOf(0, R"({"ColorSpace":"HSV","RGBPoints":[0,0,0,1,0,0.5,0.25,0,70,1,1,1]})"),
    SeedOf(0, R"([{"vtkNexradNodes":{"red":[0,0,70,1],"green":[0,1],"blue":[5,0,6,1],)"
              R"("opacity":[0,0,30,0.5,70,1]},"vtkNexradBins":[0,5,0,0,0,1,1,1,5,10,1,1,1,0,0,0],)"
              R"("vtkNexradIsoValues":[20,35,50]}])"),
    SeedOf(0, PresetText("iso-values")),
    SeedOf(1, "; name\nProduct: BR\nUnits: DBZ\nScale: 2\nOffset: -10\nColor: 10 2 253 2 1 2 3\n"
              "Color4: 20 0 0 0 128\nSolidColor: 30 1 2 3\nSolidColor4: 40 255 0 255 255\n"),
    SeedOf(1, "Color: 0 0 0 0\nColor: 10 255 255 255\nColor: 20 1 1 1\n"),
    SeedOf(2, "dbz,colour\n5,#04e9e7\n10,#019ff4\n75,#fdfdfd\n")};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  vtkObject::GlobalWarningDisplayOff();
  static const std::array<InputFile, 3> files = {
    InputFile("map.json"), InputFile("map.pal"), InputFile("map.csv")};
  const InputFile& file = files[data[0] % files.size()];
  file.Write(data + 1, size - 1);
  vtkNew<vtkNexradTransferFunction> function;
  vtkNew<vtkNexradTransferFunction> before;
  if (!function->ReadFile(file.Path().c_str()))
  {
    Require(function->IsEqual(before), "a map that is refused changes nothing");
    return 0;
  }
  LookAtNodes(function);
  LookAtBins(function);
  LookAtFunctions(function);
  WriteAndReadAgain(function);
  return 0;
}
