// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Captions/Captions.h"

#include "vtkNexradVoxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

namespace nexrad::scene
{
namespace
{

constexpr double binSeconds = 10.0;
constexpr std::size_t bins = 1080; // 3 h; older data count as that old

// How many voxels have which age.
using Histogram = std::array<vtkIdType, bins>;

std::optional<double> MedianMinutes(const Histogram& histogram)
{
  const vtkIdType count = std::accumulate(histogram.begin(), histogram.end(), vtkIdType(0));
  vtkIdType below = 0;
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    below += histogram[bin];
    if (count > 0 && 2 * below >= count)
    {
      return (static_cast<double>(bin) + 0.5) * binSeconds / 60.0;
    }
  }
  return std::nullopt;
}

} // namespace

std::vector<std::optional<double>> AgesOfData(
  vtkImageData* volume, const std::string& array, std::size_t sites)
{
  vtkPointData* points = volume->GetPointData();
  const vtkIdType count = volume->GetNumberOfPoints();
  const float* age = vtkNexradFindValues<vtkFloatArray>(points, array + "_age", count);
  const unsigned char* radars =
    vtkNexradFindValues<vtkUnsignedCharArray>(points, array + "_radars", count);
  const unsigned char* site =
    vtkNexradFindValues<vtkUnsignedCharArray>(points, array + "_site", count);
  const auto voxels = vtkNexradVoxels::Find(volume, array);
  const bool one = sites == 1;
  if (age == nullptr || !voxels || (!one && (radars == nullptr || site == nullptr)))
  {
    return {};
  }
  std::vector<Histogram> histograms(sites, Histogram{});
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::size_t which = one ? 0 : site[i];
    if (IsMeasured(voxels->State(static_cast<std::size_t>(i))) && which < sites &&
        (one || radars[i] == 1))
    {
      const auto bin = static_cast<std::size_t>(std::max(0.0F, age[i]) / binSeconds);
      ++histograms[which][std::min(bin, bins - 1)];
    }
  }
  std::vector<std::optional<double>> ages;
  std::transform(histograms.begin(), histograms.end(), std::back_inserter(ages), MedianMinutes);
  return ages;
}

namespace
{

constexpr char warningWord[] = "SYNTHETIC";

// Breaks words into lines of a width in pixels.
std::string Wrap(const std::vector<std::string>& words, double width, const TextStyle& style,
  TextPictures& pictures)
{
  std::string text;
  std::string line;
  for (const std::string& word : words)
  {
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && pictures.Get(longer, style).Size()[0] > width)
    {
      text += line + "\n";
      line = word;
    }
    else
    {
      line = longer;
    }
  }
  return text + line;
}

std::vector<std::string> WordsOf(const std::string& text)
{
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin < text.size())
  {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

// Says more behind the radars.
void AddPhrase(const std::string& phrase, std::vector<std::string>& words)
{
  if (!words.empty())
  {
    words.back() += ";";
    const std::vector<std::string> more = WordsOf(phrase);
    words.insert(words.end(), more.begin(), more.end());
  }
}

// Puts captions into a picture, each beside a point in pixels.
class Writer
{
public:
  Writer(const std::array<int, 2>& pictureSize, TextPictures& textPictures)
    : size(pictureSize)
    , pictures(textPictures)
  {
  }

  PixelBox Add(const std::string& text, const TextStyle& style, const std::array<double, 2>& point,
    LabelSide side)
  {
    const PixelBox box = this->Put(text, style, point, side);
    PixelBox taken = box;
    const double eighth = size[0] / 8.0;
    const bool centred = side == LabelSide::Below;
    taken.right =
      centred ? box.right : box.left + eighth * std::ceil((box.right - box.left) / eighth);
    layer.taken.push_back(taken);
    return box;
  }

  // Above the middle of what is left of the colour bar, over the scene, which need not stay off it.
  // What a semicolon ends has lines of its own.
  void AddInTheMiddle(const std::string& text, double right, const TextStyle& style)
  {
    std::string lines;
    for (std::size_t begin = 0; begin < text.size();)
    {
      const std::size_t end = std::min(text.find("; ", begin), text.size());
      const std::string part = text.substr(begin, end - begin);
      lines += (lines.empty() ? "" : "\n") + Wrap(WordsOf(part), 0.8 * right, style, pictures);
      begin = end + 2;
    }
    layer.overScene = this->Put(lines, style, {0.5 * right, 0.6 * size[1]}, LabelSide::Below);
  }

  CaptionLayer layer;

private:
  PixelBox Put(const std::string& text, const TextStyle& style, const std::array<double, 2>& point,
    LabelSide side)
  {
    const TextPicture& picture = pictures.Get(text, style);
    layer.props.push_back(picture.MakeCaption({point[0] / size[0], point[1] / size[1]}, side));
    return picture.BoxAt(point, side, 0.0);
  }

  std::array<int, 2> size;
  TextPictures& pictures;
};

} // namespace

