// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradTextureSliceRepresentation
 * @brief   ParaView's volume representation, drawn by vtkOpenGLTextureSliceVolumeMapper
 *
 * It has what ParaView's own volume representation has, for one vtkImageData with scalars of one
 * component; for vectors choose a component with ParaView's Calculator first. Rectilinear grids,
 * partitioned data, two-dimensional transfer functions of a second array and slice blending are
 * ParaView's own representation's alone.
 */
#ifndef vtkNexradTextureSliceRepresentation_h
#define vtkNexradTextureSliceRepresentation_h

#include "vtkImageVolumeRepresentation.h"
#include "vtkNexradRepresentationsModule.h" // For export macro

#include <memory>

class VolumeGround;
class vtkOpenGLTextureSliceVolumeMapper;

class VTKNEXRADREPRESENTATIONS_EXPORT vtkNexradTextureSliceRepresentation
  : public vtkImageVolumeRepresentation
{
public:
  static vtkNexradTextureSliceRepresentation* New();
  vtkTypeMacro(vtkNexradTextureSliceRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Slices between the nearest and the farthest point of the volume, 0 to 16384; 0 (the
   * default) takes the distance from the voxels.
   */
  void SetNumberOfSlices(int slices);
  int GetNumberOfSlices();

  /**
   * Whether slices integrate the transfer functions between the scalars at their front and back, in
   * place of taking one sample: vtkOpenGLTextureSliceVolumeMapper::SetPreIntegration. On by
   * default.
   */
  void SetPreIntegration(bool on);

  /**
   * One of vtkVolumeMapper's blend modes, except slice blending. Composite by default. In place of
   * the superclass's, which looks for mappers of other classes.
   */
  void SetBlendMode(int mode);

  /**
   * Screen pixels between two pixels of the picture, 1 (the default) to 10, in still pictures and
   * in moving ones. When automatic (the default), moving pictures are made coarser as far as the
   * frame rate asks for.
   */
  void SetImageSampleDistance(double pixels);
  void SetAutoAdjustSampleDistances(bool automatic);

  /**
   * How strong shadows and ambient occlusion are, 0 (off, the default) to 1, how dense the volume
   * is for their light, what they leave is multiplied by, and the direction from the volume to the
   * light: those of vtkOpenGLTextureSliceVolumeMapper.
   */
  void SetShadowStrength(double strength);
  void SetOcclusionStrength(double strength);
  void SetShadowDensity(double density);
  void SetExposure(double exposure);
  void SetLightDirection(double x, double y, double z);

  /**
   * Whether the ground lies under the volume: shaded relief and water where its field data have a
   * projection, else a plane of one colour, with the volume's shadow. Off by default.
   */
  void SetGround(bool shown);

  /**
   * The mapper that draws.
   */
  vtkOpenGLTextureSliceVolumeMapper* GetSliceMapper();

protected:
  vtkNexradTextureSliceRepresentation();
  ~vtkNexradTextureSliceRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  void UpdateGround();

  std::unique_ptr<VolumeGround> DrawnGround;
  bool Ground = false;
  unsigned long FrameTag = 0; // of what is told that a frame begins

  vtkNexradTextureSliceRepresentation(const vtkNexradTextureSliceRepresentation&) = delete;
  void operator=(const vtkNexradTextureSliceRepresentation&) = delete;
};

#endif
