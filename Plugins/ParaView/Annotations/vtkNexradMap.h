// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradMap
 * @brief   the map under a merged volume, as polygonal data in the volume's coordinates
 *
 * Input: a vtkImageData of vtkNexradDayReader or of a .nxv file, whose field data name its
 * projection and its radars. Output: the borders of countries, states and counties that lie under
 * the volume, names of towns, and for each of its radars a disc, its name and rings of range.
 * Everything lies at the volume's lower face, in its units of x and y, and is cut at its outer
 * faces.
 *
 * The cell array MapColor has a colour (three bytes) for each line, disc and letter; MapKind says
 * what each is: 0 country or coast, 1 state, 2 county, 3 ring, 4 radar and its name, 5 town and its
 * name. A volume without a projection gives an empty output. Of several processes the first makes
 * all of it.
 */
#ifndef vtkNexradMap_h
#define vtkNexradMap_h

#include "vtkNexradAnnotationsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class MapBuilder;
class vtkImageData;

class VTKNEXRADANNOTATIONS_EXPORT vtkNexradMap : public vtkPolyDataAlgorithm
{
public:
  static vtkNexradMap* New();
  vtkTypeMacro(vtkNexradMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MapKindType
  {
    COUNTRY = 0,
    STATE = 1,
    COUNTY = 2,
    RING = 3,
    RADAR = 4,
    TOWN = 5
  };

  ///@{
  /**
   * Whether the borders of states and provinces, and those of counties, are there. On by default.
   * Counties are there only where the volume is small enough to tell them apart.
   */
  vtkSetMacro(States, bool);
  vtkGetMacro(States, bool);
  vtkBooleanMacro(States, bool);
  vtkSetMacro(Counties, bool);
  vtkGetMacro(Counties, bool);
  vtkBooleanMacro(Counties, bool);
  ///@}

  ///@{
  /**
   * Whether the radars with their names, and the largest towns whose names have room, are there. On
   * by default.
   */
  vtkSetMacro(Radars, bool);
  vtkGetMacro(Radars, bool);
  vtkBooleanMacro(Radars, bool);
  vtkSetMacro(Towns, bool);
  vtkGetMacro(Towns, bool);
  vtkBooleanMacro(Towns, bool);
  ///@}

  ///@{
  /**
   * Rings of range stand about each radar at the multiples of this distance in metres, up to
   * 230 km. 0, none, by default.
   */
  vtkSetClampMacro(RingSpacing, double, 0.0, 230000.0);
  vtkGetMacro(RingSpacing, double);
  ///@}

  ///@{
  /**
   * Height of the letters of the radars' names as a part of the longer side of the volume. 0.02 by
   * default.
   */
  vtkSetClampMacro(LetterHeight, double, 0.001, 0.2);
  vtkGetMacro(LetterHeight, double);
  ///@}

protected:
  vtkNexradMap();
  ~vtkNexradMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  bool States = true;
  bool Counties = true;
  bool Radars = true;
  bool Towns = true;
  double RingSpacing = 0.0;
  double LetterHeight = 0.02;

private:
  void AddLines(MapBuilder& builder);
  void AddNames(MapBuilder& builder, vtkImageData* volume);

  vtkNexradMap(const vtkNexradMap&) = delete;
  void operator=(const vtkNexradMap&) = delete;
};

#endif
