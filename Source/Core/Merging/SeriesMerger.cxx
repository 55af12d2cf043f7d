// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/SeriesMerger.h"

#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/SharedScan.h"
#include "nexrad/System/Error.h"
#include "nexrad/Thesis/ThesisGeometry.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace nexrad
{

namespace
{

// An input that is damaged throughout, or holds metadata alone, explains why there is nothing to
// merge.
std::string ExplainNothing(const SeriesScan& scan)
{
  const std::size_t reasons = scan.problems.empty() ? scan.notes.size() : scan.problems.size();
  if (reasons == 0)
  {
    return {};
  }
  return ": " + (scan.problems.empty() ? scan.notes.front() : scan.problems.front().Line()) +
         (reasons > 1 ? " (and " + std::to_string(reasons - 1) + " more)" : "");
}

// When the files' volumes began, as their headers say.
std::vector<TimeSpan> HeaderTimes(const std::vector<SiteFileList>& headers)
{
  std::vector<TimeSpan> times;
  for (const SiteFileList& site : headers)
  {
    for (const TimedFile& file : site.files)
    {
      times.push_back({file.time, file.time});
    }
  }
  return times;
}

// What the first of some files that holds a volume holds; empty when none does.
template <class Iterator>
std::vector<std::pair<Site, SeriesVolume>> FindVolumes(
  Iterator begin, Iterator end, VolumeLoader& loader)
{
  for (Iterator file = begin; file != end; ++file)
  {
    ScannedFile scanned = loader.Scan(file->index);
    if (!scanned.volumes.empty())
    {
      return std::move(scanned.volumes);
    }
  }
  return {};
}

std::vector<ReadyVolume> OfRadar(const std::vector<ReadyVolume>& volumes, const std::string& name)
{
  std::vector<ReadyVolume> own;
  std::copy_if(volumes.begin(), volumes.end(), std::back_inserter(own),
    [&name](const ReadyVolume& volume) { return volume.RadarName() == name; });
  return own;
}

SeriesOptions OneThreadAFile(SeriesOptions series)
{
  series.level2.threads = 1;
  return series;
}

// What the volumes that some time takes have near the ground.
LowEchoes LowEchoesAt(
  const std::vector<Time>& times, const VolumeRule& rule, const Catalogue& catalogue)
{
  std::set<std::pair<std::size_t, const SeriesVolume*>> taken; // by radar and start
  for (const Time time : times)
  {
    for (const auto& [moment, site, volume] : catalogue.ChosenAt(time, rule, {MomentName::REF}))
    {
      taken.emplace(site, volume);
    }
  }
  LowEchoes echoes;
  for (const auto& [site, volume] : taken)
  {
    if (volume->lowEcho)
    {
      echoes.push_back(volume->lowEcho);
    }
  }
  return echoes;
}

LowEchoes AllLowEchoes(const Catalogue& catalogue)
{
  LowEchoes echoes;
  for (const SiteSeries& series : catalogue.sites)
  {
    for (const SeriesVolume& volume : series.volumes)
    {
      if (volume.lowEcho)
      {
        echoes.push_back(volume.lowEcho);
      }
    }
  }
  return echoes;
}

} // namespace

/// Where the radars are, and when they scanned.
struct SeriesMerger::Extent
{
  std::vector<Site> sites;
  Time first = Time::max();
  Time last = Time::min();
  double range = DefaultRange; ///< m, of a radar that is alone
  std::size_t volumes = 2;     ///< 1, or more
};

/// The merges' request, whose grid becomes known while files are being decoded.
class SeriesMerger::SharedRequest
{
public:
  explicit SharedRequest(const MergeRequest& theRequest)
    : request(theRequest)
  {
    request.beam.means = false; // until the grid is known; the merge makes what is missing
  }

  void Set(const MergeRequest& known)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    request = known;
  }

  MergeRequest Get() const
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return request;
  }

private:
  mutable std::mutex mutex;
  MergeRequest request;
};

