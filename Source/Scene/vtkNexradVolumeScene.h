// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradVolumeScene
 * @brief   a merged volume over its map, with colour bar, scales and captions, in a renderer
 *
 * ```
 *   time, moment, sites                     +--+ unit
 *            .-----------.                  |  | 70
 *           / volume      \                 |  | 60
 *      km  /_______________\                |  | ...
 *      20 |  map, radars    |  N            |  | 5
 *         '-----------------'               +--+
 *   note        |--- 100 km ---|
 * ```
 *
 * Input: a merged volume (vtkImageData as vtkNexradDayReader and vtkNexradVolumeReader give it), by
 * SetVolume. The scene has no window: put the renderer of GetRenderer into one. The scene brings
 * itself up to date, and follows the size of the renderer, at the beginning of each rendering.
 * The pictures are those of the program's command `render`, pixel for pixel, when the window has 4
 * multisamples, is off screen and is read from its back buffer.
 *
 * Scene coordinates are kilometres east and north of the centre of the volume's projection, and
 * kilometres above mean sea level times the exaggeration.
 *
 * Errors: a volume without voxels or scalars; a preset that does not exist, or that is of another
 * moment than the volume's; a file that is no colour map; a plan view of an array that the volume
 * does not have, or at a height outside of it, or an echo top or liquid of another moment than REF;
 * an array for colours that it does not have; a crop box without an inside; a clip plane without a
 * direction. After an error the scene shows what it showed before.
 */
#ifndef vtkNexradVolumeScene_h
#define vtkNexradVolumeScene_h

#include "vtkNew.h"               // For members
#include "vtkNexradSceneModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For members

#include <memory>   // For members
#include <optional> // For arguments
#include <string>   // For arguments

class vtkCamera;
class vtkImageData;
class vtkNexradTransferFunction;
class vtkRenderer;

namespace nexrad
{
struct BoxRequest;
namespace scene // as VTK's wrapper reads it
{
class RadarScene;
class SceneFrame;
struct CameraView;
struct DrawingOptions;
struct EchoExtent;
struct SceneContents;
struct SceneOptions;
} // namespace scene
} // namespace nexrad

