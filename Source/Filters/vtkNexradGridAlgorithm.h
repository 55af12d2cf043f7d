// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradGridAlgorithm
 * @brief   what the algorithms that make a merged volume have in common
 *
 * Which grid, which moment, by which method. The output is the vtkImageData that
 * vtkNexradImageConversion.h describes.
 *
 * ```
 *      +----------------------+ HeightRange[1]      the box round the circles of Range
 *      |  .--.        .--.    |                     about all sites, or GeographicBounds;
 *      | ( o  )      ( o  )   |                     Dimensions voxels in it, points at
 *      |  '--'        '--'    |                     their centres
 *      +----------------------+ HeightRange[0]
 * ```
 */
#ifndef vtkNexradGridAlgorithm_h
#define vtkNexradGridAlgorithm_h

#include "vtkImageAlgorithm.h"
#include "vtkNexradFiltersModule.h" // For export macro

#include <string> // For members

namespace nexrad
{
enum class MomentName : unsigned char;
struct GridRequest;
struct GridSpecification;
struct MergeRequest;
} // namespace nexrad

class VTKNEXRADFILTERS_EXPORT vtkNexradGridAlgorithm : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkNexradGridAlgorithm, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * THESIS: the bin average of Formulas T1 to T7, on reflectivity limited to 0 to 80 dBZ.
   */
  enum MergeMethod
  {
    THESIS = 0
  };

  /**
   * PROJECTED: metres east and north of the domain's centre in the azimuthal equidistant
   * projection of WGS84. GEOGRAPHIC: degrees of longitude and latitude, as the thesis has them.
   */
  enum AxesType
  {
    PROJECTED = 0,
    GEOGRAPHIC = 1
  };

  ///@{
  /**
   * Voxels along x, y and z. 256, 256, 128 by default; each at least 1.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Radius in metres of the circle about each site that the grid must hold. 230 000 by default.
   */
  vtkSetMacro(Range, double);
  vtkGetMacro(Range, double);
  ///@}

  ///@{
  /**
   * Lower and upper face of the grid in metres above mean sea level. 0 and 20 000 by default.
   */
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  ///@}

  ///@{
  /**
   * West, south, east and north outer faces in degrees, in place of the box about the sites when
   * UseGeographicBounds is on. Off by default.
   */
  vtkSetVector4Macro(GeographicBounds, double);
  vtkGetVector4Macro(GeographicBounds, double);
  vtkSetMacro(UseGeographicBounds, bool);
  vtkGetMacro(UseGeographicBounds, bool);
  vtkBooleanMacro(UseGeographicBounds, bool);
  ///@}

  ///@{
  /**
   * What x and y mean. PROJECTED by default.
   */
  vtkSetClampMacro(Axes, int, PROJECTED, GEOGRAPHIC);
  vtkGetMacro(Axes, int);
  void SetAxesToProjected() { this->SetAxes(PROJECTED); }
  void SetAxesToGeographic() { this->SetAxes(GEOGRAPHIC); }
  ///@}

  ///@{
  /**
   * Name of the moment: "REF" (the default). THESIS knows no other.
   */
  vtkSetMacro(Moment, std::string);
  vtkGetMacro(Moment, std::string);
  ///@}

  ///@{
  /**
   * The method, THESIS by default. An unknown one is refused with an error, and the method stays.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToThesis() { this->SetMethod(THESIS); }
  ///@}

protected:
  vtkNexradGridAlgorithm();
  ~vtkNexradGridAlgorithm() override;

  /**
   * The moment. Throws nexrad::Error for one that the method does not know.
   */
  nexrad::MomentName CheckMoment() const;

  nexrad::GridRequest MakeGridRequest() const;

  /**
   * A request for the time, in seconds since 1970-01-01T00:00:00Z; `maximumGap` in seconds.
   */
  nexrad::MergeRequest MakeMergeRequest(
    const nexrad::GridSpecification& grid, double time, double maximumGap) const;

  /**
   * Sets the output's extent from Dimensions, where the sites are not known before the data are.
   */
  void SetOutputExtent(vtkInformation* outputInformation) const;

  /**
   * Sets the error code and gives the error. Returns 0, for a request that failed.
   */
  int Fail(unsigned long code, const std::string& line);

  int Dimensions[3] = {256, 256, 128};
  double Range = 230000.0;
  double HeightRange[2] = {0.0, 20000.0};
  double GeographicBounds[4] = {0.0, 0.0, 0.0, 0.0};
  bool UseGeographicBounds = false;
  int Axes = PROJECTED;
  std::string Moment = "REF";
  int Method = THESIS;

private:
  vtkNexradGridAlgorithm(const vtkNexradGridAlgorithm&) = delete;
  void operator=(const vtkNexradGridAlgorithm&) = delete;
};

#endif
