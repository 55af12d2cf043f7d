// SPDX-License-Identifier: BSD-3-Clause
// Measures how long volumes take to be read, uploaded and drawn, and prints the tables 4.2 and 4.3
// of the thesis with its figures and those of VTK's GPU ray caster beside. It needs a display.
#include "Tables/Benchmark.h"
#include "Tables/DrawingTables.h"

namespace
{

using namespace nexrad::application;

void MeasureFrames(const BenchRequest& request, BenchReport& report)
{
  const DrawingReport times = nexrad::scene::MeasureDrawing(PrepareDrawing(request));
  report.machine.opengl = times.opengl;
  report.tables.push_back(MakeRenderingTable(times, request.synthetic));
  report.tables.push_back(MakeFrameRateTable(times, request.synthetic));
}

} // namespace

int main(int argc, char** argv)
{
  return RunBenchmark(argc, argv,
    "Measures drawing on this machine, beside VTK's GPU ray caster and the thesis's figures",
    {{"drawing", MeasureFrames}});
}