class VTKNEXRADSCENE_EXPORT vtkNexradVolumeScene : public vtkObject
{
public:
  static vtkNexradVolumeScene* New();
  vtkTypeMacro(vtkNexradVolumeScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The renderer that the scene fills, to be put into a window. By default one of the scene's own.
   * The scene sets its background and its active camera.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  ///@{
  /**
   * The volume that is shown. It is not changed. None by default: the scene is empty.
   */
  void SetVolume(vtkImageData* volume);
  vtkImageData* GetVolume() const;
  ///@}

  ///@{
  /**
   * A finer volume of the same moment and projection, as vtkNexradDayReader::MergeBox gives it,
   * that is drawn in place of the part of the volume within its bounds. Each of the two has light
   * of its own: neither casts a shadow on the other, and the shadow on the ground is that of the
   * volume. A plan view does not show the finer one. None by default.
   */
  void SetDetail(vtkImageData* detail);
  vtkImageData* GetDetail() const;
  ///@}

  ///@{
  /**
   * Draws the edges of a box of the domain: its west, east, south and north faces, in the units of
   * the volume's x and y. MarkNoBox, the default, draws none.
   */
  void MarkBox(double west, double east, double south, double north);
  void MarkNoBox();
  ///@}

  /**
   * Brings the scene up to date with its settings and its volume. Rendering does so itself. False
   * after an error.
   */
  bool Update();

  ///@{
  /**
   * Sets an option of the picture, and says what it is. The keys and texts are those of `nexrad3d
   * render` (user guide, chapter 4): "rings" and "50km". A flag is "on" or "off", and its key has
   * no "no-" before it: "walls". An empty text is the default. A number is metres, 0 or 1 of a
   * flag, or the place of a name among those of a choice, from 0. GetOption gives a text in its
   * normal form. Error, and nothing changes: an unknown key, or a wrong text.
   */
  void SetOption(const char* key, const char* text);
  void SetOption(const char* key, double number);
  std::string GetOption(const char* key) const;
  ///@}

  /**
   * What the options are, as a JSON array with an object for each: key, option, kind, choices,
   * default, and a sentence ("says").
   */
  static std::string GetOptionTable();

  ///@{
  /**
   * Direction from the centre of the domain to the camera, in degrees clockwise from north: 180
   * looks north. 200 by default.
   */
  void SetAzimuth(double degrees);
  double GetAzimuth() const;
  ///@}

  ///@{
  /**
   * Elevation of the camera above the horizon in degrees, -90 to 90; 90 looks straight down. 35 by
   * default.
   */
  void SetTilt(double degrees);
  double GetTilt() const;
  ///@}

  ///@{
  /**
   * Magnification: 1 shows the whole domain, 2 half of its width. From 0.01 to 1000; 1 by default.
   */
  void SetZoom(double zoom);
  double GetZoom() const;
  ///@}

  ///@{
  /**
   * Parallel in place of perspective projection. Off by default.
   */
  void SetParallelProjection(bool on);
  bool GetParallelProjection() const;
  vtkBooleanMacro(ParallelProjection, bool);
  ///@}

  ///@{
  /**
   * Name of a preset of vtkNexradTransferFunction, as "storm cores". Empty by default: the first
   * preset of the moment that is shown.
   */
  void SetPreset(std::string name);
  std::string GetPreset() const;
  ///@}

  /**
   * Colours and opacities in use, which may be changed. Null before the first volume is shown;
   * another object once another moment, preset or colour file is shown.
   */
  vtkNexradTransferFunction* GetTransferFunction() const;

  /**
   * Drops changes of the colours and opacities in use: the next Update makes them anew from the
   * options. GetTransferFunction then returns another object.
   */
  void ResetTransferFunction();

  ///@{
  /**
   * Takes the echo of a volume into the frame, which then stays the same whatever volumes are
   * shown: a movie has one frame for all of its times. ClearFrame: of none any more.
   */
  void AddToFrame(vtkImageData* volume);
  void ClearFrame();
  ///@}

  ///@{
  /**
   * The place in the middle of the picture: x and y in the units of the volume (m east and north of
   * the projection's centre, or degrees), or latitude and longitude in degrees; the height in m
   * above mean sea level. The camera moves sideways to it; direction, tilt and magnification stay.
   * None by default, and after LookAtDomain: the domain fills the picture at a zoom of 1. Error,
   * with the next picture: latitude and longitude for a volume without a projection.
   */
  void SetLookAt(double x, double y, double height);
  void SetLookAtGeographic(double latitude, double longitude, double height);
  void LookAtDomain();
  ///@}

  ///@{
  /**
   * The place in the middle of the picture, likewise. False when there is none, or no volume to
   * find it in; then `place` stays as it was.
   */
  bool GetLookAt(double place[3]);
  bool GetLookAtGeographic(double place[3]);
  ///@}

  ///@{
  /**
   * Whether the part of the volume within CropBounds alone is shown. Off by default.
   */
  vtkSetMacro(Cropping, bool);
  vtkGetMacro(Cropping, bool);
  vtkBooleanMacro(Cropping, bool);
  ///@}

  ///@{
  /**
   * Faces of the crop box: west, east, south, north in x and y of the volume (m, or degrees on
   * geographic axes), bottom and top in m above mean sea level. Each upper face must be above the
   * lower one. By default 10 000 km to each side, which cuts nothing.
   */
  vtkSetVector6Macro(CropBounds, double);
  vtkGetVector6Macro(CropBounds, double);
  ///@}

  /**
   * The part of the volume that walls and scales stand about, as CropBounds has it: a crop box to
   * start with. False before the first picture.
   */
  bool GetFrameBounds(double bounds[6]);

  ///@{
  /**
   * Whether the part of the volume in front of the clip plane alone is shown. Off by default.
   */
  vtkSetMacro(Clipping, bool);
  vtkGetMacro(Clipping, bool);
  vtkBooleanMacro(Clipping, bool);
  ///@}

  ///@{
  /**
   * The clip plane: a point of it, and its normal, which points to the part that is shown; both in
   * the coordinates of the volume (x, y, height above mean sea level), where heights are not
   * stretched. (0, 0, 0) and (0, 1, 0) by default: the northern half.
   */
  vtkSetVector3Macro(ClipOrigin, double);
  vtkGetVector3Macro(ClipOrigin, double);
  vtkSetVector3Macro(ClipNormal, double);
  vtkGetVector3Macro(ClipNormal, double);
  ///@}

  ///@{
  /**
   * Whether the line from SectionA to SectionB is drawn on the ground, with the names A and B at
   * its ends. vtkNexradVerticalSection gives what stands above it. Off by default.
   */
  vtkSetMacro(Section, bool);
  vtkGetMacro(Section, bool);
  vtkBooleanMacro(Section, bool);
  ///@}

  ///@{
  /**
   * The ends of that line in x and y of the volume (m, or degrees on geographic axes). (0, 0) by
   * default.
   */
  vtkSetVector2Macro(SectionA, double);
  vtkGetVector2Macro(SectionA, double);
  vtkSetVector2Macro(SectionB, double);
  vtkGetVector2Macro(SectionB, double);
  ///@}

  /**
   * x and y of the volume where the line of sight through a pixel of the renderer's window (from
   * its lower left corner) meets the ground, which may be beyond the domain. False where it meets
   * the sky, and before the first picture.
   */
  bool FindGround(double pixelX, double pixelY, double point[2]);

  /**
   * The pixel of the renderer's window, from its lower left corner, where a place of the ground
   * (x and y of the volume) is. False before the first picture.
   */
  bool FindPixel(double x, double y, double pixel[2]);

  ///@{
  /**
   * Scene coordinates of a point in the coordinates of the volume (x, y, height above mean sea
   * level), for props that are added to the renderer; and the other way. False before the first
   * picture.
   */
  bool VolumeToScene(const double point[3], double scenePoint[3]);
  bool SceneToVolume(const double scenePoint[3], double point[3]);
  ///@}

#ifndef __VTK_WRAP__
  ///@{
  /// All settings of the scene, and those of the camera, as one value.
  void SetOptions(const nexrad::scene::SceneOptions& options);
  nexrad::scene::SceneOptions GetOptions() const;
  void SetView(const nexrad::scene::CameraView& view);
  const nexrad::scene::CameraView& GetView() const;
  ///@}
  /// As Update, but throws Error where Update reports one.
  void Draw();
  /// How the volume stands in the scene; for the parts of this module. Null before the first volume
  /// is shown.
  const nexrad::scene::SceneFrame* GetSceneFrame() const;
  /// The part of the domain that the picture shows as it was drawn last, in voxels of the size of
  /// its pixels. Nothing where those of the volume are hardly larger, and where the picture shows
  /// no part of a volume, or a map.
  std::optional<nexrad::BoxRequest> SeenBox() const;
  /// The frame is that of this echo, as after AddToFrame.
  void HoldEcho(const std::optional<nexrad::scene::EchoExtent>& echo);
#endif

  /**
   * Points the camera straight down, north up, in parallel projection.
   */
  void SetCameraFromAbove();

protected:
  vtkNexradVolumeScene();
  ~vtkNexradVolumeScene() override;

  bool Cropping = false;
  double CropBounds[6] = {-1e7, 1e7, -1e7, 1e7, -1e7, 1e7};
  bool Clipping = false;
  double ClipOrigin[3] = {0.0, 0.0, 0.0};
  double ClipNormal[3] = {0.0, 1.0, 0.0};
  bool Section = false;
  double SectionA[2] = {0.0, 0.0};
  double SectionB[2] = {0.0, 0.0};

private:
  vtkNexradVolumeScene(const vtkNexradVolumeScene&) = delete;
  void operator=(const vtkNexradVolumeScene&) = delete;

  nexrad::scene::DrawingOptions Asked() const;
  vtkMTimeType TimeOfSettings();
  template <typename Held, typename Value>
  void Set(Held& held, const Value& value);
  void ObserveRenderer();
  void ForgetRenderer();
  void FollowRendering(); // before each picture

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkCamera> Camera; // that of the renderer
  unsigned long RendererTag = 0;
  std::unique_ptr<nexrad::scene::SceneContents> Wanted; // but what is cut away
  std::unique_ptr<nexrad::scene::RadarScene> Drawn;     // null before the first picture
  vtkMTimeType Tried = 0; // time of the settings that the last update was for
  bool Succeeded = true;
};

#endif
