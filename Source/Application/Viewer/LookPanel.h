// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"
#include "nexrad/Model/Moment.h"

#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class vtkNexradVolumeScene;

namespace nexrad::viewer
{

/// The settings of a scene: how the volume is drawn, its light, its colours, and what stands beside
/// it.
class LookPanel : public QWidget
{
  Q_OBJECT

public:
  /// `scene` must outlive it.
  explicit LookPanel(vtkNexradVolumeScene* scene, QWidget* parent = nullptr);

  /// Shows the settings that the scene has now, for the moment of its volume.
  void Follow();
  /// The moments that the inputs hold, beside those of the volume that is shown.
  void SetMoments(const std::vector<MomentName>& ofInputs) { moments = ofInputs; }
  /// Whether volumes without ancillary arrays can be merged again with them.
  void SetMakesAncillary(bool makes) { makesAncillary = makes; }

signals:
  /// Another moment is to be shown.
  void MomentChosen(const QString& moment);
  /// Another array is to give the colours; empty: the moment itself.
  void ColoursChosen(const QString& array);
  /// Another array is to be shown in maps; empty: the moment itself.
  void MapArrayChosen(const QString& array);
  /// A setting of the scene was changed here.
  void Changed();

private:
  QComboBox* AddBox(QFormLayout* form, const QString& name, const QString& tip,
    const std::function<void(int)>& set);
  QComboBox* AddChoice(QFormLayout* form, const QString& name, const QString& tip,
    const QStringList& entries, const std::function<int()>& get,
    const std::function<void(int)>& set);
  template <typename Choice>
  void AddChoice(QFormLayout* form, const QString& name, const QString& tip,
    const QStringList& entries, Choice scene::SceneOptions::*member);
  void AddSwitch(
    QFormLayout* form, const QString& name, const QString& tip, bool scene::SceneOptions::*member);
  QDoubleSpinBox* AddNumber(QFormLayout* form, const QString& name, const QString& tip,
    double least, double most, double step, const QString& suffix, const QString& automatic,
    const std::function<double()>& get, const std::function<void(double)>& set);
  void AddNumber(QFormLayout* form, const QString& name, const QString& tip, double least,
    double most, double step, const QString& suffix, double& (*member)(scene::SceneOptions&));
  void AddDrawing(QFormLayout* form);
  void AddLight(QFormLayout* form);
  void AddSurroundings(QFormLayout* form);
  void AddMoments(QFormLayout* form);
  void AddMaps(QFormLayout* form);
  void Change(const std::function<void(scene::SceneOptions&)>& change);
  void ChooseView(const std::optional<scene::PlanLevel>& level); ///< nothing: the volume
  void PlaceCamera(bool forMap);
  void FollowPresets();
  void FollowMaps();
  void FollowMoments();
  /// Fills a box with the moment itself, other moments, and the ancillary arrays of the moment, and
  /// shows the array that is chosen (empty: the moment itself). An array that the volume does not
  /// have and that cannot be made is off; its tool tip says why. The data of an entry is its array,
  /// as "REF_age"; empty: the moment itself.
  void OfferArrays(QComboBox* box, const QStringList& others, const std::string& chosen);

  vtkNexradVolumeScene* scene;
  QComboBox* presets = nullptr;
  QComboBox* shownMoment = nullptr;
  QComboBox* colourArray = nullptr;
  QComboBox* views = nullptr;
  QComboBox* mapArray = nullptr;
  QDoubleSpinBox* mapHeight = nullptr;
  std::vector<MomentName> moments;           ///< of the inputs
  bool makesAncillary = false;               ///< merging again does
  scene::PlanOptions map;                    ///< that is shown, or was shown last
  std::optional<scene::CameraView> before;   ///< the camera before a map of columns
  std::vector<std::function<void()>> follow; ///< shows one setting each
};

} // namespace nexrad::viewer
