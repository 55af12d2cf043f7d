// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/ColourField.h"
#include "Scene/DetailVolume.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/EchoExtent.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/GroundShadow.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkNexradTransferFunction;
class vtkProp;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

namespace nexrad::scene
{

struct PlanView;

/// A merged volume over its map, with colour bar, scales and captions. It fills a renderer and
/// knows no window, so that pictures, movies and a viewer can share it.
class RadarScene
{
public:
  /// Fills the renderer.
  RadarScene(const SceneOptions& options, vtkRenderer* renderer);
  /// Takes out of the renderer what it put in.
  ~RadarScene();
  RadarScene(const RadarScene&) = delete;
  RadarScene& operator=(const RadarScene&) = delete;

  /// Size of the picture in pixels; letters grow with its height.
  void SetPictureSize(const std::array<int, 2>& size);
  void SetCamera(const CameraView& view);

  /// Shows a merged volume, or the map of it that the options ask for: vtkImageData in m (or
  /// degrees and m) with the moment as active scalars and field data as the project's filters write
  /// them. It is not changed. Throws Error when it has no voxels or no scalars, and for a map or an
  /// array of colours that it cannot give.
  void SetVolume(vtkImageData* volume);

  /// Shows a finer volume in place of the part of the volume within its bounds; nullptr: none. A
  /// map does not show it. Throws Error when it is none of the volume's moment in its projection,
  /// and as SetVolume does.
  void SetDetail(vtkImageData* detail);

  /// Draws the edges of a box of the domain: west, east, south and north faces in the volume's
  /// units, and names the time of the finer volume there. Empty: of none.
  void MarkBox(const std::optional<std::array<double, 4>>& faces);

  /// Throws Error for whatever a scene with these options would throw for in SetVolume.
  static void Check(const SceneOptions& options, vtkImageData* volume);

  /// Name of the array that is shown, as "REF"; empty before the first volume.
  const std::string& Array() const { return array; }

  /// Colours and opacities (where another array gives the colours, its opacities alone are used),
  /// those of another moment from the volume on that is the first of it;
  /// after a change of them TransferFunctionChanged brings the scene up to date.
  vtkNexradTransferFunction* TransferFunction() const { return transferFunction; }
  /// Makes them anew, for the moment that is shown, of the preset, the file and the iso-values of
  /// other options; TransferFunctionChanged draws them. Throws Error, and changes nothing, for what
  /// MakeTransferFunction throws for.
  void SetColours(const SceneOptions& other);
  /// Takes over those that another scene has for the moment of that array.
  void SetTransferFunction(vtkNexradTransferFunction* function, const std::string& ofArray);
  /// The pictures of letters that were drawn so far, for another scene: they take long to draw.
  TextPictures TakeLetters() { return std::move(pictures); }
  void SetLetters(TextPictures letters) { pictures = std::move(letters); }
  void TransferFunctionChanged();

  const SceneOptions& Options() const { return options; }
  /// Whether SetColours and Follow bring the scene to other options: its volume stays in texture
  /// memory. Else it has to be made anew.
  bool CanFollow(const SceneOptions& other) const;
  /// Takes over the number of slices, the light that the volume stands in, what is cut away, and
  /// the line of a section on the ground, where they differ. Throws Error for a cut that cannot be.
  void Follow(const SceneOptions& other);

  /// Frames that echo, whatever the volumes from the next on show. Nothing: that of the first
  /// volume of a grid and a moment, which grows where the echo of another leaves it.
  void HoldEcho(const std::optional<EchoExtent>& held);

  /// x and y of the volume where a line of sight meets the ground, which may be beyond the domain;
  /// nothing where it meets the sky. The pixel counts from the lower left corner.
  std::optional<std::array<double, 2>> GroundAt(const std::array<double, 2>& pixel);
  /// The place of the ground in the picture in pixels from the lower left corner.
  std::array<double, 2> PixelOf(const std::array<double, 2>& groundPoint) const;
  /// How volume and scene belong together; that of an empty scene before the first volume.
  const SceneFrame& Frame() const { return frame; }

  /// Takes out voxels of a volume that has more of them than OpenGL takes, and brings the shadow on
  /// the ground up to date. The beginning of each frame does so itself.
  void BeginFrame();

private:
  using Props = std::vector<vtkSmartPointer<vtkProp>>;

  SceneFrame FollowEcho(vtkImageData* data, const VolumeInformation& read);
  void Replace(Props& group, Props replacement);
  void OrderProps();
  void FollowArray(vtkImageData* data);
  void FollowIsoValues();
  void DrawGround();
  void DrawSection();
  void DrawScales();
  void FillProperty();
  void SetCut(const CutOptions& cut);
  void UpdateSlices();
  double PixelsOf(double length) const;
  void DrawVolume(vtkImageData* placed, bool sameMapper);
  void DrawPlan(const PlanView& shown, vtkImageData* placed);
  void FitTexture();
  void PlaceDetail();
  void DrawMark();
  std::vector<vtkVolumeMapper*> Mappers() const;
  void LookForEcho();
  void DrawCaptions();
  void Aim();
  void DrawLabels();
  TextStyle NoteStyle() const;
  void FitClippingRange();
  int TextSize() const;

  SceneOptions options;
  const Theme& theme;
  std::array<int, 2> size = {1280, 720};
  CameraView view;
  SceneFrame frame;
  std::optional<EchoExtent> echo;
  bool holdsEcho = false;                  ///< and measures none
  vtkSmartPointer<vtkImageData> shownData; ///< as it was given
  VolumeInformation information;
  vtkSmartPointer<vtkRenderer> renderer;
  unsigned long startTag = 0; ///< of the observer of the renderer
  vtkNew<vtkVolume> volume;
  DetailVolume detail;
  vtkSmartPointer<vtkImageData> detailData;       ///< as it was given
  std::optional<std::array<double, 4>> markFaces; ///< in the volume's units
  vtkSmartPointer<vtkNexradTransferFunction> transferFunction;
  std::string array;                ///< that is shown
  std::optional<ColourField> field; ///< where another array gives the colours
  ColourScale scale;
  std::string note;                        ///< what the heights are, or which voxels a map shows
  std::vector<std::optional<double>> ages; ///< min, of the radars' data
  std::string thinned;                     ///< what was said of voxels that OpenGL does not take
  std::string nothing;                     ///< what is said where nothing is to be seen
  TextPictures pictures;
  Props plan;
  Props ground; ///< the ground itself is the first
  GroundShadow groundShadow;
  Props section; ///< its line on the ground
  Props scales;
  Props mark;
  Props captions;
  Props labels;
  std::vector<Label> groundLabels;
  std::vector<Label> sectionLabels;
  std::vector<Label> markLabels;
  std::vector<Label> scaleLabels;
  std::vector<ScenePoint> outline;   ///< of the domain and its scales
  std::vector<PixelBox> taken;       ///< by captions
  std::optional<PixelBox> overScene; ///< by the words where nothing is to be seen
  double right = 0.0;                ///< pixels, of what is left of the colour bar
};

} // namespace nexrad::scene
