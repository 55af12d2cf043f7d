// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradEchoPicker
 * @brief   what a vtkNexradVolumeScene shows at a place of its picture
 *
 * ```
 *   picker = vtknexrad.vtkNexradEchoPicker()
 *   picker.SetScene(scene)
 *   if picker.Pick(x, y, 0, scene.GetRenderer()) == picker.ECHO:
 *       print(picker.GetText())
 * ```
 *
 * It finds the echo that is seen at a pixel: the place on the ray of view in front of which half of
 * the ray's opacity lies, as the transfer function of the scene has it. Where the ray's opacity is
 * below 0.1, and where the scene shows a plan view, it finds the place on the ground. The height of
 * the ground is that of the bottom of the volume. Where neither is, and as long as the renderer is
 * in no window, it finds nothing.
 *
 * The radar is the one that scanned the voxel from nearest (array `_site`); of a volume without
 * this array, the nearest radar of the volume that the site table knows.
 */
#ifndef vtkNexradEchoPicker_h
#define vtkNexradEchoPicker_h

#include "vtkAbstractPicker.h"
#include "vtkNexradSceneModule.h" // For export macro
#include "vtkSmartPointer.h"      // For members

#include <string> // For members

class vtkNexradVolumeScene;

class VTKNEXRADSCENE_EXPORT vtkNexradEchoPicker : public vtkAbstractPicker
{
public:
  static vtkNexradEchoPicker* New();
  vtkTypeMacro(vtkNexradEchoPicker, vtkAbstractPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FoundType
  {
    NOTHING = 0,
    GROUND = 1,
    ECHO = 2
  };

  ///@{
  /**
   * The scene that is asked. None by default: nothing is found.
   */
  void SetScene(vtkNexradVolumeScene* scene);
  vtkNexradVolumeScene* GetScene() const;
  ///@}

  /**
   * Looks for what is seen at a pixel of the renderer, counted from its lower left corner; the
   * third number is not used. Returns what was found. GetPickPosition gives its place in the scene.
   */
  int Pick(double x, double y, double z, vtkRenderer* renderer) override;

  /**
   * The same, of the ground alone: whatever echo lies before it.
   */
  int PickGround(double x, double y, vtkRenderer* renderer);

  /**
   * What the last Pick found. NOTHING before the first.
   */
  vtkGetMacro(Found, int);

  /**
   * Place of what was found: x and y in the units of the volume, height in m above mean sea level.
   */
  vtkGetVector3Macro(Place, double);

  ///@{
  /**
   * Latitude and longitude of what was found, in degrees; NaN for a volume without a projection.
   */
  vtkGetMacro(Latitude, double);
  vtkGetMacro(Longitude, double);
  ///@}

  ///@{
  /**
   * Of an echo: the value of the moment there, in its unit, and the name of the moment, as "REF".
   * NaN and empty for the ground.
   */
  vtkGetMacro(Value, double);
  vtkGetMacro(ArrayName, std::string);
  vtkGetMacro(Units, std::string);
  ///@}

  ///@{
  /**
   * Name of the radar, empty where none is known; its distance along the ground in m, and the
   * direction from it in degrees clockwise from north, both NaN where its position is not known.
   */
  vtkGetMacro(SiteName, std::string);
  vtkGetMacro(SiteDistance, double);
  vtkGetMacro(SiteAzimuth, double);
  ///@}

  ///@{
  /**
   * Of an echo in a volume with ancillary arrays: how many radars scanned it, 0 when unknown, and
   * the time in seconds between the volume's time and the nearest ray, NaN when unknown.
   */
  vtkGetMacro(NumberOfRadars, int);
  vtkGetMacro(Age, double);
  ///@}

  /**
   * All of it as one line, as "41.5 dBZ (REF), 35.333° N 97.278° W, 4.2 km above sea level, KTLX 43
   * km 238°". Empty where nothing was found. The value is in the unit of the colour bar, as knots
   * where a table of GRLevelX says so; GetValue and GetUnits have that of the volume.
   */
  std::string GetText() const;

protected:
  vtkNexradEchoPicker();
  ~vtkNexradEchoPicker() override;

  int Found = NOTHING;
  double Place[3] = {0.0, 0.0, 0.0};
  double Latitude;
  double Longitude;
  double Value;
  std::string ArrayName;
  std::string Units;
  std::string SiteName;
  double SiteDistance;
  double SiteAzimuth;
  int NumberOfRadars = 0;
  double Age;

private:
  vtkNexradEchoPicker(const vtkNexradEchoPicker&) = delete;
  void operator=(const vtkNexradEchoPicker&) = delete;

  int Look(double x, double y, vtkRenderer* renderer, bool forEcho);
  void Forget();
  void FindRadar();

  vtkSmartPointer<vtkNexradVolumeScene> Scene;
};

#endif