SeriesMerger::SeriesMerger(std::vector<std::filesystem::path> theInputs,
  const MergeOptions& theOptions, MergerSetup theSetup)
  : inputs(std::move(theInputs))
  , setup(std::move(theSetup))
  , options(theOptions)
{
}

SeriesMerger::~SeriesMerger() = default;

bool SeriesMerger::Open(const Progress& progress)
{
  this->FindFiles();
  return this->Begin(progress);
}

bool SeriesMerger::SetOptions(const MergeOptions& theOptions, const Progress& progress)
{
  options = theOptions;
  return this->Begin(progress);
}

bool SeriesMerger::Begin(const Progress& progress)
{
  if (scan)
  {
    setup.processes.Together([&] { this->PlanByScan(); });
    return true;
  }
  bool opened = false;
  setup.processes.Together([&] { opened = !setup.scanFirst && this->OpenByHeaders(); });
  return setup.processes.InAll(opened) || this->Scan(progress);
}

void SeriesMerger::FindFiles()
{
  setup.processes.Together(
    [&]
    {
      SeriesOptionsOf(options); // throws for what cannot be met, before anything is read
      found = FindInputFiles(inputs);
      headers = ListByHeaders(found.paths, options.siteName);
      sizes = SizesOf(found.paths, headers ? headers->size() : 1);
      const MemoryNeed need =
        RequireMemory(options, sizes, setup.threads, setup.use, KnownPlaces(headers));
      memoryForRays = MemoryForKeptRays(options, need);
      cache = setup.anyOrder ? std::make_shared<PolarCache>(memoryForRays) : nullptr;
    });
  std::string names = headers ? "told by headers" : "unknown";
  for (const std::filesystem::path& path : found.paths)
  {
    names += '\n' + path.filename().string();
  }
  const std::vector<std::string> all = setup.processes.Exchange(names);
  if (std::any_of(all.begin(), all.end(), [&](const std::string& other) { return other != names; }))
  {
    throw Error("the processes do not find the same input files; all need the same folders");
  }
}

void SeriesMerger::RequireMemoryOfGrid() const
{
  RequireMemory(options, sizes, setup.threads, setup.use, request.grid, positions);
}

// Whether there may be several; true as long as the headers do not tell.
bool SeriesMerger::HasSeveralRadars() const
{
  return !headers || headers->size() > 1;
}

SeriesOptions SeriesMerger::ScanOptions() const
{
  SeriesOptions series = SeriesOptionsOf(options);
  series.level2.freeBytes = FreeBytesOfAFile(options, setup.threads);
  series.lowEchoes = (options.compareRadars || options.measureBiases) && this->HasSeveralRadars();
  return series;
}

SeriesFiles SeriesMerger::FilesByHeaders() const
{
  return {found.paths, *headers, loader ? loader->Known() : std::vector<ScannedFile>()};
}

SeriesFiles SeriesMerger::FilesByScan() const
{
  SeriesFiles files{found.paths, {}, {}};
  files.known.resize(found.paths.size());
  for (const SiteSeries& series : scan->sites)
  {
    SiteFileList site{series.site.name, {}};
    for (const SeriesVolume& volume : series.volumes)
    {
      std::vector<std::pair<Site, SeriesVolume>>& known = files.known[volume.input].volumes;
      if (known.empty())
      {
        site.files.push_back({volume.input, volume.start});
      }
      known.emplace_back(series.site, volume);
    }
    files.sites.push_back(std::move(site));
  }
  return files;
}

void SeriesMerger::MakeLoader(SeriesFiles files)
{
  LoaderWork work;
  work.prepare = [shared = planned](const std::shared_ptr<const PolarVolume>& volume)
  { return MakeReady(volume, shared->Get()); };
  work.rule = VolumeRuleOf(request);
  decodedBefore += loader ? loader->DecodedFiles() : 0;
  follower = nullptr;
  loader = std::make_unique<VolumeLoader>(
    std::move(files), OneThreadAFile(this->ScanOptions()), work, cache, setup.threads);
}

