// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/SeriesMerger.h"

#include "nexrad/Merging/Store.h"
#include "nexrad/System/Error.h"
#include "nexrad/Thesis/ThesisGeometry.h"

#include <algorithm>
#include <atomic>
#include <iterator>
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
std::vector<TimeSpan> HeaderTimes(const FilesByRadar& headers)
{
  std::vector<TimeSpan> times;
  for (const auto& [radar, files] : headers)
  {
    for (const TimedFile& file : files)
    {
      times.push_back({file.time, file.time});
    }
  }
  return times;
}

// What the first of some files that holds a volume holds; empty when none does.
template <class Iterator>
std::vector<std::pair<Site, SeriesVolume>> FindVolumes(Iterator begin, Iterator end, Store& store)
{
  std::vector<std::pair<Site, SeriesVolume>> volumes;
  for (Iterator file = begin; file != end && volumes.empty(); ++file)
  {
    volumes = store.Scan(file->index).volumes;
  }
  return volumes;
}

// What volumes have near the ground: those that some time takes, or all.
LowEchoes LowEchoesOf(
  const Catalogue& catalogue, const std::vector<Time>& times, const VolumeRule& rule, bool all)
{
  std::set<std::pair<std::size_t, const SeriesVolume*>> taken; // by radar and start
  for (const Time time : all ? std::vector<Time>() : times)
  {
    for (const auto& [moment, site, volume] : catalogue.ChosenAt(time, rule, {MomentName::REF}))
    {
      taken.emplace(site, volume);
    }
  }
  LowEchoes echoes;
  for (std::size_t site = 0; site < catalogue.sites.size(); ++site)
  {
    for (const SeriesVolume& volume : catalogue.sites[site].volumes)
    {
      if (volume.lowEcho && (all || taken.count({site, &volume}) > 0))
      {
        echoes.push_back(volume.lowEcho);
      }
    }
  }
  return echoes;
}

} // namespace

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

bool SeriesMerger::KnowPart(std::size_t part, std::size_t parts, const Progress& progress)
{
  this->FindFiles();
  if (!this->BeginByHeaders())
  {
    throw Error("the headers do not tell which files are needed: make these volumes in one run");
  }
  const std::vector<std::size_t> indices = this->FilesByHeaders();
  std::vector<std::filesystem::path> paths;
  for (const std::size_t index : indices)
  {
    paths.push_back(found.paths[index]);
  }
  const std::vector<std::size_t> order = OrderByHeaders(paths, setup.order);
  const auto [begin, end] = Processes(part, parts, {}).Part(order.size());
  std::vector<std::filesystem::path> own;
  for (std::size_t i = begin; i < end; ++i)
  {
    own.push_back(paths[order[i]]);
  }
  SeriesOptions series = this->ScanOptions();
  series.threads = setup.threads;
  series.summaries = true;
  const auto files = ScanEach(own, series, {}, progress);
  for (std::size_t i = begin; files && i < end; ++i)
  {
    store->Learn(indices[order[i]], (*files)[i - begin]);
  }
  return files.has_value();
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
  setup.processes.Together([&] { opened = !setup.scanFirst && this->BeginByHeaders(); });
  if (setup.sharesBlocks && setup.processes.InAll(opened) &&
      !this->KnowTogether(this->EndFiles(), progress))
  {
    return false;
  }
  setup.processes.Together([&] { opened = opened && this->OpenByHeaders(); });
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
      store = std::make_unique<Store>(found.paths, headers.value_or(FilesByRadar()), setup.threads);
      if (setup.anyOrder)
      {
        store->KeepUpTo(memoryForRays);
      }
    });
  std::string names = headers ? "told by headers" : "unknown";
  for (const std::filesystem::path& path : found.paths)
  {
    names += '\n' + path.filename().string();
  }
  setup.processes.RequireSame(
    names, "the processes do not find the same input files; all need the same folders");
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

