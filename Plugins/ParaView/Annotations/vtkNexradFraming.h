// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradFraming
 * @brief   how the scene of nexrad3d would show a merged volume where nobody chose
 *
 * Input: a vtkImageData of vtkNexradDayReader or of a .nxv file. The output is empty; what was
 * found is in the properties, which are those of nexrad::scene::FrameVolume with its default
 * options, in the terms of a prop that draws the volume. Processes that have parts of a volume find
 * the same.
 */
#ifndef vtkNexradFraming_h
#define vtkNexradFraming_h

#include "vtkNexradAnnotationsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKNEXRADANNOTATIONS_EXPORT vtkNexradFraming : public vtkPolyDataAlgorithm
{
public:
  static vtkNexradFraming* New();
  vtkTypeMacro(vtkNexradFraming, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What x, y and heights of the volume are multiplied with: of metres, 1, 1 and the stretch of
   * heights; of degrees, so that all three have the length of a degree of latitude.
   */
  vtkGetVector3Macro(Scale, double);

  /**
   * The box to look at, in the coordinates of the volume: from, to of x, of y, and of heights in m.
   */
  vtkGetVector6Macro(Framed, double);

  /**
   * The length to which opacities belong, as VTK measures it, in the coordinates of the volume
   * before they are scaled: along the scene's usual line of sight it has the scene's length.
   */
  vtkGetMacro(OpacityDistance, double);

  /**
   * Number of slices.
   */
  vtkGetMacro(Slices, int);

protected:
  vtkNexradFraming();
  ~vtkNexradFraming() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  double Scale[3] = {1.0, 1.0, 1.0};
  double Framed[6] = {0.0, 1.0, 0.0, 1.0, 0.0, 1.0};
  double OpacityDistance = 1.0;
  int Slices = 0;

private:
  vtkNexradFraming(const vtkNexradFraming&) = delete;
  void operator=(const vtkNexradFraming&) = delete;
};

#endif
