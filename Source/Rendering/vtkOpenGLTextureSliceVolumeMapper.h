// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLTextureSliceVolumeMapper
 * @brief   Draws a volume as slices of a 3-D texture, parallel to the image plane
 *
 * A drop-in for vtkOpenGLGPUVolumeRayCastMapper that gives the same picture: the slices are drawn
 * front to back, each sample coloured by the property's transfer functions, its opacity corrected
 * for the distance between two samples along its own ray (which grows away from the centre of a
 * perspective view), so that the picture does not depend on the number of slices. Blending is done
 * in floating point.
 *
 * Input: a vtkImageData with one to four components of point or cell scalars of any number type,
 * with any spacing, direction matrix and actor matrix. Points that vtkGhostType marks HIDDENPOINT
 * (cells: HIDDENCELL) and scalars that are not finite contribute nothing; up to half a voxel from a
 * visible point the picture is complete. Unsigned char scalars NAME may be codes: field data
 * `NAME_code_values` (256 numbers) and `NAME_code_ghosts` (256 unsigned char, optional) then give
 * the scalar and the ghost flags that each code stands for, and the picture is that of these
 * scalars and flags. Components are independent (each with its own functions,
 * material and weight) or dependent (2: value and opacity; 4: red, green, blue, opacity).
 *
 * Blend modes: composite, maximum, minimum, average, additive, isosurface. Light and gradient
 * opacity as in VTK's ray caster; they count where places are shown (composite, isosurface), not in
 * projections. Two-dimensional transfer functions (scalar and gradient magnitude) in the composite
 * mode. A mask of the volume's dimensions, one unsigned char each: binary, or labels with functions
 * of their own. Cropping, clipping planes, opaque geometry, a camera inside the volume, and final
 * window and level work as in VTK's ray caster; translucent geometry is behind the volume, peeled
 * or not.
 *
 * ImageSampleDistance makes the picture coarser or finer than the window. With
 * AutoAdjustSampleDistances (on by default) it is 1 in still pictures, and 1, 2, 5 or 10, between
 * MinimumImageSampleDistance and MaximumImageSampleDistance, while the window's desired update rate
 * asks for more than one frame a second.
 *
 * vtkTextureSliceObjectFactory puts this class wherever VTK makes a vtkGPUVolumeRayCastMapper.
 *
 * Not supported, and refused by IsRenderSupported and with an error: slice blending, a second array
 * for two-dimensional functions, several volumes in one mapper, a label map with several components
 * or two-dimensional functions, one or three dependent components, four that are not unsigned char,
 * maximum or minimum of dependent components, isosurfaces of several components, averages of
 * several components over part of the range, volumes larger than the largest 3-D texture, and a 2-D
 * image, which has no thickness. Refused with an error when it is met: four components with hidden
 * points, and depth peeling of volumes. Jittering, UseDepthPass, RenderToImage, user shaders and
 * UseClippedVoxelIntensity are ignored. A hardware selection finds the volume, not its voxels.
 */
#ifndef vtkOpenGLTextureSliceVolumeMapper_h
#define vtkOpenGLTextureSliceVolumeMapper_h

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"          // for what is prepared

#include <memory> // for std::unique_ptr
#include <string> // for errors

class vtkDataArray;
class vtkImageData;
struct vtkTextureSliceRequest;
struct vtkTextureSliceUniforms;

class VTKNEXRADRENDERING_EXPORT vtkOpenGLTextureSliceVolumeMapper : public vtkGPUVolumeRayCastMapper
{
public:
  static vtkOpenGLTextureSliceVolumeMapper* New();
  vtkTypeMacro(vtkOpenGLTextureSliceVolumeMapper, vtkGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Slices between the nearest and the farthest point of the volume, 0 to 16384. 0 takes the
   * spacing from the sample distance: SampleDistance, or with LockSampleDistanceToInputSpacing one
   * that follows the voxels, or with AutoAdjustSampleDistances (on by default) the shortest edge of
   * a voxel. Default: 256.
   */
  vtkSetClampMacro(NumberOfSlices, int, 0, 16384);
  vtkGetMacro(NumberOfSlices, int);
  ///@}

  /**
   * Slices that the last frame drew; 0 before the first.
   */
  int GetNumberOfDrawnSlices() const;

  /**
   * Whether this mapper can draw its present input into that window with that property (which may
   * be nullptr) and its present settings. The largest texture is known once the window's context is
   * current.
   */
  int IsRenderSupported(vtkRenderWindow* window, vtkVolumeProperty* property) override;

  /**
   * Does beforehand what takes longest when scalars are drawn for the first time: finds their
   * ranges and checksums, and given what this function returned for the volume that is drawn before
   * them, also encodes the texels that change. All this stays with the array (in its information)
   * until it is drawn or changes. It needs no OpenGL, and touches no other image: a program that
   * plays a series may do it on the thread that reads the next volume, before it hands the image
   * on. Takes the active scalars of the points, or of the cells; nullptr where there are none.
   */
  static vtkSmartPointer<vtkObject> PrepareScalars(
    vtkImageData* image, vtkObject* before = nullptr);

  /**
   * Brings the input into texture memory now, rather than when it is drawn: as
   * vtkOpenGLGPUVolumeRayCastMapper::PreLoadData. What is there already is left alone. False, with
   * an error, when it cannot.
   */
  bool PreLoadData(vtkRenderer* renderer, vtkVolume* volume);

  /**
   * Factors that would make the input fit the largest 3-D texture; 1 where it fits already. An
   * OpenGL context must be current.
   */
  void GetReductionRatio(double ratio[3]) override;

  ///@{
  /**
   * Called by VTK while it renders.
   */
  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkOpenGLTextureSliceVolumeMapper();
  ~vtkOpenGLTextureSliceVolumeMapper() override;

  ///@{
  /**
   * Parts of block-wise rendering, which only an AMR mapper asks for; they do nothing.
   */
  void PreRender(vtkRenderer*, vtkVolume*, double[6], double[2], int, unsigned int) override {}
  void RenderBlock(vtkRenderer*, vtkVolume*, unsigned int) override {}
  void PostRender(vtkRenderer*, int) override {}
  ///@}

  int NumberOfSlices = 256;

private:
  vtkOpenGLTextureSliceVolumeMapper(const vtkOpenGLTextureSliceVolumeMapper&) = delete;
  void operator=(const vtkOpenGLTextureSliceVolumeMapper&) = delete;

  class Internals;
  std::unique_ptr<Internals> Parts;

  vtkImageData* TakeInput(vtkDataArray*& scalars);
  vtkTextureSliceRequest MakeRequest(vtkVolumeProperty* property, vtkDataArray* scalars);
  const char* FindUnsupported(const vtkTextureSliceRequest& request);
  double ChooseImageSampleDistance(double allowedTime);
  double ChooseSampleDistance(vtkImageData* image, double shortestVoxelEdge);
  void SetUpFrame(vtkRenderer* renderer);
  bool PlaceSlices(
    vtkRenderer* renderer, vtkImageData* image, const vtkTextureSliceRequest& request);
  void RenderVolume(vtkRenderer* renderer, vtkVolume* volume);
  void RenderSlices(vtkRenderer* renderer, vtkImageData* image, vtkDataArray* scalars,
    const vtkTextureSliceRequest& request);
  bool Upload(
    vtkRenderer* renderer, vtkImageData* image, vtkDataArray* scalars, std::string& error);
  bool UpdateMask(vtkImageData* image, std::string& error);
  vtkTextureSliceUniforms MakeUniforms(
    vtkRenderer* renderer, const vtkTextureSliceRequest& request);
};

#endif
