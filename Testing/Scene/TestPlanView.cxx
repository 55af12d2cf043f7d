// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Plan/PlanLayer.h"
#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/VolumeAppearance.h"

#include "ErrorMessage.h"
#include "StormVolume.h"
#include "TestData.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;
using namespace nexrad::testing;

namespace
{

constexpr VoxelState echo = VoxelState::Echo;
constexpr VoxelState none = VoxelState::NoEcho;
constexpr VoxelState folded = VoxelState::RangeFolded;
constexpr VoxelState open = VoxelState::NotScanned;

// Five columns of three levels of 1 km from 500 m up. West to east: a storm, an echo aloft, none,
// folded, not scanned.
GriddedVolume FiveColumns()
{
  GriddedVolume volume;
  volume.grid.dimensions = {5, 1, 3};
  volume.grid.origin = {0.0, 0.0, 500.0};
  volume.grid.spacing = {1000.0, 1000.0, 1000.0};
  volume.sites = {"KEAX", "KLSX"};
  const float fill = volume.fill;
  volume.states = {
    open, none, none, folded, open, echo, none, none, folded, open, echo, echo, open, open, open};
  volume.values = {
    fill, fill, fill, fill, fill, 50.0F, fill, fill, fill, fill, 30.0F, -5.0F, fill, fill, fill};
  volume.ancillary.age = {0, 11, 12, 0, 0, 20, 21, 22, 0, 0, 130, 131, 0, 0, 0};
  volume.ancillary.radars = {0, 1, 1, 0, 0, 2, 1, 1, 0, 0, 1, 1, 0, 0, 0};
  volume.ancillary.nearestSite = {255, 0, 0, 255, 255, 1, 0, 0, 255, 255, 0, 0, 255, 255, 255};
  return volume;
}

PlanSource SourceOf(const GriddedVolume& volume)
{
  const AncillaryArrays& arrays = volume.ancillary;
  const auto valuesOf = [](const auto& values) { return values.empty() ? nullptr : values.data(); };
  return {LinesOf(volume), valuesOf(arrays.age), valuesOf(arrays.radars), valuesOf(arrays.weight),
    valuesOf(arrays.nearestSite), volume.sharpened};
}

PlanView View(PlanLevel level, const std::string& array = "", double height = 0.0)
{
  return MakePlanView(SourceOf(FiveColumns()), {level, height, array});
}

std::string ErrorOf(const PlanOptions& plan)
{
  return MessageOf([&] { MakePlanView(SourceOf(FiveColumns()), plan); });
}

PlanOptions MapOf(const std::string& array)
{
  return {PlanLevel::Composite, 0.0, array};
}

} // namespace

// Water and relief are seen through the columns without echo, and those below the colour bar.
TEST(PlanView, TheGroundIsSeenWhereNoEchoIs)
{
  vtkNew<vtkImageData> placed;
  const auto layer = MakePlanLayer(View(PlanLevel::Composite),
    ScaleOf("REF", MakeTransferFunction(SceneOptions())), placed, 0.0, ThemeOf(ThemeChoice::Light));
  vtkImageData* picture = vtkImageActor::SafeDownCast(layer)->GetInput();
  ASSERT_EQ(picture->GetNumberOfScalarComponents(), 4);
  for (int x = 0; x < 5; ++x)
  {
    const bool hidden = x == 0 || x >= 3; // storm, folded, not scanned
    EXPECT_EQ(picture->GetScalarComponentAsDouble(x, 0, 0, 3), hidden ? 255.0 : 0.0) << x;
  }
}

TEST(PlanView, ACompositeShowsTheLargestEchoOfEachColumn)
{
  const PlanView view = View(PlanLevel::Composite);
  EXPECT_EQ(view.width, 5);
  EXPECT_EQ(view.height, 1);
  EXPECT_EQ(view.states, (std::vector<VoxelState>{echo, echo, none, folded, open}));
  EXPECT_EQ(view.values[0], 50.0F);
  EXPECT_EQ(view.values[1], -5.0F);
}

TEST(PlanView, TheLowestIsTheFirstThatWasScanned)
{
  const PlanView view = View(PlanLevel::Lowest);
  EXPECT_EQ(view.states, (std::vector<VoxelState>{echo, none, none, folded, open}));
  EXPECT_EQ(view.values[0], 50.0F);
}