// From one file of each site or two. Empty when a site has none that can be used.
std::optional<SeriesMerger::Extent> SeriesMerger::FindExtent()
{
  const bool needsLast = setup.anyOrder || !options.end || options.time;
  for (const SiteFileList& site : *headers)
  {
    loader->Expect(site.files.front().index);
    if (needsLast)
    {
      loader->Expect(site.files.back().index);
    }
  }
  Extent extent;
  for (const SiteFileList& site : *headers)
  {
    // A scan takes the position that the first of the inputs gives.
    std::vector<TimedFile> asGiven = site.files;
    std::sort(asGiven.begin(), asGiven.end(),
      [](const TimedFile& a, const TimedFile& b) { return a.index < b.index; });
    const auto known = FindVolumes(asGiven.begin(), asGiven.end(), *loader);
    if (known.empty())
    {
      return std::nullopt;
    }
    extent.sites.push_back(known.front().first);
    const auto earliest = FindVolumes(site.files.begin(), site.files.end(), *loader);
    extent.range = RangeOf(earliest.front().first, earliest.front().second);
    for (const auto& [of, volume] : earliest)
    {
      extent.first = std::min(extent.first, volume.start);
    }
    if (needsLast)
    {
      for (const auto& [of, volume] : FindVolumes(site.files.rbegin(), site.files.rend(), *loader))
      {
        extent.last = std::max(extent.last, volume.end);
      }
    }
  }
  const bool alone = headers->size() == 1 && headers->front().files.size() == 1;
  extent.volumes = alone ? loader->Scan(headers->front().files.front().index).volumes.size() : 2;
  return extent;
}

// False when the rays of these files say otherwise than the headers; then all files must be
// scanned.
bool SeriesMerger::OpenByHeaders()
{
  if (!headers || FindPause(options, HeaderTimes(*headers)))
  {
    return false; // whether it is so, all rays must tell
  }
  if (options.measureBiases && this->HasSeveralRadars())
  {
    return false; // all volumes tell the biases
  }
  request = MergeRequestOf(options, setup.loop);
  planned = std::make_shared<SharedRequest>(request);
  this->MakeLoader(this->FilesByHeaders());
  const std::optional<Extent> extent = this->FindExtent();
  if (!extent || options.begin.value_or(extent->first) > options.end.value_or(extent->last) ||
      (options.time && (*options.time < extent->first || *options.time > extent->last)))
  {
    return false;
  }
  this->Plan(*extent);
  times = TimeStepsOf(options, extent->first, extent->last, extent->volumes);
  return true;
}

void SeriesMerger::Plan(const Extent& extent)
{
  sites.clear();
  positions.clear();
  for (const Site& site : extent.sites)
  {
    sites.push_back(site.name);
    positions.push_back(*site.position);
  }
  this->FindBiases();
  request.grid = GridOf(options, positions, extent.sites.size() == 1 ? extent.range : DefaultRange);
  this->RequireMemoryOfGrid();
  planned->Set(request);
  rays = {extent.first, extent.last};
}

bool SeriesMerger::ScanFiles(const Progress& progress)
{
  if (!cache)
  {
    cache = std::make_shared<PolarCache>(memoryForRays);
  }
  SeriesOptions series = this->ScanOptions();
  series.threads = setup.threads;
  series.summaries = setup.scanFirst;
  const auto keep = [this](const SeriesVolume& key, const RadarVolume&,
                      const std::shared_ptr<const PolarVolume>& volume) {
    cache->Offer({volume->moment, key.cycle, key.file}, volume, MemoryOf(*volume));
  };
  const auto files =
    ScanTogether(found.paths, setup.processes, setup.order, series, keep, progress);
  scan = files ? std::optional(CollectSeries(found.problems, *files)) : std::nullopt;
  return scan.has_value();
}

bool SeriesMerger::Scan(const Progress& progress)
{
  if (!this->ScanFiles(progress))
  {
    return false;
  }
  setup.processes.Together([&] { this->PlanByScan(); });
  return true;
}

