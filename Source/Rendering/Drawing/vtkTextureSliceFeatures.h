// SPDX-License-Identifier: BSD-3-Clause
// What the shaders of one frame must be able to do, and the shaders.
#ifndef vtkTextureSliceFeatures_h
#define vtkTextureSliceFeatures_h

#include <string>

/// Each combination is a shader program of its own, which compiles only what it needs.
struct vtkTextureSliceFeatures
{
  int BlendMode = 0; ///< vtkVolumeMapper::BlendModes
  int Components = 1;
  /// Sets of transfer functions: 1, or the number of components if each has its own.
  int Functions = 1;
  bool Masked = false;      ///< the volume's last component is its mask
  bool Blanked = false;     ///< there are cells, or points, whose ghost flags hide samples
  bool Rectilinear = false; ///< the distances of the points differ
  bool Cropped = false;     ///< samples must be tested against the cropping regions
  bool Parallel = false;
  bool GradientOpacity = false;
  bool SmoothGradient = false;
  bool ClippedScalars = false; ///< gradients take one scalar for what is clipped away
  bool Table2D = false;        ///< functions over scalar and gradient magnitude, or a second array
  int SecondArray = 0;         ///< components of the second array; 0: there is none
  bool SecondMasked = false;
  bool BinaryMask = false; ///< samples outside of the mask are left out
  int Labels = 0;          ///< labels that have functions of their own
  bool Selection = false;  ///< what is seen gets the one colour that a hardware selection asks for
  bool Shadows = false;    ///< the light volume says how much light arrives
  int Lights = -1;         ///< -1: unlit; 0: a single headlight; else the number of lights
  int IsoValues = 0;
  int Contours = 0; ///< rays begin at the first contour of these values; 0: where they enter
  /// Neighbouring slabs share a sample, and several are computed faster than one after the other.
  static constexpr int SlabsOfPiece = 4;
  bool Slabs = false; ///< the functions are integrated over slabs (Formulas L1)
  /// An extreme of dependent components: all of them are those of the sample with the extreme of
  /// the last one.
  bool ExtremeSample = false;
  int ClippingPlanes = 0;
  bool Skipping = false; ///< rays leap over empty bricks
  bool Places = false;   ///< the picture is of the first places that are seen, not of colours
  int Peel = 0;          ///< vtkTextureSlicePeeling::Stage

  /// Rows of the transfer table: functions, then their gradient opacities.
  int CountRows() const { return this->Functions * (this->GradientOpacity ? 2 : 1); }
  /// Rows of the table of labels: functions, then their gradient opacities.
  int CountLabelRows() const { return this->Labels * (this->GradientOpacity ? 2 : 1); }
  /// Dimensions of the textures of integrals: those of labels and the common ones have the same.
  int GetIntegralDimensions() const { return this->Functions > 1 || this->Labels > 0 ? 2 : 1; }
  bool NeedsGradient() const
  {
    return this->GradientOpacity || (this->Table2D && this->SecondArray == 0) ||
           this->Lights >= 0 || (this->Shadows && this->IsoValues > 0);
  }
  /// Whether the shader reads the depth of the opaque geometry; peeling has depths of its own.
  bool NeedsDepth() const { return this->Peel == 0; }
  bool HasMask() const { return this->BinaryMask || this->Labels > 0; }
  /// The first lines of the fragment shaders.
  std::string GetDefines() const;
};

#endif