// What quality control took out is passed over where something else of the column was measured.
TEST(PlanView, FilteredVoxelsAreShownWhereNothingIsMeasured)
{
  GriddedVolume volume = FiveColumns();
  const std::vector<VoxelState> lowest = {
    VoxelState::Filtered, VoxelState::Filtered, VoxelState::Filtered, folded, VoxelState::Filtered};
  std::copy(lowest.begin(), lowest.end(), volume.states.begin());
  volume.states[7] = volume.states[12] = open;
  for (const PlanLevel level : {PlanLevel::Composite, PlanLevel::Lowest})
  {
    const PlanView view = MakePlanView(SourceOf(volume), {level, 0.0, ""});
    EXPECT_EQ(view.states[0], echo);
    EXPECT_EQ(view.states[1], level == PlanLevel::Composite ? echo : none);
    EXPECT_EQ(view.states[2], VoxelState::Filtered);
    EXPECT_EQ(view.states[3], folded);
    EXPECT_EQ(view.states[4], VoxelState::Filtered);
    EXPECT_EQ(PlanKey(view, {}), "violet: range folded, brown: filtered");
  }
  const PlanView height = MakePlanView(SourceOf(volume), {PlanLevel::Height, 0.0, ""});
  EXPECT_EQ(height.states, lowest);
}