void SeriesMerger::PlanByScan()
{
  if (scan->sites.empty())
  {
    throw InputError("no input holds a volume that can be used" + ExplainNothing(*scan), false);
  }
  request = MergeRequestOf(options, setup.loop);
  planned = std::make_shared<SharedRequest>(request);
  Extent extent;
  for (const SiteSeries& series : scan->sites)
  {
    extent.sites.push_back(series.site);
  }
  extent.first = *scan->First();
  extent.last = *scan->Last();
  extent.range = scan->Range();
  this->Plan(extent);
  this->MakeLoader(this->FilesByScan());
  times = TimeStepsOf(options, *scan);
}

// Those that are taken off, once the radars are known.
void SeriesMerger::FindBiases()
{
  if (options.measureBiases)
  {
    request.beam.biases = this->CompareRadars().biases;
  }
  RequireRadars(request.beam.biases, sites);
}

BiasReport SeriesMerger::CompareRadars() const
{
  return nexrad::CompareRadars(
    scan ? AllLowEchoes(*scan) : LowEchoesAt(times, VolumeRuleOf(request), this->KnownScan()));
}

std::vector<InputProblem> SeriesMerger::Problems() const
{
  return this->KnownScan().problems;
}

std::vector<std::string> SeriesMerger::Notes() const
{
  return request.method == MergeMethod::Beam ? this->KnownScan().notes : std::vector<std::string>();
}

std::optional<ReasonCounts> SeriesMerger::Echo() const
{
  std::optional<ReasonCounts> all;
  for (const SiteSeries& series : this->Gather().sites)
  {
    for (const SeriesVolume& volume : series.volumes)
    {
      if (volume.echo)
      {
        all = all.value_or(ReasonCounts{});
        std::transform(
          volume.echo->begin(), volume.echo->end(), all->begin(), all->begin(), std::plus<>());
      }
    }
  }
  return all;
}

std::vector<MomentName> SeriesMerger::Moments() const
{
  const SeriesScan known = scan ? *scan : CollectSeries(found.problems, loader->Known());
  std::set<MomentName> moments;
  for (const SiteSeries& series : known.sites)
  {
    for (const SeriesVolume& volume : series.volumes)
    {
      moments.insert(volume.moments.begin(), volume.moments.end());
    }
  }
  return {moments.begin(), moments.end()};
}

std::size_t SeriesMerger::DecodedFiles() const
{
  return decodedBefore + (loader ? loader->DecodedFiles() : 0);
}

void SeriesMerger::EndAt(Time time)
{
  loader->EndAt(time);
}

// Of all volumes, those that a time takes.
std::vector<ChosenVolume> SeriesMerger::ChosenAt(Time time) const
{
  return scan->ChosenAt(time, VolumeRuleOf(request), options.Moments());
}

// Of radars whose summaries tell how far they see, those that see the block, in the order of the
// scan; empty: all.
std::vector<bool> SeriesMerger::FindReaching()
{
  if (!scan || !setup.scanFirst || !request.block)
  {
    return {};
  }
  std::vector<SiteReach> reaches;
  for (const SiteSeries& series : scan->sites)
  {
    reaches.push_back({*series.site.position, 0.0});
  }
  for (const auto& [moment, site, volume] : this->ChosenAt(request.time))
  {
    reaches[site].reach = std::max(reaches[site].reach, volume->summary->reach);
  }
  if (request.method == MergeMethod::Beam)
  {
    return run.MergerFor(request).FindReaching(reaches, request.loop);
  }
  std::vector<bool> reaching;
  for (const SiteReach& each : reaches)
  {
    reaching.push_back(ThesisMayReach(request.grid, *request.block, each.position, each.reach));
  }
  return reaching;
}

// The volumes of the other radars.
void SeriesMerger::AddSweepless(
  const std::vector<bool>& reaching, std::vector<ReadyVolume>& volumes)
{
  if (reaching.empty())
  {
    return;
  }
  for (const auto& [moment, site, volume] : this->ChosenAt(request.time))
  {
    if (!reaching[site])
    {
      volumes.push_back(sweepless.Make(scan->sites[site].site, *volume, request, moment));
    }
  }
}

