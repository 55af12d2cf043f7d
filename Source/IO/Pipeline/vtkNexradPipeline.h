// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradPipeline.h
 * @brief  progress, abort, error codes and pieces of volumes, the same way in every class
 *
 * Plain functions for the readers, writers and filters of this project.
 */
#ifndef vtkNexradPipeline_h
#define vtkNexradPipeline_h

#include "vtkNexradIOModule.h" // For export macro

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkImageData;
class vtkInformation;

namespace nexrad
{
struct GridSpecification;
struct VoxelBlock;
} // namespace nexrad

/**
 * For the beginning of a run: forgets that an earlier one was asked to stop. VTK's executive does
 * so itself up to 9.1.
 */
VTKNEXRADIO_EXPORT void vtkNexradForgetAbort(vtkAlgorithm* algorithm);

/**
 * A progress function (nexrad::Progress) that reports the share [from, to] of the algorithm's run
 * in steps of a fiftieth and returns false when the algorithm should stop. Call it from the
 * algorithm's own thread. It must not outlive the algorithm.
 */
VTKNEXRADIO_EXPORT std::function<bool(double)> vtkNexradProgress(
  vtkAlgorithm* algorithm, double from = 0.0, double to = 1.0);

/**
 * For the end of a request that failed, after the algorithm has set its error code: reports the
 * line as an error of the algorithm. Its executive then adds no message of its own that the
 * algorithm returned failure or gave no extent. Returns 0, which a request returns when it fails.
 */
VTKNEXRADIO_EXPORT int vtkNexradFail(vtkAlgorithm* algorithm, const std::string& line);

/**
 * Says in an output's information which time steps there are, at least one, ascending.
 */
VTKNEXRADIO_EXPORT void vtkNexradOfferTimes(
  vtkInformation* outputInformation, const double* times, int count);

/**
 * The time that a request asks for. Where it asks for none, or for one more than a day before the
 * first time step, the first time step: before anything plays, the time of a program that shows
 * data is 0, which is the year 1970.
 */
VTKNEXRADIO_EXPORT double vtkNexradRequestedTime(
  vtkInformation* outputInformation, double firstTimeStep);

/**
 * The vtkErrorCode of a path that cannot be read as a radar file or volume: NoFileNameError,
 * FileNotFoundError, CannotOpenFileError, or NoError when the path can be opened.
 */
VTKNEXRADIO_EXPORT unsigned long vtkNexradPathError(const char* path);

/**
 * One line for such an error code.
 */
VTKNEXRADIO_EXPORT std::string vtkNexradPathErrorText(unsigned long code, const char* path);

// Pieces of a merged volume: a pipeline that runs in several processes, or that streams, asks for
// boxes of the voxels (UPDATE_EXTENT). Origin and spacing of an image are those of the whole grid;
// its extent says which part it is.

/**
 * Says in an output's information that it is an image of this grid, of which any box of voxels can
 * be asked for.
 */
VTKNEXRADIO_EXPORT void vtkNexradOfferGrid(
  vtkInformation* outputInformation, const nexrad::GridSpecification& grid);

/**
 * The voxels of the grid that a request asks for: all where it does not say it; it may be none.
 */
VTKNEXRADIO_EXPORT nexrad::VoxelBlock vtkNexradRequestedBlock(
  vtkInformation* outputInformation, const nexrad::GridSpecification& grid);

/**
 * Makes an image of the block alone the block's part of an image of the grid.
 */
VTKNEXRADIO_EXPORT void vtkNexradPlaceBlock(
  const nexrad::GridSpecification& grid, const nexrad::VoxelBlock& block, vtkImageData* image);

#endif
// VTK-HeaderTest-Exclude: vtkNexradPipeline.h