TEST(PlanView, AHeightIsItsLevelAndNothingElse)
{
  EXPECT_EQ(View(PlanLevel::Height, "", 0.0).states,
    (std::vector<VoxelState>{open, none, none, folded, open}));
  const PlanView view = View(PlanLevel::Height, "", 2'400.0);
  EXPECT_EQ(view.states, (std::vector<VoxelState>{echo, echo, open, open, open}));
  EXPECT_EQ(view.values[0], 30.0F);
  EXPECT_EQ(view.where, "At 2.5 km above mean sea level");
  EXPECT_EQ(View(PlanLevel::Height, "", 3'000.0).where, "At 2.5 km above mean sea level");
  EXPECT_EQ(ErrorOf({PlanLevel::Height, 3'100.0, ""}),
    "plan view at 3.1 km: the volume reaches from 0 km to 3 km above mean sea level");
}

// The map of an ancillary array shows its values in the voxels of the moment's map.
TEST(PlanView, AncillaryArraysOfTheVoxelsShown)
{
  const PlanView age = View(PlanLevel::Composite, "REF_age");
  EXPECT_EQ(age.states, (std::vector<VoxelState>{echo, echo, echo, folded, open}));
  EXPECT_EQ(age.values[0], 20.0F);
  EXPECT_EQ(age.values[1], 131.0F);
  EXPECT_EQ(age.values[2], 12.0F);
  EXPECT_EQ(View(PlanLevel::Lowest, "REF_site").values[0], 1.0F);
  EXPECT_EQ(View(PlanLevel::Height, "REF_radars", 2'500.0).values[0], 1.0F);
}

// A filled voxel has a value that no radar saw.
TEST(PlanView, AFilledVoxelHasNothingBehindIt)
{
  GriddedVolume volume = FiveColumns();
  volume.states[0] = echo;
  volume.values[0] = 50.0F;
  EXPECT_EQ(MakePlanView(SourceOf(volume), {PlanLevel::Lowest, 0.0, ""}).states[0], echo);
  EXPECT_EQ(MakePlanView(SourceOf(volume), {PlanLevel::Lowest, 0.0, "REF_age"}).states[0], open);
}

// The column in the west holds 50 above nothing and below 30.
TEST(PlanView, ACompositeOfVelocitiesShowsTheFastest)
{
  GriddedVolume volume = FiveColumns();
  volume.moment = MomentName::VEL;
  volume.values[10] = -55.0F;
  const PlanView view = MakePlanView(SourceOf(volume), {PlanLevel::Composite, 0.0, ""});
  EXPECT_EQ(view.values[0], -55.0F);
  EXPECT_EQ(view.values[1], -5.0F);
  EXPECT_EQ(view.where, "Composite: where the column's speed is largest");
}

TEST(PlanView, ACompositeWithoutMeaningIsRefused)
{
  for (const MomentName moment : {MomentName::PHI, MomentName::RHO})
  {
    GriddedVolume volume = FiveColumns();
    volume.moment = moment;
    EXPECT_THROW(MakePlanView(SourceOf(volume), {PlanLevel::Composite, 0.0, ""}), Error);
    EXPECT_EQ(MakePlanView(SourceOf(volume), {PlanLevel::Lowest, 0.0, ""}).values[0], 50.0F);
  }
}

// The storm holds 50 dBZ at 1.5 km and 30 at 2.5; the echo aloft −5 dBZ at 2.5 km.
TEST(PlanView, EchoTopsAndLiquidAreOfWholeColumns)
{
  PlanOptions plan{PlanLevel::EchoTop, 0.0, ""};
  plan.threshold = 40.0;
  const PlanView tops = MakePlanView(SourceOf(FiveColumns()), plan);
  EXPECT_EQ(tops.states, (std::vector<VoxelState>{echo, none, none, folded, open}));
  EXPECT_FLOAT_EQ(tops.values[0], 2'000.0F);
  const ColourScale kilometres = ScaleFor(tops, plan, {}, {});
  EXPECT_EQ(kilometres.title, "Echo top at 40 dBZ");
  EXPECT_EQ(kilometres.unit, "km");
  EXPECT_EQ(kilometres.bins[static_cast<std::size_t>(FindBin(kilometres, 2'100.0))].from, 2.0);
  const PlanView liquid = View(PlanLevel::Liquid);
  EXPECT_EQ(liquid.states, (std::vector<VoxelState>{echo, echo, none, folded, open}));
  // 10^(5·4/7) + 10^(3·4/7), times 3.44e-6 · 1000 m
  EXPECT_NEAR(static_cast<double>(liquid.values[0]), 2.6539, 0.0005);
  const ColourScale mass = ScaleFor(liquid, PlanOptions{PlanLevel::Liquid, 0.0, ""}, {}, {});
  EXPECT_EQ(mass.unit, "kg/m²");
  EXPECT_EQ(mass.bins[static_cast<std::size_t>(FindBin(mass, 2.6539))].from, 2.5);
  EXPECT_EQ(FindBin(mass, static_cast<double>(liquid.values[1])), -1) << "a weak echo";
  plan.level = PlanLevel::LiquidDensity;
  const PlanView density = MakePlanView(SourceOf(FiveColumns()), plan);
  EXPECT_EQ(density.states, tops.states);
  // Through 2000 m, less the 185 m of the ground at the nearest radar.
  EXPECT_NEAR(static_cast<double>(density.values[0]), 1.46220, 0.0003);
  EXPECT_EQ(ScaleFor(density, plan, {}, {}).unit, "g/m³");
  EXPECT_EQ(ScaleFor(density, plan, {}, {}).title, "VIL density, echo top at 40 dBZ");
  EXPECT_NE(density.where.find("40 dBZ above the ground at the nearest radar"), std::string::npos)
    << density.where;
}

TEST(PlanView, EchoTopsAndLiquidAreOfReflectivityAlone)
{
  GriddedVolume volume = FiveColumns();
  volume.moment = MomentName::VEL;
  for (const PlanLevel level : {PlanLevel::EchoTop, PlanLevel::Liquid, PlanLevel::LiquidDensity})
  {
    EXPECT_THROW(MakePlanView(SourceOf(volume), {level, 0.0, ""}), Error);
    EXPECT_EQ(
      ErrorOf({level, 0.0, "REF_age"}), "echo tops and liquid are computed of REF, not of REF_age");
  }
}

TEST(PlanView, AnArrayThatIsNotThereIsRefusedByName)
{
  const std::string error = ErrorOf({PlanLevel::Composite, 0.0, "REF_weight"});
  EXPECT_NE(error.find("REF_weight"), std::string::npos) << error;
  EXPECT_NE(error.find("REF, REF_age, REF_radars, REF_site"), std::string::npos) << error;
}

TEST(ColourScale, AgesAreInMinutesUpToTheOldest)
{
  const PlanView view = View(PlanLevel::Composite, "REF_age"); // to 131 s
  const ColourScale scale = ScaleFor(
    view, MapOf("REF_age"), {}, MomentScale("REF", ColourStepsOf(MakeTransferFunction({}))));
  EXPECT_EQ(scale.unit, "min");
  ASSERT_EQ(scale.bins.size(), 11u); // of 0.2 minutes
  EXPECT_NEAR(scale.bins[1].from, 0.2, 1e-9);
  EXPECT_EQ(FindBin(scale, 0.0), 0);
  EXPECT_EQ(FindBin(scale, 11.9), 0);
  EXPECT_EQ(FindBin(scale, 12.1), 1);
  EXPECT_EQ(FindBin(scale, 131.0), 10);
}

TEST(ColourScale, RadarsAndSitesHaveABoxEach)
{
  const PlanView radars = View(PlanLevel::Composite, "REF_radars");
  const ColourScale numbers = ScaleFor(
    radars, MapOf("REF_radars"), {}, MomentScale("REF", ColourStepsOf(MakeTransferFunction({}))));
  EXPECT_EQ(numbers.labels, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(FindBin(numbers, 1.0), 0);
  EXPECT_EQ(FindBin(numbers, 2.0), 1);
  const ColourScale sites =
    ScaleFor(View(PlanLevel::Composite, "REF_site"), MapOf("REF_site"), {"KEAX", "KLSX"}, {});
  EXPECT_EQ(sites.labels, (std::vector<std::string>{"KEAX", "KLSX"}));
  EXPECT_NE(sites.bins[0].colour, sites.bins[1].colour);
}

TEST(ColourScale, TheMomentKeepsItsTable)
{
  const ColourScale scale = ScaleFor(View(PlanLevel::Composite), PlanOptions(), {},
    MomentScale("REF", ColourStepsOf(MakeTransferFunction({}))));
  EXPECT_EQ(scale.unit, "dBZ");
  EXPECT_EQ(scale.bins.size(), ColourStepsOf(MakeTransferFunction({})).size());
  EXPECT_EQ(FindBin(scale, 4.9), -1);
  EXPECT_EQ(FindBin(scale, 5.0), 0);
  EXPECT_EQ(FindBin(scale, 200.0), 14);
}

// Each was "Reflectivity, dBZ", and negative velocities had no colour.
TEST(ColourScale, EveryMomentHasItsNameItsUnitAndAColourForEachValue)
{
  const auto scaleOf = [](const std::string& array)
  { return MomentScale(array, ColourStepsOf(MakeTransferFunction({}, array))); };
  EXPECT_EQ(scaleOf("REF").title, "Reflectivity");
  const ColourScale velocity = scaleOf("VEL");
  EXPECT_EQ(velocity.title, "Radial velocity, positive away from the radar");
  EXPECT_EQ(velocity.unit, "m/s");
  EXPECT_EQ(FindBin(velocity, -63.5), 0);
  EXPECT_EQ(velocity.bins[static_cast<std::size_t>(FindBin(velocity, -0.5))].from, -1.0);
  EXPECT_EQ(velocity.bins[static_cast<std::size_t>(FindBin(velocity, -20.0))].from, -20.0);
  EXPECT_EQ(scaleOf("SW").title, "Spectrum width");
  EXPECT_EQ(scaleOf("ZDR").title, "Differential reflectivity");
  EXPECT_EQ(scaleOf("ZDR").unit, "dB");
  EXPECT_EQ(FindBin(scaleOf("ZDR"), -7.9), 0);
  EXPECT_EQ(scaleOf("PHI").title, "Differential phase");
  EXPECT_EQ(scaleOf("PHI").unit, "degrees");
  EXPECT_EQ(scaleOf("RHO").title, "Correlation coefficient");
  EXPECT_EQ(scaleOf("RHO").unit, "");
  EXPECT_EQ(scaleOf("CFP").title, "Clutter filter power removed");
  EXPECT_EQ(scaleOf("quality").title, "quality") << "an array of another name";
}

// More columns than are visited together, on several threads, as values and as the codes of a file.
TEST(PlanView, AVolumeOfCodesHasTheMapsOfItsValues)
{
  const TemporaryFolder folder;
  const GriddedVolume storm = MakeStorm(true);
  WriteNxv(folder.Path() / "storm.nxv", storm);
  vtkNew<vtkImageData> codes;
  vtkNexradReadVolumeFile(folder.Path() / "storm.nxv", {}, true, codes);
  vtkNew<vtkImageData> values;
  vtkNexradReadVolumeFile(folder.Path() / "storm.nxv", {}, false, values);
  ASSERT_NE(vtkUnsignedCharArray::SafeDownCast(codes->GetPointData()->GetScalars()), nullptr);
  const GriddedVolume read = ReadNxv(folder.Path() / "storm.nxv");
  for (const PlanLevel level : {PlanLevel::Composite, PlanLevel::Lowest, PlanLevel::Height,
         PlanLevel::EchoTop, PlanLevel::Liquid, PlanLevel::LiquidDensity})
  {
    const PlanOptions plan{level, 3000.0, ""};
    const PlanView wanted = MakePlanView(SourceOf(read), plan);
    for (vtkImageData* image : {codes.Get(), values.Get()})
    {
      const PlanView view = MakePlanView(SourceOf(image), plan, ThreadLoop(3));
      EXPECT_EQ(view.states, wanted.states);
      for (std::size_t i = 0; i < view.values.size(); ++i)
      {
        if (wanted.states[i] == echo)
        {
          ASSERT_EQ(view.values[i], wanted.values[i]) << i;
        }
      }
    }
  }
}

TEST(PlanView, AVolumeWithoutStatesIsNamed)
{
  vtkSmartPointer<vtkImageData> image = MakeStormVolume(true);
  image->GetPointData()->RemoveArray("REF_state");
  EXPECT_THROW(SourceOf(image), Error);
}
