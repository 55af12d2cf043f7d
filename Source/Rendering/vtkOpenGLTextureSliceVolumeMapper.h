// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLTextureSliceVolumeMapper
 * @brief   Draws a volume by its samples on slices of a 3-D texture, parallel to the image plane
 *
 * A drop-in for vtkOpenGLGPUVolumeRayCastMapper that gives the same picture: the ray of each pixel
 * has a sample on each slice, coloured by the property's transfer functions. Opacity is corrected
 * for the distance of two samples, so the picture does not depend on the number of slices. Bricks
 * of voxels in which the functions show nothing are skipped.
 *
 * Input: a vtkImageData, or a vtkRectilinearGrid whose coordinates ascend; one to four components
 * of point or cell scalars of any number type. Points (cells of cell scalars) that vtkGhostType
 * marks with any flag and scalars that are not finite contribute nothing. Unsigned char scalars
 * NAME may be codes: field data `NAME_code_values` (256 numbers) gives the scalar of each code, and
 * `NAME_code_ghosts` (256 unsigned char, optional) its ghost flags. Components are independent
 * (each with its own functions, material and weight) or dependent (2: value and opacity; 4: red,
 * green, blue, opacity).
 *
 * Blend modes: composite, maximum, minimum, average, additive, isosurface, slice (the property's
 * SliceFunction, a vtkPlane in world coordinates). Of two dependent components the second has the
 * isosurfaces and gives their opacity, the first gives the colour. Composite takes two-dimensional
 * transfer functions as well, over scalar and gradient magnitude, or over scalar and the array that
 * Transfer2DYAxisArray names. Light, gradient opacity and UseClippedVoxelIntensity count in
 * composite, isosurface and slice. A mask of one unsigned char a voxel is binary, or has labels
 * with functions of their own. Cropping, clipping, opaque geometry, cameras inside the volume,
 * final window and level and sample distances work as in VTK's ray caster. Translucent geometry is
 * behind the volume, unless the renderer peels both by depth (SetUseDepthPeelingForVolumes).
 *
 * vtkTextureSliceObjectFactory puts this class wherever VTK makes a vtkGPUVolumeRayCastMapper.
 *
 * Not supported, and refused by IsRenderSupported and with an error: slice blending without a
 * vtkPlane, grids whose coordinates do not ascend, several volumes in one mapper, a label map with
 * several components or two-dimensional functions, one or three dependent components, four that are
 * not unsigned char, isosurfaces of other components, rectilinear grids, masks and second arrays
 * larger than the largest 3-D texture, and a 2-D image, which has no thickness. Refused with an
 * error when it is met: four components with hidden points, render passes that peel volumes in a
 * way that is not VTK's, and VTK's peeling in a window with multisamples, which draws nothing
 * translucent. What is refused or ignored is said once, not in each frame. Jittering and
 * VolumetricScatteringBlending are ignored; user shaders are ignored with a warning. A hardware
 * selection finds the volume, not its voxels.
 */
#ifndef vtkOpenGLTextureSliceVolumeMapper_h
#define vtkOpenGLTextureSliceVolumeMapper_h

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"          // for what is prepared

#include <memory> // for std::unique_ptr
#include <string> // for errors

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
struct vtkTextureSliceParts;
struct vtkTextureSliceRequest;