// Begins to make volumes ready for the request; what was made ready for another is dropped.
void SeriesMerger::BeginStore()
{
  StoreWork work;
  work.options = this->ScanOptions();
  work.options.level2.threads = 1; // several files are decoded at a time
  work.prepare = [this](const std::shared_ptr<const PolarVolume>& volume)
  { return MakeReady(volume, *std::atomic_load(&planned)); };
  work.rule = VolumeRuleOf(request);
  work.summaries = setup.anyOrder || setup.sharesBlocks;
  follower = nullptr;
  store->Begin(std::move(work), this->KnownScan());
}

// Until the grid is known, volumes are made ready without means; the merge makes these.
void SeriesMerger::PlanRequest(bool hasGrid)
{
  auto next = std::make_shared<MergeRequest>(request);
  next->beam.means = next->beam.means && hasGrid;
  std::atomic_store(&planned, std::shared_ptr<const MergeRequest>(std::move(next)));
}

bool SeriesMerger::NeedsLastRay() const
{
  return setup.anyOrder || !options.end || options.time;
}

// The files that FindEnds looks at first.
std::vector<std::size_t> SeriesMerger::EndFiles() const
{
  std::set<std::size_t> ends;
  for (const auto& [radar, files] : *headers)
  {
    ends.insert(files.front().index);
    if (this->NeedsLastRay())
    {
      ends.insert(files.back().index);
    }
  }
  return {ends.begin(), ends.end()};
}

// All files that a merge of the time steps needs, as far as headers tell before any is decoded.
std::vector<std::size_t> SeriesMerger::FilesByHeaders() const
{
  const std::vector<std::size_t> ends = this->EndFiles();
  std::set<std::size_t> needed(ends.begin(), ends.end());
  TimeSpan span = {Time::max(), Time::min()};
  for (const TimeSpan& each : HeaderTimes(*headers))
  {
    span = {std::min(span.first, each.first), std::max(span.last, each.last)};
  }
  for (const Time time : TimeStepsOf(options, span.first, span.last, found.paths.size()))
  {
    const std::vector<std::size_t> about = store->UnknownAbout(time);
    needed.insert(about.begin(), about.end());
  }
  return {needed.begin(), needed.end()};
}

// Decodes the first file of each site, and the last, for the first and the last ray. Empty when a
// site has none that can be used.
std::optional<TimeSpan> SeriesMerger::FindEnds()
{
  for (const std::size_t index : this->EndFiles())
  {
    store->Expect(index);
  }
  TimeSpan ends = {Time::max(), Time::min()};
  for (const auto& [name, files] : *headers)
  {
    // The radar's position is what the first of the inputs gives.
    std::vector<TimedFile> asGiven = files;
    std::sort(asGiven.begin(), asGiven.end(),
      [](const TimedFile& a, const TimedFile& b) { return a.index < b.index; });
    if (FindVolumes(asGiven.begin(), asGiven.end(), *store).empty())
    {
      return std::nullopt;
    }
    for (const auto& [site, volume] : FindVolumes(files.begin(), files.end(), *store))
    {
      ends.first = std::min(ends.first, volume.start);
    }
    for (const auto& [site, volume] :
      FindVolumes(this->NeedsLastRay() ? files.rbegin() : files.rend(), files.rend(), *store))
    {
      ends.last = std::max(ends.last, volume.end);
    }
  }
  return ends;
}

// False when headers do not tell enough; then all files must be scanned.
bool SeriesMerger::BeginByHeaders()
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
  this->PlanRequest(false);
  this->BeginStore();
  for (const std::string& text : setup.known)
  {
    this->LearnFiles(text);
  }
  return true;
}

// False when the rays of the first and the last files say otherwise than the headers.
bool SeriesMerger::OpenByHeaders()
{
  const std::optional<TimeSpan> ends = this->FindEnds();
  if (!ends || options.begin.value_or(ends->first) > options.end.value_or(ends->last) ||
      (options.time && (*options.time < ends->first || *options.time > ends->last)))
  {
    return false;
  }
  const SeriesScan decoded = this->KnownScan();
  this->Plan(decoded, *ends);
  times = TimeStepsOf(options, ends->first, ends->last, decoded.Spans().size());
  return true;
}

