// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradImageConversion.h
 * @brief  a merged volume as the core knows it, and as vtkImageData, both ways
 *
 * The image of a merged volume, here of REF. Point data:
 *
 * - `REF`, float32, the active scalars: values in the moment's unit; the fill value where there is
 *   no echo and where nothing was scanned.
 * - `REF_state`, uint8: 0 echo, 1 no echo, 2 range folded, 3 not scanned, 4 filtered (quality
 *   control took the echo out, and no other radar saw the place).
 * - `vtkGhostType`, uint8: HIDDENPOINT where not scanned; of other moments than reflectivity, where
 *   there is no echo and hence no value.
 *
 * Further moments, here VEL, when several were merged:
 *
 * - `VEL`, float32: NaN where there is no value. The ghost flags are those of the first moment.
 * - `VEL_state`, uint8: as `REF_state`.
 *
 * On demand, of the method "beam", the ancillary arrays of each moment; 0 where not scanned:
 *
 * - `REF_age`, float32: seconds between the volume's time and the nearest ray that took part.
 * - `REF_radars`, uint8: number of radars that scanned the voxel.
 * - `REF_weight`, float32: sum of their weights.
 * - `REF_site`, uint8: which of `Sites`, counted from 0, is the nearest of them; 255 for none.
 *
 * Of a volume of one radar alone (`grid --per-radar`), on demand, the radar's view
 * (vtkNexradAddRadarView):
 *
 * - `azimuth`, float32: degrees clockwise from north.
 * - `elevation`, float32: degrees above the horizon, of the beam through the voxel.
 * - `slant_range`, float32: m along the beam.
 *
 * With codes (vtkNexradReadVolumeFile), the image has less point data, and what they stand for in
 * its field data:
 *
 * - `REF`, uint8, the active scalars: codes, as the file has them; no `REF_state`, no
 *   `vtkGhostType`. Range folded and filtered have the code of no echo.
 * - `REF_code_values`, float32, in the field data: 256 values, one for each code; the fill value
 * for codes of other states than echo.
 * - `REF_code_states` and `REF_code_ghosts`, uint8, likewise: the state and the vtkGhostType.
 *
 * Field data:
 *
 * - `FillValue`, float32.
 * - `Projection`, string: what x and y are, as a PROJ string.
 * - `ProjectionCenter`, float64, two components: latitude and longitude in degrees.
 * - `TimeValue`, float64: seconds since 1970-01-01T00:00:00Z.
 * - `Sites`, strings: names of the radars that took part.
 * - `SitePositions`, float64, three components, where they are known: of each of `Sites` latitude
 *   and longitude in degrees, and altitude of the antenna in m above mean sea level.
 * - `Method`, string: "thesis" or "beam".
 * - `OneRadar`, uint8, where it is so: 1, the volume is that of one of several radars alone.
 * - `Synthetic`, uint8: 1 when made from simulated files; pictures must say so.
 * - `Sharpened`, uint8: 1 when `REF` was deconvolved in elevation (Formulas G9); maps must say so.
 * - `BiologicalShare`, float32, where it is above 0: of the gates of reflectivity that were merged,
 *   the part that quality control calls biological.
 * - `Notes`, strings, where there are any: what pictures must say of the radars' volumes.
 *
 * Points are the centres of the voxels. `TimeValue` is the name that VTK's XML readers take the
 * time from.
 */
#ifndef vtkNexradImageConversion_h
#define vtkNexradImageConversion_h

#include "vtkNexradIOModule.h" // For export macro

#include <string>
#include <vector>

class vtkFieldData;
class vtkImageData;

namespace nexrad
{
enum class MomentName : unsigned char;
enum class VoxelState : unsigned char;
struct GriddedVolume;
struct GridSpecification;
struct NxvReadOptions;
} // namespace nexrad

/**
 * The grid of an image, from its extent, origin, spacing and field data. Throws nexrad::Error for
 * an image whose axes are turned.
 */
VTKNEXRADIO_EXPORT nexrad::GridSpecification vtkNexradImageToGrid(vtkImageData* image);

/**
 * Whether a voxel of that moment and state is HIDDENPOINT.
 */
VTKNEXRADIO_EXPORT bool vtkNexradIsHidden(nexrad::MomentName moment, nexrad::VoxelState state);

/**
 * Fills the image from the volume.
 */
VTKNEXRADIO_EXPORT void vtkNexradVolumeToImage(
  const nexrad::GriddedVolume& volume, vtkImageData* image);

/**
 * Adds the view of its radar to the image of a volume of one radar alone, from the image's field
 * data; arrays that `leaveOut` names are not added. Does nothing for other images.
 */
VTKNEXRADIO_EXPORT void vtkNexradAddRadarView(
  vtkImageData* image, const std::vector<std::string>& leaveOut = {});

/**
 * Fills the image with voxels of a .nxv file, unpacked on several threads; of a block, the image is
 * one of it alone. With `codes` the scalars are codes where one moment is read and the file has
 * codes of one byte of it. The options' `bytesBesides` are what the caller makes of each voxel of
 * the image. Throws nexrad::Error as nexrad::ReadNxv does.
 */
VTKNEXRADIO_EXPORT void vtkNexradReadVolumeFile(
  const std::string& path, const nexrad::NxvReadOptions& options, bool codes, vtkImageData* image);

/**
 * The volume in an image that has the arrays above, of values or of codes; its first moment is that
 * of the active scalars, or the first in the order of nexrad::KnownMoments. `vtkGhostType` and the
 * ancillary arrays are not needed. Throws nexrad::Error, naming the array, for an image without
 * them or with an array of another type or length, and for one whose axes are turned.
 */
VTKNEXRADIO_EXPORT nexrad::GriddedVolume vtkNexradImageToVolume(vtkImageData* image);

#endif
// VTK-HeaderTest-Exclude: vtkNexradImageConversion.h