class VTKNEXRADRENDERING_EXPORT vtkOpenGLTextureSliceVolumeMapper : public vtkGPUVolumeRayCastMapper
{
public:
  static vtkOpenGLTextureSliceVolumeMapper* New();
  vtkTypeMacro(vtkOpenGLTextureSliceVolumeMapper, vtkGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Slices between the nearest and the farthest point of the volume, 0 to 16384; 256 by default. 0
   * takes their distance from SampleDistance, or with LockSampleDistanceToInputSpacing from the
   * voxels, or with AutoAdjustSampleDistances (on by default) from the shortest edge of a voxel.
   */
  vtkSetClampMacro(NumberOfSlices, int, 0, 16384);
  vtkGetMacro(NumberOfSlices, int);
  ///@}

  ///@{
  /**
   * How strong the shadow is that the volume casts on itself, 0 (off, the default) to 1: how much
   * of a sample's diffuse and specular light, or without shading of its colour, is taken away where
   * the light of LightDirection does not arrive. Composite blending with one-dimensional functions
   * and isosurfaces have shadows and occlusion; in other modes they have no effect. They are made
   * from the scalars' opacity alone. Rectilinear grids have none. What is cropped or clipped away,
   * hidden or masked out casts no shadow.
   */
  vtkSetClampMacro(ShadowStrength, double, 0.0, 1.0);
  vtkGetMacro(ShadowStrength, double);
  ///@}

  ///@{
  /**
   * How strong ambient occlusion is, 0 (off, the default) to 1: how much of a sample's ambient
   * light, or without shading of its colour, is taken away where the light of the sky does not
   * arrive. The sky is the half of all directions about Zenith.
   */
  vtkSetClampMacro(OcclusionStrength, double, 0.0, 1.0);
  vtkGetMacro(OcclusionStrength, double);
  ///@}

  ///@{
  /**
   * How dense the volume is for the light of shadows and occlusion, over what it is for the viewer:
   * 0 to 1, 1 by default. With a smaller one light comes deeper, as in a cloud, whose droplets
   * scatter most of it forwards.
   */
  vtkSetClampMacro(ShadowDensity, double, 0.0, 1.0);
  vtkGetMacro(ShadowDensity, double);
  ///@}

  ///@{
  /**
   * What shadow and occlusion leave of a colour without shading is multiplied by this, up to the
   * colour itself. 1 to 4; 1 by default.
   */
  vtkSetClampMacro(Exposure, double, 1.0, 4.0);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Direction from the volume to the light that casts the shadows, in world coordinates, of any
   * length; with (0, 0, 0) there is no shadow. It does not move with the camera. (-1, -1, 2) by
   * default.
   */
  vtkSetVector3Macro(LightDirection, double);
  vtkGetVector3Macro(LightDirection, double);
  ///@}

  ///@{
  /**
   * Upwards in world coordinates: the middle of the sky for occlusion; with (0, 0, 0) there is
   * none. (0, 0, 1) by default.
   */
  vtkSetVector3Macro(Zenith, double);
  vtkGetVector3Macro(Zenith, double);
  ///@}

  /**
   * Brings shadows and occlusion up to date now, rather than when the volume is drawn, for props
   * that show GetLightVolume and are drawn before. False, with an error, when it cannot.
   */
  bool UpdateLight(vtkRenderer* renderer, vtkVolume* volume);

  /**
   * How much light arrives, as the last frame (or UpdateLight) used it: an image of floats in the
   * coordinates of the input, of at most 1,048,576 points, an eighth of these during an
   * interaction. First component: the transmittance to the light (0 to 1: all of it arrives);
   * second: its mean over the sky; 1 where its strength is 0. nullptr where both are off.
   */
  vtkImageData* GetLightVolume();

  ///@{
  /**
   * Pre-integrated classification (Engel, Kraus and Ertl 2001): the transfer functions are
   * integrated over slabs between two slices, so steep functions leave no rings, and fewer slices
   * are enough. Other blend modes than composite, nearest interpolation and two-dimensional
   * functions ignore it. Of two or four dependent components the opacity is integrated, and the
   * colour is that of the middle of the slab. Default: off, the picture of VTK's ray caster.
   */
  vtkSetMacro(PreIntegration, bool);
  vtkGetMacro(PreIntegration, bool);
  vtkBooleanMacro(PreIntegration, bool);
  ///@}

  ///@{
  /**
   * What draws the volume; all ways draw the same picture up to rounding. FRAGMENTS: one fragment a
   * pixel goes along the pixel's ray (OpenGL 3.2). COMPUTE: a compute shader does the same (OpenGL
   * 4.2 with GL_ARB_compute_shader). POLYGONS: the outline of the volume, blended once a slice,
   * which is slow and shows how slices work; composite blending without PreIntegration and
   * UseDepthPass alone, else as AUTOMATIC. AUTOMATIC (the default) draws by fragments, times both
   * shaders with the second frame, once for each thread and renderer, and goes on by compute where
   * that is twice as fast; Mesa's software renderer keeps to fragments. A way that the context
   * lacks is replaced with a warning. The environment variable VTK_TEXTURE_SLICE_WAY (automatic,
   * fragments, compute, polygons) takes precedence.
   */
  enum Ways
  {
    AUTOMATIC,
    FRAGMENTS,
    COMPUTE,
    POLYGONS
  };
  vtkSetClampMacro(Way, int, AUTOMATIC, POLYGONS);
  vtkGetMacro(Way, int);
  ///@}

  ///@{
  /**
   * The way and the number of slices of the last frame; AUTOMATIC and 0 before the first.
   */
  int GetDrawnWay() const;
  int GetNumberOfDrawnSlices() const;
  ///@}

  /**
   * Texture memory of the scalars in the last frame, in bytes; 0 before the first. An image that
   * needs more than MaxMemoryInBytes (256 MiB where that is 0, the default) is stored in pages,
   * where these take less, and so is one that is larger than the largest texture: of all pages of
   * about 17 x 17 x 17 points in which all scalars are equal, or hidden, one is stored. The picture
   * is the same.
   */
  vtkIdType GetTextureBytes() const;

  ///@{
  /**
   * Whether light and gradient opacity take the gradient from the eight corners of a cube of three
   * voxels, in place of central differences, as VTK's ray caster. Surfaces of noisy scalars then do
   * not sparkle; shapes of less than three voxels are lost. Off by default.
   */
  vtkSetMacro(SmoothGradient, bool);
  vtkGetMacro(SmoothGradient, bool);
  vtkBooleanMacro(SmoothGradient, bool);
  ///@}

  /**
   * Whether this mapper can draw its present input into that window with that property (which may
   * be nullptr) and its present settings. The largest texture is known once the window's context
   * is current.
   */
  int IsRenderSupported(vtkRenderWindow* window, vtkVolumeProperty* property) override;

  /**
   * Does beforehand, on any thread and without OpenGL, what takes longest when scalars are drawn
   * for the first time: finds ranges and checksums of the active scalars of points, or of cells,
   * and with what this function returned for the volume drawn before, encodes the texels that
   * change. This stays with the array until it is drawn or changes. nullptr without scalars.
   */
  static vtkSmartPointer<vtkObject> PrepareScalars(
    vtkImageData* image, vtkObject* before = nullptr);

  /**
   * Brings the input into texture memory now, rather than when it is drawn, as VTK's ray caster
   * does. False, with an error, when it cannot.
   */
  bool PreLoadData(vtkRenderer* renderer, vtkVolume* volume);

  ///@{
  /**
   * With RenderToImageOn, which leaves the window alone, the last frame. Four unsigned char a
   * pixel: associated colour, transparent white beside the volume. Of DepthImageScalarType: the
   * window's depth of the first sample that is seen, 1 where there is none; with
   * ClampDepthToBackface, that of the face where the ray enters, as VTK 9.1 has it.
   */
  void GetColorImage(vtkImageData* output) override;
  void GetDepthImage(vtkImageData* output) override;
  ///@}

  /**
   * Factors that would make a rectilinear grid fit the largest 3-D texture; 1 where it fits
   * already, and for images. An OpenGL context must be current.
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
  bool SmoothGradient = false;
  double ShadowStrength = 0.0;
  double OcclusionStrength = 0.0;
  double ShadowDensity = 1.0;
  double Exposure = 1.0;
  double LightDirection[3] = {-1.0, -1.0, 2.0};
  double Zenith[3] = {0.0, 0.0, 1.0};
  bool PreIntegration = false;
  int Way = AUTOMATIC;

private:
  vtkOpenGLTextureSliceVolumeMapper(const vtkOpenGLTextureSliceVolumeMapper&) = delete;
  void operator=(const vtkOpenGLTextureSliceVolumeMapper&) = delete;

  std::unique_ptr<vtkTextureSliceParts> Parts;

  // These return in one line why nothing can be drawn, or an empty text.
  std::string TakeInput();
  std::string UpdateVolume(vtkRenderer* renderer, vtkVolume* volume);
  std::string DrawVolume(vtkRenderer* renderer, vtkVolume* volume);
  std::string DrawSlices(vtkRenderer* renderer);
  std::string TakeImages(bool isDrawn);
  /// Whether that text is empty; else it is said, unless it was said of the last frame.
  bool Accept(const std::string& refused);
  void RenderVolume(vtkRenderer* renderer, vtkVolume* volume);
  vtkTextureSliceRequest MakeRequest(
    vtkVolumeProperty* property, vtkDataSet* input, vtkDataArray* scalars, bool cellData);
  std::string UpdateMask();
  double ChooseSampleDistance();
  void UpdateShadows();
  /// @return false where nothing is to be seen
  bool PlaceSlices();
  void SetFeatures(vtkRenderer* renderer);
};

#endif
