// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradTwoFields
 * @brief   one array of an image for colours and another for opacities, as two dependent components
 *
 * Input: a vtkImageData with point arrays of one component each, as vtkNexradDayReader and
 * vtkNexradVolumeReader give it. Output: the same image, with a further array "ColorAndOpacity",
 * which becomes the active scalars: float32, component 0 from ColorArrayName, component 1 from
 * OpacityArrayName. A volume mapper draws it with the components dependent
 * (vtkVolumeProperty::IndependentComponentsOff): the colour function is asked for component 0, the
 * opacity function for component 1.
 *
 * The ghost flags are those of the opacity array: the input's where that array is the active
 * scalars, else made from its states (vtkNexradImageConversion.h). So it alone decides where there
 * is something to see.
 *
 * Where the colour array has no value, component 0 is a value that lies 16 widths of the array's
 * usual range below it, so that one colour for all that is below stands for "no
 * value". A mapper interpolates between voxels: so far away, nearly all of the way to a voxel
 * without a value has that colour, and no other value appears in between. A colour is seen where
 * all voxels about a point have values. A moment has no value where its state is not 0 (echo); an
 * ancillary array where the state of its moment is neither 0 nor 1 (no echo), or no radar scanned
 * (`_radars` 0, `_site` 255);
 * any array where it is not finite.
 *
 * Errors (UserError): an array that the image does not have, or that has several components.
 */
#ifndef vtkNexradTwoFields_h
#define vtkNexradTwoFields_h

#include "vtkImageAlgorithm.h"
#include "vtkNexradFiltersModule.h" // For export macro

#include <string> // For members

class VTKNEXRADFILTERS_EXPORT vtkNexradTwoFields : public vtkImageAlgorithm
{
public:
  static vtkNexradTwoFields* New();
  vtkTypeMacro(vtkNexradTwoFields, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array that gives the colours, as "VEL" or "REF_age". It must be set.
   */
  vtkSetMacro(ColorArrayName, std::string);
  vtkGetMacro(ColorArrayName, std::string);
  ///@}

  ///@{
  /**
   * Name of the array that gives the opacities. Empty, the default: the active scalars.
   */
  vtkSetMacro(OpacityArrayName, std::string);
  vtkGetMacro(OpacityArrayName, std::string);
  ///@}

  ///@{
  /**
   * Component 0 where the colour array has no value, in the array's unit, when UseMissingValue is
   * on. -1000 and off by default: it lies 16 widths of the array's usual range below it. Of an
   * array without a usual range, the range is that of its values: then set a value when several
   * processes make parts of the image, or when it changes with time.
   */
  vtkSetMacro(MissingValue, double);
  vtkGetMacro(MissingValue, double);
  vtkSetMacro(UseMissingValue, bool);
  vtkGetMacro(UseMissingValue, bool);
  vtkBooleanMacro(UseMissingValue, bool);
  ///@}

  /**
   * The range in which most values of an array lie, by its name: of the moments and of the
   * ancillary arrays. False for other names. It does not depend on data.
   */
  static bool GetUsualRange(const char* array, double range[2]);

  /**
   * What the last run put where the colour array has no value, and in how many voxels that are not
   * hidden.
   */
  double GetUsedMissingValue() const { return this->UsedMissingValue; }
  vtkIdType GetNumberOfMissingValues() const { return this->NumberOfMissingValues; }

protected:
  vtkNexradTwoFields() = default;
  ~vtkNexradTwoFields() override = default;

  int RequestInformation(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string ColorArrayName;
  std::string OpacityArrayName;
  double MissingValue = -1000.0;
  bool UseMissingValue = false;

private:
  vtkNexradTwoFields(const vtkNexradTwoFields&) = delete;
  void operator=(const vtkNexradTwoFields&) = delete;

  void Combine(vtkImageData* image);

  double UsedMissingValue = 0.0;
  vtkIdType NumberOfMissingValues = 0;
};

#endif