// Empty when `progress` asked to stop.
std::optional<std::vector<ReadyVolume>> SeriesMerger::VolumesAbout(
  Time time, const std::vector<bool>& reaching, const Progress& progress)
{
  std::optional<std::vector<ReadyVolume>> volumes = loader->About(time, reaching, progress);
  if (volumes && setup.anyOrder && !scan && loader->HeadersErr())
  {
    if (!this->ScanFiles(progress))
    {
      return std::nullopt;
    }
    // Grid and time steps stay as they were told: the volumes of a series have one grid, and its
    // user counts them.
    this->MakeLoader(this->FilesByScan());
    volumes = loader->About(time, reaching, progress);
  }
  if (volumes && setup.anyOrder)
  {
    sweepless.Remember(*volumes);
  }
  return volumes;
}

std::optional<GriddedVolume> SeriesMerger::Merge(
  Time time, const Progress& progress, const std::optional<VoxelBlock>& block, GriddedVolume memory)
{
  request.time = time;
  request.block = block;
  const std::vector<bool> reaching = this->FindReaching();
  std::optional<std::vector<ReadyVolume>> volumes = this->VolumesAbout(time, reaching, progress);
  if (!volumes)
  {
    return std::nullopt;
  }
  this->AddSweepless(reaching, *volumes);
  return MergeMoments(*volumes, options.Moments(), request, progress, run, std::move(memory));
}

std::optional<std::size_t> SeriesMerger::MergeEachRadar(
  Time time, const std::function<void(GriddedVolume)>& take, const Progress& progress)
{
  request.time = time;
  request.block = std::nullopt;
  const std::optional<std::vector<ReadyVolume>> volumes = this->VolumesAbout(time, {}, progress);
  if (!volumes)
  {
    return std::nullopt;
  }
  radarRuns.resize(sites.size());
  std::size_t present = 0;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const std::vector<ReadyVolume> own = OfRadar(*volumes, sites[i]);
    present += own.empty() ? 0 : 1;
    std::optional<GriddedVolume> merged = MergeMoments(
      own, options.Moments(), request, ShareOf(progress, i, sites.size()), radarRuns[i], {});
    if (!merged)
    {
      return std::nullopt;
    }
    merged->sites = {sites[i]};
    merged->sitePositions = {positions[i]};
    merged->ofOneRadar = true;
    for (GriddedVolume& further : merged->further)
    {
      further.sites = merged->sites;
      further.sitePositions = merged->sitePositions;
      further.ofOneRadar = true;
    }
    take(std::move(*merged));
  }
  return present;
}

std::optional<std::size_t> SeriesMerger::Skip(Time time, const Progress& progress)
{
  if (const auto count = loader->CountAbout(time))
  {
    return count;
  }
  const auto volumes = loader->About(time, {}, progress);
  return volumes ? std::optional(volumes->size()) : std::nullopt;
}

void SeriesMerger::LearnFiles(const std::vector<ScannedFile>& files)
{
  if (files.size() != found.paths.size())
  {
    throw Error("these are descriptions of " + std::to_string(files.size()) + " files, not of " +
                std::to_string(found.paths.size()));
  }
  loader->Learn(files);
}

// Those of reflectivity about a time, without sweeps; empty when `progress` asked to stop.
std::optional<BeamVolumes> SeriesMerger::EchoAbout(Time time, const Progress& progress)
{
  const auto find = [&]() -> std::optional<BeamVolumes>
  {
    const auto known = loader->KnownAbout(time, MomentName::REF);
    BeamVolumes kept = known ? sweepless.Find(*known) : BeamVolumes();
    return known && kept.size() == known->size() ? std::optional(std::move(kept)) : std::nullopt;
  };
  if (auto kept = find())
  {
    return kept;
  }
  const std::optional<std::vector<ReadyVolume>> volumes = this->VolumesAbout(time, {}, progress);
  if (!volumes)
  {
    return std::nullopt;
  }
  sweepless.Remember(*volumes);
  return find().value_or(BeamVolumes());
}