// By volumes among which is the first of each site.
void SeriesMerger::Plan(const SeriesScan& decoded, const TimeSpan& ends)
{
  sites.clear();
  for (const SiteSeries& series : decoded.sites)
  {
    sites.push_back(series.site.name);
  }
  positions = decoded.Positions();
  if (options.measureBiases)
  {
    request.beam.biases = this->CompareRadars().biases;
  }
  RequireRadars(request.beam.biases, sites);
  request.grid = GridOf(options, positions, decoded.Range());
  RequireMemory(options, sizes, setup.threads, setup.use, request.grid, positions);
  this->PlanRequest(true);
  rays = ends;
}

bool SeriesMerger::ScanFiles(const Progress& progress)
{
  store->KeepUpTo(memoryForRays);
  SeriesOptions series = this->ScanOptions();
  series.threads = setup.threads;
  series.summaries = setup.scanFirst || setup.sharesBlocks;
  const auto keep = [this](const SeriesVolume& key, const RadarVolume&,
                      const std::shared_ptr<const PolarVolume>& volume)
  { store->Offer(key, volume); };
  auto files = ScanTogether(found.paths, setup.processes, setup.order, series, keep, progress);
  scan = files ? std::optional(CollectSeries(found.problems, *files)) : std::nullopt;
  if (files)
  {
    store->LearnAll(std::move(*files));
  }
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
  this->Plan(*scan, {*scan->First(), *scan->Last()});
  this->BeginStore();
  times = TimeStepsOf(options, *scan);
}

BiasReport SeriesMerger::CompareRadars() const
{
  return nexrad::CompareRadars(
    LowEchoesOf(this->KnownScan(), times, VolumeRuleOf(request), scan.has_value()));
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
  for (const SiteSeries& series : CollectSeries({}, this->Gather()).sites)
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
  const SeriesScan known = this->KnownScan();
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
  return store ? store->DecodedFiles() : 0;
}

void SeriesMerger::EndAt(Time time)
{
  store->EndAt(time);
}