std::string TimeText(const VolumeInformation& information)
{
  if (!information.time)
  {
    return "time unknown";
  }
  std::string text = FormatIso8601(*information.time).substr(0, 19);
  text[10] = ' ';
  return text + " UTC";
}

constexpr std::size_t mostNamed = 16;

std::string NameSites(const std::vector<std::string>& sites)
{
  if (sites.size() > mostNamed)
  {
    return std::to_string(sites.size()) + " radars";
  }
  std::string names;
  for (const std::string& site : sites)
  {
    names += (names.empty() ? "" : " ") + site;
  }
  return names;
}

namespace
{

std::string MinutesText(double age)
{
  const long minutes = std::lround(age);
  return minutes < 1 ? std::string("< 1") : std::to_string(minutes);
}

// Of many radars.
std::vector<std::string> SummaryOf(
  const std::string& radars, const std::vector<std::optional<double>>& ages)
{
  std::vector<double> known;
  for (const std::optional<double>& age : ages)
  {
    if (age)
    {
      known.push_back(*age);
    }
  }
  if (known.empty())
  {
    return WordsOf(radars);
  }
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  return WordsOf(
    radars + ", age of the data: " + MinutesText(*least) + " to " + MinutesText(*most) + " min");
}

std::vector<std::string> WordsOfSites(const CaptionTexts& texts)
{
  const auto& sites = texts.information.sites;
  if (sites.size() > mostNamed)
  {
    return SummaryOf(NameSites(sites), texts.ages);
  }
  std::vector<std::string> words;
  if (!texts.ages.empty())
  {
    words = {"Age", "of", "the", "data:"};
  }
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    std::string word = sites[i];
    if (i < texts.ages.size() && texts.ages[i])
    {
      word += " " + MinutesText(*texts.ages[i]) + " min";
    }
    const bool last = i + 1 == sites.size();
    words.push_back(word + (texts.ages.empty() || last ? "" : ","));
  }
  return words;
}

} // namespace

std::vector<std::string> SiteWords(const CaptionTexts& texts)
{
  std::vector<std::string> words = WordsOfSites(texts);
  const double share = texts.information.biologicalShare;
  if (share > MostlyBiological)
  {
    AddPhrase(
      std::to_string(std::lround(100.0 * share)) + " % of the echo is biological (birds, insects)",
      words);
  }
  for (const std::string& each : texts.information.notes)
  {
    AddPhrase(each, words);
  }
  return words;
}

CaptionLayer MakeCaptions(const CaptionTexts& texts, const std::array<int, 2>& size, double right,
  int textSize, const Theme& theme, TextPictures& pictures)
{
  const TextStyle title = {textSize * 3 / 2, theme.title, theme.rim, true};
  const TextStyle note = {textSize, theme.note, theme.rim};
  const TextStyle warning = {textSize * 5 / 2, theme.warning, theme.rim, true};
  const double left = std::max(0.75 * textSize, 0.02 * size[0]);
  const double top = size[1] - 0.75 * textSize;
  Writer writer(size, pictures);
  const std::string time = TimeText(texts.information);
  const PixelBox timeBox = writer.Add(time, title, {left, top}, LabelSide::BelowRight);
  // The warning stands in the middle, or beside the time; in a narrow picture below the others.
  const double half = 0.5 * pictures.Get(warningWord, warning).Size()[0];
  const double middle = std::max(0.5 * size[0], timeBox.right + left + half);
  const bool above = texts.information.synthetic && middle + half < right;
  const double width = (above ? middle - half : right) - 2.0 * left;
  const auto& method = texts.information.method;
  std::string lines = Wrap(
    WordsOf(texts.title + (method.empty() ? "" : ", method " + method)), width, note, pictures);
  lines += "\n" + Wrap(SiteWords(texts), width, note, pictures);
  const PixelBox lineBox =
    writer.Add(lines, note, {left, timeBox.bottom - 0.4 * textSize}, LabelSide::BelowRight);
  writer.Add(Wrap(WordsOf(texts.note), right - 2.0 * left, note, pictures), note,
    {left, 0.75 * textSize}, LabelSide::AboveRight);
  if (!texts.nothing.empty())
  {
    writer.AddInTheMiddle(texts.nothing, right, title);
  }
  if (above)
  {
    writer.Add(warningWord, warning, {middle, top}, LabelSide::Below);
  }
  else if (texts.information.synthetic)
  {
    writer.Add(
      warningWord, warning, {left, lineBox.bottom - 0.3 * textSize}, LabelSide::BelowRight);
  }
  return writer.layer;
}

} // namespace nexrad::scene
