// SPDX-License-Identifier: BSD-3-Clause
// How coarse the picture may be so that a frame takes no longer than allowed.
#ifndef vtkTextureSliceResolution_h
#define vtkTextureSliceResolution_h

#include "vtkNexradRenderingModule.h" // for the export macro

/**
 * The image sample distance, pixels of the window for each pixel of the volume's picture along an
 * axis: 1, 2, 5 or 10, as in VTK's ray caster. A frame's time is taken to grow with its pixels.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceResolution
{
public:
  /// Whether a frame that may take that long, seconds, is one of an interaction.
  static bool IsInteractive(double allowedTime);

  /**
   * The finest of the distances whose frame is expected to take no longer, clamped.
   * @param allowedTime seconds.
   */
  double Choose(double allowedTime, double minimum, double maximum);
  /// Reports how many seconds the frame of the last choice took.
  void Report(double seconds);

private:
  double LastDistance = 1.0;
  double FullTime = 0.0; ///< expected at a distance of 1; 0: not known yet
};

#endif
