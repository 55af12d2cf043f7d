// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradMoments
 * @brief   names, units and titles of the moments that the classes know
 *
 * The names are those of the arrays: REF, VEL, SW, ZDR, PHI, RHO and CFP, which radars measure, and
 * SRV, AZSHEAR, DIV and KDP, which are derived of them.
 *
 * Nothing is set up: the functions are static.
 */
#ifndef vtkNexradMoments_h
#define vtkNexradMoments_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkObject.h"

class VTKNEXRADIO_EXPORT vtkNexradMoments : public vtkObject
{
public:
  static vtkNexradMoments* New();
  vtkTypeMacro(vtkNexradMoments, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many moments there are, and the name of each, counted from 0; nullptr for another number.
   */
  static int GetNumberOfMoments();
  static const char* GetMomentName(int index);
  ///@}

  ///@{
  /**
   * The unit of a moment, as "dBZ", empty for RHO, which has none; and what it is called, as
   * "Reflectivity". nullptr for a name that is no moment's.
   */
  static const char* GetUnit(const char* moment);
  static const char* GetTitle(const char* moment);
  ///@}

  /**
   * Whether values lie to both sides of 0 and the strongest is that farthest from 0: VEL, SRV,
   * AZSHEAR and DIV.
   */
  static bool HasTwoSigns(const char* moment);

protected:
  vtkNexradMoments() = default;
  ~vtkNexradMoments() override = default;

private:
  vtkNexradMoments(const vtkNexradMoments&) = delete;
  void operator=(const vtkNexradMoments&) = delete;
};

#endif
