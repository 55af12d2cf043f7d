// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/ColourField.h"
#include "Scene/DetailVolume.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/EchoExtent.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/GroundPicture.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"
#include "nexrad/Grid/FinerBox.h"
#include "vtkNexradTransferFunction.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkProp;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

namespace nexrad::scene
{

struct PlanView;

/// What a scene shows, and how.
struct SceneContents
{
  SceneOptions options;
  CameraView view;
  /// A merged volume: vtkImageData in m (or degrees and m) with the moment as active scalars and
  /// field data as the project's filters write them.
  vtkSmartPointer<vtkImageData> volume;
  vtkSmartPointer<vtkImageData> detail; ///< a finer one, drawn in place of what lies in its bounds
  std::optional<std::array<double, 4>> mark; ///< box: west, east, south and north, in its units
  std::optional<EchoExtent> held; ///< is framed, whatever volumes are shown; empty: the echo of the
                                  ///< first, which grows where that of another leaves it
};

/// The drawing of a vtkNexradVolumeScene: a merged volume over its map, with colour bar, scales and
/// captions. It fills a renderer, and follows what is asked of the scene as long as it can: its
/// volume stays in texture memory.
class RadarScene
{
public:
  /// Fills the renderer in place of the drawing before, if there is one, which gives its letters
  /// and the colours in use. Throws Error, and leaves that as it is, for contents that cannot be
  /// drawn (vtkNexradVolumeScene).
  RadarScene(
    const SceneContents& contents, vtkRenderer* renderer, std::unique_ptr<RadarScene>& before);
  /// Takes out of the renderer what it put in.
  ~RadarScene();
  RadarScene(const RadarScene&) = delete;
  RadarScene& operator=(const RadarScene&) = delete;

  /// Whether Follow brings the drawing to other contents; else it has to be made anew.
  bool CanFollow(const SceneContents& contents) const;
  /// Draws what differs. Throws Error, as above.
  void Follow(const SceneContents& contents);
  /// The next contents are framed by the echo that they hold, or by that of their own volume.
  void HoldEcho(const std::optional<EchoExtent>& held);

  /// Throws Error for what a scene with these options would throw for.
  static void Check(const SceneOptions& options, vtkImageData* volume);

  /// Colours and opacities (where another array gives the colours, its opacities alone are used),
  /// which may be changed; Follow draws the change.
  vtkNexradTransferFunction* TransferFunction() const { return transferFunction; }
  /// They are made anew by the next contents.
  void ResetColours() { remakeColours = true; }

  /// How volume and scene belong together.
  const SceneFrame& Frame() const { return frame; }
  /// The part of the domain that the picture shows, in voxels of the size of its pixels. Nothing
  /// where those of the volume are hardly larger, and where the picture shows no part of it, or a
  /// map.
  std::optional<BoxRequest> SeenBox() const;

  /// Draws for another size of the renderer, if it has one: letters grow with its height.
  void FollowSize();
  /// At the beginning of each frame: takes out voxels of a volume that has more of them than OpenGL
  /// takes, and brings the shadow on the ground up to date.
  void BeginFrame();

private:
  struct Prepared;
  static Prepared Prepare(
    const SceneOptions& options, vtkImageData* volume, const std::string& ofArray);

  bool IsOther(vtkImageData* data) const;
  bool OtherColours(const SceneOptions& other) const;
  void SetColours(const SceneOptions& other);
  void FollowColours();
  void ShowVolume(Prepared prepared);
  void ShowAgain();
  void SetDetail(vtkImageData* newDetail);
  void SetMark(const std::optional<std::array<double, 4>>& faces);
  SceneFrame FollowEcho(vtkImageData* data, const VolumeInformation& read);
  void Replace(SceneLayer& layer, SceneLayer replacement);
  void TransferFunctionChanged();
  void FollowIsoValues();
  void DrawGround();
  void DrawSection();
  void DrawScales();
  void FillProperty();
  void SetCut(const CutOptions& cut);
  vtkImageData* Drawn() const;
  void UpdateSlices();
  double PixelsOf(double length) const;
  void DrawVolume(vtkImageData* placed, bool sameMapper);
  void DrawPlan(const PlanView& shown, vtkImageData* placed);
  void CheckSize() const;
  void PlaceDetail();
  void DrawMark();
  std::vector<vtkVolumeMapper*> Mappers() const;
  void ShadeGround();
  void LookForEcho();
  void DrawCaptions();
  void Aim();
  void DrawLabels();
  void FitClippingRange();
  int TextSize() const;

  SceneOptions options;
  const Theme& theme;
  std::array<int, 2> size = {1280, 720};
  CameraView view;
  SceneFrame frame;
  std::optional<EchoExtent> echo;
  bool holdsEcho = false;                  ///< and measures none
  bool reframed = false;                   ///< since the volume was shown
  vtkSmartPointer<vtkImageData> shownData; ///< as it was given
  vtkMTimeType shownTime = 0;              ///< of it, then
  VolumeInformation information;
  vtkSmartPointer<vtkRenderer> renderer;
  vtkNew<vtkVolume> volume;
  DetailVolume detail;
  vtkSmartPointer<vtkImageData> detailData;       ///< as it was given
  std::optional<std::array<double, 4>> markFaces; ///< in the volume's units
  vtkSmartPointer<vtkNexradTransferFunction> transferFunction;
  vtkMTimeType colourTime = 0; ///< of it, when it was drawn
  bool remakeColours = false;
  std::string array;                ///< that is shown
  std::optional<ColourField> field; ///< where another array gives the colours
  ColourScale scale;
  std::string note;                        ///< what the heights are, or which voxels a map shows
  std::vector<std::optional<double>> ages; ///< min, of the radars' data
  std::string nothing;                     ///< what is said where nothing is to be seen
  TextPictures pictures;
  SceneLayer plan;
  SceneLayer ground; ///< the ground itself is the first
  GroundShadow groundShadow;
  SceneLayer section; ///< its line on the ground
  SceneLayer scales;
  SceneLayer mark;
  SceneLayer captions;
  SceneLayer labels;
  std::vector<ScenePoint> outline;   ///< of the domain and its scales
  std::vector<PixelBox> taken;       ///< by captions
  std::optional<PixelBox> overScene; ///< by the words where nothing is to be seen
  double right = 0.0;                ///< pixels, of what is left of the colour bar
};

} // namespace nexrad::scene
