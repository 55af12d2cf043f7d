// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradTimeText
 * @brief   the time of a merged volume or of sweeps in UTC, as a text
 *
 * Input: a merged volume, whose field data have its time (TimeValue) and its radars (Sites), or
 * sweeps, whose field data have the time of their first ray (StartTime) and their radar (Site).
 * Output: a table of one text, as ParaView's text representations take it:
 *
 *     2006-03-12 18:05:00 UTC
 *     KEAX KILX KLSX
 *     SYNTHETIC
 *
 * The last line stands there where the data were simulated. Further lines say what there is in a
 * volume of which the usual preset of its moment shows nothing, or next to nothing. Without a time
 * in the field data the time is that of the pipeline, in seconds since 1970-01-01T00:00:00Z.
 */
#ifndef vtkNexradTimeText_h
#define vtkNexradTimeText_h

#include "vtkNexradAnnotationsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class VTKNEXRADANNOTATIONS_EXPORT vtkNexradTimeText : public vtkTableAlgorithm
{
public:
  static vtkNexradTimeText* New();
  vtkTypeMacro(vtkNexradTimeText, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the names of the radars stand below the time. On by default.
   */
  vtkSetMacro(Radars, bool);
  vtkGetMacro(Radars, bool);
  vtkBooleanMacro(Radars, bool);
  ///@}

protected:
  vtkNexradTimeText();
  ~vtkNexradTimeText() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  bool Radars = true;

private:
  vtkNexradTimeText(const vtkNexradTimeText&) = delete;
  void operator=(const vtkNexradTimeText&) = delete;
};

#endif
