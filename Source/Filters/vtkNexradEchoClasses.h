// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradEchoClasses
 * @brief   adds to sweeps what the echo of each gate of reflectivity comes from
 *
 * Input: sweeps, as vtkNexradLevel2Reader and vtkNexradSeriesReader give them. Output: the same
 * sweeps; grids with `REF` have two point arrays more:
 *
 * - `REF_class`, uint8: 0 no value, 1 weather, 2 ground (clutter and anomalous propagation), 3
 *   biological (birds and insects), 4 spike (the sun or another transmitter), 5 receiver fault, 6
 *   speckle.
 * - `REF_reason`, uint8: which test decided (GetEchoReasonName; Documentation/User/3-merging.md
 * lists them).
 *
 * The field data of these grids and of the collection have the names of the numbers: string arrays
 * `EchoClassNames` and `EchoReasonNames`.
 *
 * Nothing is taken out of `REF`; vtkNexradDayReader does that before it merges, by
 * the same classes. The tests look at all moments of a volume (Formulas Q1 to Q4): a moment that
 * the reader leaves out is not looked at.
 */
#ifndef vtkNexradEchoClasses_h
#define vtkNexradEchoClasses_h

#include "vtkNexradFiltersModule.h" // For export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

class VTKNEXRADFILTERS_EXPORT vtkNexradEchoClasses : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkNexradEchoClasses* New();
  vtkTypeMacro(vtkNexradEchoClasses, vtkPartitionedDataSetCollectionAlgorithm);

  ///@{
  /**
   * How many numbers `REF_class` and `REF_reason` can have, counted from 0.
   */
  static int GetNumberOfEchoClasses();
  static int GetNumberOfEchoReasons();
  ///@}

  ///@{
  /**
   * What a number of `REF_class` or `REF_reason` stands for, as "ground" and "ground texture".
   * nullptr for a number that none has.
   */
  static const char* GetEchoClassName(int echoClass);
  static const char* GetEchoReasonName(int reason);
  ///@}

  /**
   * The class that a reason stands for; -1 for a number that none has.
   */
  static int GetClassOfReason(int reason);

  /**
   * Whether quality control at a level takes out gates of a class before a merge. The levels are
   * those of the option "quality" of the merge: 0 off, 1 standard, 2 strict. False for another
   * level or class.
   */
  static bool IsTakenOut(int quality, int echoClass);

protected:
  vtkNexradEchoClasses() = default;
  ~vtkNexradEchoClasses() override = default;

  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector*) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkNexradEchoClasses(const vtkNexradEchoClasses&) = delete;
  void operator=(const vtkNexradEchoClasses&) = delete;
};

#endif
