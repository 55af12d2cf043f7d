// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradNavigator
 * @brief   moves the camera of a vtkNexradVolumeScene as a pointer in its picture asks
 *
 * It sets Azimuth, Tilt, Zoom and LookAt of the scene, which draws the change with its next
 * picture. Places of the picture are pixels of the scene's renderer from its lower left corner.
 * What is at such a place is what vtkNexradEchoPicker finds there; where it finds nothing, a place
 * as far away as the middle of the domain.
 */
#ifndef vtkNexradNavigator_h
#define vtkNexradNavigator_h

#include "vtkNew.h"               // For members
#include "vtkNexradSceneModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For members

class vtkNexradEchoPicker;
class vtkNexradVolumeScene;

class VTKNEXRADSCENE_EXPORT vtkNexradNavigator : public vtkObject
{
public:
  static vtkNexradNavigator* New();
  vtkTypeMacro(vtkNexradNavigator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scene whose camera is moved. None by default: nothing moves.
   */
  void SetScene(vtkNexradVolumeScene* scene);
  vtkNexradVolumeScene* GetScene() const;
  ///@}

  ///@{
  /**
   * Grab takes hold of what is at a place of the picture. Pan moves the camera sideways until that
   * is at another place.
   */
  void Grab(double x, double y);
  void Pan(double x, double y);
  ///@}

  /**
   * Changes the magnification by a factor above 0, within 0.1 to 100. What is at a place of the
   * picture stays there.
   */
  void ZoomAt(double x, double y, double factor);

  /**
   * Changes the magnification about the middle of the picture.
   */
  void Zoom(double factor);

  /**
   * Moves what is at a place of the picture into its middle. The camera turns about it from then
   * on. Returns what it is: a vtkNexradEchoPicker::FoundType. Nothing moves where there is nothing.
   */
  int CentreOn(double x, double y);

  /**
   * Turns the camera clockwise and raises it, in degrees. Once the camera looks at a place, it
   * turns about that place, which keeps its size; after Pan and ZoomAt, about what is in the middle
   * of the picture. Before, the domain fills the picture from every side.
   */
  void Turn(double azimuth, double tilt);

protected:
  vtkNexradNavigator();
  ~vtkNexradNavigator() override;

private:
  vtkNexradNavigator(const vtkNexradNavigator&) = delete;
  void operator=(const vtkNexradNavigator&) = delete;

  bool IsReady();
  void FindPoint(double x, double y, double point[3]);
  void KeepAt(const double point[3], double x, double y);
  void SetSizeAt(const double point[3], double size);
  bool FindPivot(double point[3]);
  void SetZoom(double zoom);

  vtkSmartPointer<vtkNexradVolumeScene> Scene;
  vtkNew<vtkNexradEchoPicker> Picker;
  double Grabbed[3] = {0.0, 0.0, 0.0}; // in the scene
  bool Moved = false;                  // sideways, since LookAt was what the camera turns about
};

#endif