// Of radars whose summaries tell how far they see, those that see the block, in the order of the
// catalogue; empty: all.
std::vector<bool> SeriesMerger::FindReaching(
  const Catalogue& catalogue, const std::vector<ChosenVolume>& chosen)
{
  const bool tells = std::all_of(chosen.begin(), chosen.end(),
    [](const ChosenVolume& each) { return each.volume->summary != nullptr; });
  if (!tells)
  {
    return {};
  }
  std::vector<SiteReach> reaches;
  for (const SiteSeries& series : catalogue.sites)
  {
    reaches.push_back({series.site.position.value_or(Position()), 0.0});
  }
  for (const auto& [moment, site, volume] : chosen)
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

// Adds a volume of a radar that does not reach the block.
void SeriesMerger::AddSweepless(
  const Catalogue& catalogue, const ChosenVolume& chosen, std::vector<ReadyVolume>& volumes)
{
  const auto& [moment, site, volume] = chosen;
  const Site& radar = catalogue.sites[site].site;
  if (request.method == MergeMethod::Thesis) // of which it only names the radar
  {
    volumes.push_back({std::make_shared<const PolarVolume>(PolarVolume{
                         radar, moment, volume->start, volume->end, volume->synthetic, {}, {}}),
      nullptr});
    return;
  }
  volumes.push_back(
    {nullptr, store->WithoutSweeps(radar, *volume, moment, LooksForMotion(request, moment))});
}

// What a merge of a block at a time takes, for which the request is made; empty when `progress`
// asked to stop.
std::optional<std::vector<ReadyVolume>> SeriesMerger::VolumesOf(
  Time time, const std::optional<VoxelBlock>& block, const Progress& progress)
{
  request.time = time;
  request.block = block;
  if (!block || !(setup.scanFirst || setup.sharesBlocks))
  {
    return this->VolumesAbout(time, {}, progress);
  }
  const Catalogue catalogue = store->Listed();
  const std::vector<ChosenVolume> chosen =
    catalogue.ChosenAt(time, VolumeRuleOf(request), options.moments);
  const std::vector<bool> reaching = this->FindReaching(catalogue, chosen);
  std::optional<std::vector<ReadyVolume>> volumes = this->VolumesAbout(time, reaching, progress);
  for (const ChosenVolume& each : chosen)
  {
    if (volumes && !reaching.empty() && !reaching[each.site])
    {
      this->AddSweepless(catalogue, each, *volumes);
    }
  }
  return volumes;
}

// Empty when `progress` asked to stop.
std::optional<std::vector<ReadyVolume>> SeriesMerger::VolumesAbout(
  Time time, const std::vector<bool>& reaching, const Progress& progress)
{
  std::optional<std::vector<ReadyVolume>> volumes = store->About(time, reaching, progress);
  if (volumes && setup.anyOrder && !scan && store->HeadersErr())
  {
    if (!this->ScanFiles(progress))
    {
      return std::nullopt;
    }
    // Grid and time steps stay as they were told: the volumes of a series have one grid, and its
    // user counts them.
    this->BeginStore();
    volumes = store->About(time, reaching, progress);
  }
  return volumes;
}

std::optional<GriddedVolume> SeriesMerger::Merge(
  Time time, const Progress& progress, const std::optional<VoxelBlock>& block, GriddedVolume memory)
{
  const auto volumes = this->VolumesOf(time, block, progress);
  return volumes
           ? MergeMoments(*volumes, options.moments, request, progress, run, std::move(memory))
           : std::nullopt;
}

bool SeriesMerger::MergeInBands(Time time, int rows, const TakeBand& take, const Progress& progress,
  const std::optional<VoxelBlock>& block)
{
  constexpr double decoding = 0.5; // of the work
  const auto volumes = this->VolumesOf(time, block, ShareOf(progress, 0.0, decoding));
  return volumes && PlannedMerge(*volumes, options.moments, request, run)
                      .MergeBands(rows, take, ShareOf(progress, decoding, 1.0));
}

bool SeriesMerger::MergeEachRadar(
  Time time, const std::function<void(GriddedVolume)>& take, const Progress& progress)
{
  request.time = time;
  request.block = std::nullopt;
  const std::optional<std::vector<ReadyVolume>> volumes = this->VolumesAbout(time, {}, progress);
  if (!volumes)
  {
    return false;
  }
  radarRuns.resize(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    std::vector<ReadyVolume> own;
    std::copy_if(volumes->begin(), volumes->end(), std::back_inserter(own),
      [&name = sites[i]](const ReadyVolume& volume) { return volume.RadarName() == name; });
    std::optional<GriddedVolume> merged = MergeMoments(
      own, options.moments, request, ShareOf(progress, i, sites.size()), radarRuns[i], {});
    if (!merged)
    {
      return false;
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
  return true;
}

bool SeriesMerger::Know(Time time, const Progress& progress)
{
  return store->Know(time, progress);
}

// Each process decodes files of neighbouring sites, which it likely needs for its block.
bool SeriesMerger::KnowTogether(const std::vector<std::size_t>& indices, const Progress& progress)
{
  std::vector<std::filesystem::path> paths;
  for (const std::size_t index : indices)
  {
    paths.push_back(found.paths[index]);
  }
  const auto find =
    [&](const std::vector<std::size_t>& places) -> std::optional<std::vector<ScannedFile>>
  {
    for (const std::size_t place : places)
    {
      store->Expect(indices[place]);
    }
    std::vector<ScannedFile> own;
    for (const std::size_t place : places)
    {
      own.push_back(store->Scan(indices[place]));
      if (progress &&
          !progress(static_cast<double>(own.size()) / static_cast<double>(places.size())))
      {
        return std::nullopt;
      }
    }
    return own;
  };
  const auto files = FindTogether(paths, setup.processes, setup.order, find);
  for (std::size_t i = 0; files && i < indices.size(); ++i)
  {
    store->Learn(indices[i], (*files)[i]);
  }
  return files.has_value();
}

bool SeriesMerger::KnowTogether(Time time, const Progress& progress)
{
  for (auto unknown = store->UnknownAbout(time); !unknown.empty();
       unknown = store->UnknownAbout(time))
  {
    if (!this->KnowTogether(unknown, progress))
    {
      return false;
    }
  }
  return true;
}

std::string SeriesMerger::MadeOf(Time time) const
{
  return MergeText(request) + store->MadeOf(time);
}

std::string SeriesMerger::LastMadeOf(Time time) const
{
  return MergeText(request) + store->LastMadeOf(time);
}

bool SeriesMerger::TakesVolumes() const
{
  return std::any_of(
    times.begin(), times.end(), [this](const Time time) { return !store->MadeOf(time).empty(); });
}

std::string SeriesMerger::KnownFiles()
{
  std::vector<ScannedFile> fresh;
  for (ScannedFile& file : store->Known())
  {
    if (!IsUnknown(file) && told.insert(file.origin).second)
    {
      fresh.push_back(std::move(file));
    }
  }
  return PackScannedFiles(fresh);
}

void SeriesMerger::LearnFiles(const std::string& text)
{
  for (std::size_t i = origins.size(); i < found.paths.size(); ++i)
  {
    origins[OriginOf(found.paths[i])] = i;
  }
  for (const ScannedFile& file : UnpackScannedFiles(text))
  {
    const auto same = origins.find(file.origin);
    if (same != origins.end())
    {
      told.insert(file.origin);
      store->Learn(same->second, file);
    }
  }
}

// Those of reflectivity about a time, without sweeps; empty when `progress` asked to stop.
std::optional<BeamVolumes> SeriesMerger::EchoAbout(Time time, const Progress& progress)
{
  std::optional<BeamVolumes> echo = store->EchoAbout(time);
  if (!echo && this->VolumesAbout(time, {}, progress))
  {
    echo = store->EchoAbout(time).value_or(BeamVolumes());
  }
  return echo;
}

// What merges reflectivity of the same files; nullptr when `progress` asked to stop.
SeriesMerger* SeriesMerger::MergerOfEcho(const Progress& progress)
{
  const std::vector<MomentName>& moments = options.moments;
  if (std::find(moments.begin(), moments.end(), MomentName::REF) != moments.end())
  {
    return this;
  }
  if (!echoMerger)
  {
    MergeOptions ofEcho = options;
    ofEcho.moments = {MomentName::REF};
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
  return volumes ? MergeMoments(*volumes, options.moments, asked, merging, boxRun) : std::nullopt;
}

// What is known of the inputs so far.
SeriesScan SeriesMerger::KnownScan() const
{
  return scan ? *scan : CollectSeries(found.problems, store->Known());
}

// What all processes decoded.
std::vector<ScannedFile> SeriesMerger::Gather() const
{
  std::vector<ScannedFile> all = store->Known();
  if (setup.processes.Count() > 1)
  {
    std::vector<ScannedFile> told = all; // summaries are long, and known where they are needed
    for (ScannedFile& file : told)
    {
      for (auto& [site, volume] : file.volumes)
      {
        volume.summary = nullptr;
      }
    }
    for (const std::string& message : setup.processes.Exchange(PackScannedFiles(told)))
    {
      std::vector<ScannedFile> part = UnpackScannedFiles(message);
      for (std::size_t i = 0; i < part.size(); ++i)
      {
        if (IsUnknown(all[i]) || (!TellsEcho(all[i]) && TellsEcho(part[i])))
        {
          all[i] = std::move(part[i]);
        }
      }
    }
  }
  return all;
}

bool SeriesMerger::Settle()
{
  if (scan)
  {
    return true;
  }
  store->LearnAll(this->Gather());
  this->BeginStore();
  const SeriesScan known = this->KnownScan();
  const bool asTold = !known.sites.empty() &&
                      request.grid == GridOf(options, known.Positions(), known.Range()) &&
                      !FindPause(options, known.Spans()) && times == TimeStepsOf(options, known);
  return setup.processes.InAll(asTold);
}

} // namespace nexrad