// What merges reflectivity of the same files; nullptr when `progress` asked to stop.
SeriesMerger* SeriesMerger::MergerOfEcho(const Progress& progress)
{
  const std::vector<MomentName> moments = options.Moments();
  if (std::find(moments.begin(), moments.end(), MomentName::REF) != moments.end())
  {
    return this;
  }
  if (!echoMerger)
  {
    MergeOptions ofEcho = options;
    ofEcho.moment = MomentName::REF;
    ofEcho.furtherMoments.clear();
    ofEcho.measureBiases = false; // biases do not change where echo moves
    auto merger = std::make_unique<SeriesMerger>(inputs, ofEcho, setup);
    if (!merger->Open(progress))
    {
      return nullptr;
    }
    echoMerger = std::move(merger);
  }
  return echoMerger.get();
}

// How far a box has moved; empty when `progress` asked to stop.
std::optional<std::array<double, 2>> SeriesMerger::WayOf(
  const BoxRequest& box, Time time, const Progress& progress)
{
  if (!box.followedFrom)
  {
    return std::array<double, 2>{0.0, 0.0};
  }
  const std::shared_ptr<BoxFollower> own =
    follower
      ? follower
      : std::make_shared<BoxFollower>(request.grid, request.beam.beam, setup.loop, request.motion,
          [this](Time at, const Progress& loading) -> std::optional<BeamVolumes>
          {
            SeriesMerger* merger = this->MergerOfEcho(loading);
            return merger != nullptr ? merger->EchoAbout(at, loading) : std::nullopt;
          });
  follower = own; // held here: it ends when a wrong header is found while it decodes
  return own->WayTo(time, box, progress);
}

std::optional<GriddedVolume> SeriesMerger::MergeBox(
  Time time, const BoxRequest& box, const Progress& progress)
{
  if (request.method == MergeMethod::Thesis)
  {
    throw Error("a box can be merged again by the method beam alone");
  }
  MakeFinerBox(request.grid, box);  // throws before anything is decoded
  constexpr double following = 0.5; // of the work
  const auto moved = this->WayOf(box, time, ShareOf(progress, 0.0, following));
  if (!moved)
  {
    return std::nullopt;
  }
  const FinerBox finer = MakeFinerBox(request.grid, box, *moved);
  MergeRequest asked = request;
  asked.grid = finer.grid;
  asked.block = finer.block;
  asked.time = time;
  const Progress merging = ShareOf(progress, following, 1.0);
  const std::optional<std::vector<ReadyVolume>> volumes = this->VolumesAbout(time, {}, merging);
  return volumes ? MergeMoments(*volumes, options.Moments(), asked, merging, boxRun) : std::nullopt;
}

// What is known of the inputs so far.
SeriesScan SeriesMerger::KnownScan() const
{
  if (scan)
  {
    return *scan;
  }
  return gathered ? *gathered : CollectSeries(found.problems, loader->Known());
}

// What all processes decoded.
SeriesScan SeriesMerger::Gather() const
{
  std::vector<ScannedFile> known = loader->Known();
  if (setup.processes.Count() > 1)
  {
    for (const std::string& message : setup.processes.Exchange(PackScannedFiles(known)))
    {
      std::vector<ScannedFile> part = UnpackScannedFiles(message);
      for (std::size_t i = 0; i < part.size(); ++i)
      {
        if (IsUnknown(known[i]) || (!TellsEcho(known[i]) && TellsEcho(part[i])))
        {
          known[i] = std::move(part[i]);
        }
      }
    }
  }
  return CollectSeries(found.problems, known);
}

bool SeriesMerger::Confirm()
{
  if (scan)
  {
    return true;
  }
  gathered = this->Gather();
  const auto isAsMade = [&](const std::pair<Time, std::string>& step)
  { return step.second == gathered->MadeOf(step.first, VolumeRuleOf(request), options.Moments()); };
  const std::map<Time, std::string>& made = loader->Made();
  const bool asIn = !gathered->sites.empty() && std::all_of(made.begin(), made.end(), isAsMade) &&
                    request.grid == GridOf(options, gathered->Positions(), gathered->Range()) &&
                    !FindPause(options, gathered->Spans()) &&
                    times == TimeStepsOf(options, *gathered);
  return setup.processes.InAll(asIn);
}

} // namespace nexrad
