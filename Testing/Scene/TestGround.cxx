// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/PictureLayout.h"
#include "Scene/Map/GroundPicture.h"
#include "Scene/Map/MapData.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Map/PlacedMap.h"
#include "Tolerance.h"

#include "nexrad/Compression/Deflate.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;

namespace
{

const Theme& theme = ThemeOf(ThemeChoice::Light);

// A domain of 40 columns about a place.
SceneFrame FrameAt(double longitude, double latitude, double spacing = 10'000.0)
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(40, 40, 2);
  volume->SetSpacing(spacing, spacing, 10'000.0);
  volume->SetOrigin(-19.5 * spacing, -19.5 * spacing, 5'000.0);
  vtkNew<vtkStringArray> projection;
  projection->SetName("Projection");
  projection->InsertNextValue("+proj=aeqd +lat_0=" + std::to_string(latitude) +
                              " +lon_0=" + std::to_string(longitude) + " +datum=WGS84 +units=m");
  volume->GetFieldData()->AddArray(projection);
  return SceneFrame(volume, 4.0);
}

std::array<int, 3> ColourAt(vtkImageData* picture, int column, int row)
{
  const auto* texel = static_cast<unsigned char*>(picture->GetScalarPointer(column, row, 0));
  return {texel[0], texel[1], texel[2]};
}

std::array<int, 3> BytesOf(const Colour& colour)
{
  std::array<int, 3> bytes{};
  std::transform(colour.begin(), colour.end(), bytes.begin(),
    [](double part) { return static_cast<int>(std::lround(255.0 * part)); });
  return bytes;
}

bool IsLand(double longitude, double latitude)
{
  const SceneFrame frame = FrameAt(longitude, latitude);
  constexpr int side = 401; // its middle cell has the place in its middle
  const auto land = PaintLand(frame, EmbeddedMapAreas(), side, side);
  return land[land.size() / 2] != 0;
}

// One tile of 4 × 4 samples from 90° W, 30° N on, in units of 10 m: 2 + column + 3 row. The steps:
// 2, 1, 1, 1 in the first row, 3 and three times 0 in the others, stored twice as large.
std::string RampFile()
{
  const std::vector<std::uint8_t> samples = {4, 2, 2, 2, 6, 0, 0, 0, 6, 0, 0, 0, 6, 0, 0, 0};
  const auto stream = DeflateBytes(samples.data(), samples.size());
  // -90 is stored as 179 = 0xb3 0x01, 30 as 60.
  return std::string("NXELEV1\n") + "\x04\x0a\x01\x01" + "\xb3\x01\x3c" + "\x10" +
         std::string(stream.begin(), stream.end());
}

Elevations Parse(const std::string& bytes)
{
  return Elevations::Parse(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

// Ground that rises by metres a cell of 1 km.
HeightGrid SlopeOf(double eastwards, double northwards)
{
  HeightGrid ground{5, 5, 1.0, 1.0, {}};
  for (int row = 0; row < 5; ++row)
  {
    for (int column = 0; column < 5; ++column)
    {
      ground.heights.push_back(500.0 + eastwards * column + northwards * row);
    }
  }
  return ground;
}

} // namespace

// Cubic B-splines reproduce linear functions.
TEST(Elevations, AreBetweenTheSamplesOfAFile)
{
  const Elevations ramp = Parse(RampFile());
  const auto height = ramp.At(-90.0 + 1.3 / 4.0, 30.0 + 1.6 / 4.0);
  ASSERT_TRUE(height);
  EXPECT_NEAR(*height, 10.0 * (2.0 + 1.3 + 3.0 * 1.6), 1e-9);
  EXPECT_FALSE(ramp.At(-89.9, 30.4)) << "of the samples about it some are in no tile";
  EXPECT_TRUE(ramp.At(270.3, 30.4)) << "the same meridian";
}

TEST(Elevations, WrongBytesAreErrors)
{
  const std::string whole = RampFile();
  for (std::size_t length = 0; length < whole.size(); ++length)
  {
    EXPECT_THROW(Parse(whole.substr(0, length)), Error) << length;
  }
  const auto with = [&](std::size_t offset, char byte)
  {
    std::string bytes = whole;
    bytes[offset] = byte;
    return bytes;
  };
  EXPECT_THROW(Parse(with(0, 'n')), Error) << "magic";
  EXPECT_THROW(Parse(with(8, 0)), Error) << "no samples in a degree";
  EXPECT_THROW(Parse(with(11, 2)), Error) << "more tiles than there are";
  EXPECT_THROW(Parse(with(15, 0x0f)), Error) << "fewer bytes than samples";
}

TEST(Elevations, TheEmbeddedOnesAreThoseOfKnownPlaces)
{
  const Elevations& all = EmbeddedElevations();
  const auto at = [&](double longitude, double latitude)
  { return all.At(longitude, latitude).value_or(-1.0); };
  EXPECT_WITHIN(at(-104.9, 39.7), 1600.0, 150.0, "height of Denver, m");
  EXPECT_WITHIN(at(-97.3, 35.3), 370.0, 60.0, "height at KTLX, m");
  EXPECT_AT_LEAST(
    at(-106.4, 39.1), 3000.0, "height of the Sawatch Range, m", "a mean over samples 9 km apart");
  EXPECT_EQ(at(-94.0, 27.0), 0.0) << "the Gulf of Mexico";
  EXPECT_FALSE(all.At(10.0, 50.0)) << "far from all radars";
}

// By hand, for light from the west at 45°: Lambert's cosine of a slope of 0.02 × 15 = 0.3 that
// faces the light is (sin 45° + 0.3 cos 45°) / √1.09 = 0.8805, of level ground 0.7071.
TEST(Relief, ShadesASlopeWithKnownGradient)
{
  const LightDirection west = {270.0, 45.0};
  const auto shadeOf = [&](double eastwards, double northwards)
  { return ShadeRelief(SlopeOf(eastwards, northwards), west)[12]; };
  EXPECT_NEAR(shadeOf(0.0, 0.0), 0.0, 1e-6);
  EXPECT_NEAR(shadeOf(20.0, 0.0), std::tanh(3.0 * (0.88046 - 0.70711)), 1e-3);
  EXPECT_LT(shadeOf(-20.0, 0.0), -0.4) << "it faces away";
  EXPECT_NEAR(shadeOf(0.0, 20.0), shadeOf(0.0, -20.0), 1e-6) << "across the light";
  const auto all = ShadeRelief(SlopeOf(20.0, 0.0), west);
  EXPECT_NEAR(all.front(), all[12], 1e-6) << "the edge has the slope of its inner side";
}

TEST(MapAreas, LaterOnesLieOverEarlierOnes)
{
  const SceneFrame frame = FrameAt(-97.0, 35.0);
  const auto square = [](bool land, double reach)
  {
    return MapPolyline{land, {{-97.0 - reach, 35.0 - reach}, {-97.0 + reach, 35.0 - reach},
                               {-97.0 + reach, 35.0 + reach}, {-97.0 - reach, 35.0 + reach}}};
  };
  const auto land =
    PaintLand(frame, {square(true, 1.0), square(false, 0.5), square(true, 40.0)}, 40, 20);
  EXPECT_EQ(std::count(land.begin(), land.end(), 1), 800) << "land all over";
  const auto lake = PaintLand(frame, {square(true, 1.0), square(false, 0.5)}, 40, 20);
  EXPECT_EQ(lake[10 * 40 + 20], 0) << "the lake in the middle";
  EXPECT_EQ(lake[10 * 40 + 13], 1) << "70 km west of it: the lake ends at 46 km, land at 91 km";
  EXPECT_EQ(lake[10 * 40 + 9], 0) << "110 km west of it";
  const double part = std::count(lake.begin(), lake.end(), 1) / 800.0;
  // 2° × 2° less 1° × 1°, at 111 km × 91 km a degree, of 400 km × 400 km.
  EXPECT_WITHIN(part, 3.0 * 110.9 * 91.3 / 160'000.0, 0.02, "land, part of the domain");
}

TEST(MapAreas, TellWaterFromLandAtKnownPlaces)
{
  EXPECT_FALSE(IsLand(-87.0, 42.5)) << "Lake Michigan";
  EXPECT_FALSE(IsLand(-81.0, 45.2)) << "Georgian Bay, in Canada";
  EXPECT_FALSE(IsLand(-112.5, 41.2)) << "Great Salt Lake";
  EXPECT_FALSE(IsLand(-96.0, 27.5)) << "Gulf of Mexico";
  EXPECT_FALSE(IsLand(-123.5, 48.3)) << "Strait of Juan de Fuca";
  EXPECT_FALSE(IsLand(144.0, 13.0)) << "the Pacific west of Guam";
  EXPECT_TRUE(IsLand(144.83, 13.45)) << "Guam";
  EXPECT_TRUE(IsLand(-87.7, 41.85)) << "Chicago";
  EXPECT_TRUE(IsLand(-97.5, 35.5)) << "Oklahoma City";
  EXPECT_TRUE(IsLand(-79.5, 43.8)) << "north of Toronto";
  // The border with Mexico, where us-atlas and world-atlas leave gaps between each other.
  EXPECT_TRUE(IsLand(-116.0, 32.62));
}

TEST(GroundPicture, HasLandAndWater)
{
  const auto picture = MakeGroundPicture(FrameAt(-87.5, 42.0), theme);
  const int* size = picture->GetDimensions();
  EXPECT_EQ(size[0], 1024);
  EXPECT_EQ(size[1], 1024);
  // 60 km north of the middle of the domain is the lake, 100 km west of it Illinois.
  EXPECT_EQ(ColourAt(picture, 540, 512 + 154), BytesOf(theme.water));
  const auto land = ColourAt(picture, 512 - 256, 512);
  EXPECT_WITHIN(land[0], BytesOf(theme.ground)[0], 12, "brightness of a plain, of 255");
}

TEST(GroundPicture, IsPlainWithoutData)
{
  const auto picture = MakeGroundPicture(FrameAt(10.0, 50.0), theme);
  EXPECT_EQ(picture->GetNumberOfPoints(), 4);
  EXPECT_EQ(ColourAt(picture, 0, 0), BytesOf(theme.ground));
}

// A light volume of 2 × 1 texels over a picture of 4 × 1: no light in the west, all in the east.
TEST(GroundShadow, DarkensThePictureOfTheGround)
{
  const auto makeImage = [](std::array<int, 2> size, int type, int components)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(size[0], size[1], 1);
    image->AllocateScalars(type, components);
    return image;
  };
  const auto picture = makeImage({4, 2}, VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(picture->GetScalarPointer()), 24, 200);
  const auto light = makeImage({2, 2}, VTK_FLOAT, 2);
  const std::array<float, 8> arriving = {0, 1, 1, 1, 0, 1, 1, 1};
  std::copy(arriving.begin(), arriving.end(), static_cast<float*>(light->GetScalarPointer()));
  vtkNew<vtkActor> ground;
  vtkNew<vtkTexture> own;
  own->SetInputData(picture);
  ground->SetTexture(own);
  LightOptions options;
  options.shadow = 0.5;
  GroundShadow shadow;
  shadow.Show(ground, light, options, light);
  ASSERT_NE(ground->GetTexture(), own.Get());
  vtkImageData* shown = ground->GetTexture()->GetInput();
  EXPECT_EQ(ColourAt(shown, 0, 0)[0], 100);
  EXPECT_EQ(ColourAt(shown, 1, 1)[0], 125) << "a quarter of the way between the texels";
  EXPECT_EQ(ColourAt(shown, 3, 1)[2], 200);
  light->GetPointData()->GetScalars()->Fill(1.0);
  light->Modified();
  shadow.Show(ground, light, options, light, true);
  EXPECT_EQ(ColourAt(shown, 0, 0)[0], 100) << "the shadow stays while the user drags";
  shadow.Show(ground, light, options, light);
  EXPECT_EQ(ColourAt(shown, 0, 0)[0], 200);
  shadow.Show(ground, nullptr, options, light);
  EXPECT_EQ(ground->GetTexture(), own.Get());
}

TEST(Towns, AreSortedBySize)
{
  const auto& towns = EmbeddedTowns();
  const auto placeOf = [&](const std::string& name)
  {
    return std::find_if(
             towns.begin(), towns.end(), [&](const MapName& town) { return town.name == name; }) -
           towns.begin();
  };
  EXPECT_AT_LEAST(towns.size(), 1'000U, "towns of the embedded map");
  EXPECT_LT(placeOf("Chicago"), placeOf("Oklahoma City"));
  EXPECT_LT(placeOf("Oklahoma City"), placeOf("Norman"));
  EXPECT_LT(placeOf("Norman"), static_cast<long>(towns.size()));
}

// Of towns too near to each other the largest has its name; that of a radar keeps none away.
TEST(Towns, StandApart)
{
  const SceneFrame frame = FrameAt(-97.3, 35.3);
  const auto labels = MakeMapLayer(frame, {{"KTLX"}, 0.0, false}, 16, theme).labels;
  ASSERT_GT(labels.size(), 8U);
  const auto city = std::find_if(
    labels.begin(), labels.end(), [](const Label& label) { return label.text == "Oklahoma City"; });
  ASSERT_NE(city, labels.end());
  vtkNew<vtkCamera> camera;
  PointCamera(camera, {180.0, 90.0, 1.0, true}, {-200.0, 200.0, -200.0, 200.0, 0.0, 0.0}, 1.0, {});
  TextPictures pictures;
  const std::array<int, 2> size = {800, 800};
  const auto& box = frame.Bounds();
  const std::array<ScenePoint, 4> ground = {ScenePoint{box[0], box[2], 0.0},
    ScenePoint{box[1], box[2], 0.0}, ScenePoint{box[1], box[3], 0.0},
    ScenePoint{box[0], box[3], 0.0}};
  const auto sides = ChooseSides(labels, ground, Projection(camera, size), pictures, {});
  EXPECT_TRUE(sides[0]) << "the radar";
  EXPECT_TRUE(sides[static_cast<std::size_t>(city - labels.begin())]) << "30 km from the radar";
  std::vector<std::array<double, 2>> shown;
  for (std::size_t i = 1; i < labels.size(); ++i)
  {
    EXPECT_TRUE(labels[i].optional);
    if (sides[i])
    {
      shown.push_back(Projection(camera, size)(labels[i].point));
    }
  }
  EXPECT_GE(shown.size(), 4U);
  EXPECT_LE(shown.size(), 14U);
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      EXPECT_GT(std::hypot(shown[i][0] - shown[k][0], shown[i][1] - shown[k][1]), 60.0);
    }
  }
}

// Of many radars those that are named when the picture has room for a name each so many kilometres
// are farther apart than that; the one in the middle always is.
TEST(MapLayer, NamesOfManyRadarsThinOut)
{
  const SceneFrame frame = FrameAt(-97.0, 38.0, 100'000.0);
  std::vector<std::string> many;
  for (const KnownSite& site : KnownSites())
  {
    const auto place = frame.Place(site.position.longitude, site.position.latitude);
    if (IsWithin(place, Rectangle(frame)))
    {
      many.push_back(site.name);
    }
  }
  ASSERT_GT(many.size(), 16U);
  const std::vector<std::string> few(many.begin(), many.begin() + 16);
  const auto namesOf = [&](const std::vector<std::string>& sites)
  {
    std::vector<Label> names = MakeMapLayer(frame, {sites, 0.0, false}, 16, theme).labels;
    names.erase(
      std::remove_if(names.begin(), names.end(), [](const Label& label) { return label.optional; }),
      names.end());
    return names;
  };
  for (const Label& label : namesOf(few))
  {
    EXPECT_EQ(label.spread, 0.0) << label.text << " is always named";
  }
  const std::vector<Label> labels = namesOf(many);
  ASSERT_EQ(labels.size(), many.size());
  std::size_t always = 0;
  for (const Label& a : labels)
  {
    EXPECT_GT(a.spread, 0.0);
    always += a.spread >= 1e6 ? 1 : 0;
    for (const Label& b : labels)
    {
      const double apart = std::hypot(a.point[0] - b.point[0], a.point[1] - b.point[1]);
      EXPECT_TRUE(&a == &b || apart >= std::min(a.spread, b.spread) - 1e-9) << a.text << b.text;
    }
  }
  EXPECT_EQ(always, 1U);
}
