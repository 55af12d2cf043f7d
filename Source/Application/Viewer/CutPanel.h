// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include <array>
#include <memory>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;

namespace nexrad::viewer
{

class CutHandles;
class SceneView;
class Soon;

/// Which part of the volume is shown: a box and a plane, as switches and numbers, and with handles
/// in the scene.
class CutPanel : public QWidget
{
  Q_OBJECT

public:
  /// `view` must outlive it.
  explicit CutPanel(SceneView& view, QWidget* parent = nullptr);
  ~CutPanel() override;

public slots:
  /// Shows what the scene has once the events that wait are done with.
  void FollowSoon();

private:
  void AddBox(QFormLayout* form);
  void AddPlane(QFormLayout* form);
  void SwitchCrop(bool on);
  void SwitchClip(bool on);
  void TakeBox();
  void TakePlane();
  void ShowChange();
  void Follow();
  void FollowBox();
  void FollowPlane();

  SceneView& view;
  std::unique_ptr<CutHandles> handles;
  Soon* follow;
  QCheckBox* shown = nullptr; ///< the handles
  QCheckBox* crop = nullptr;
  std::array<QDoubleSpinBox*, 6> faces{}; ///< west, east, south, north, bottom, top
  QCheckBox* clip = nullptr;
  std::array<QDoubleSpinBox*, 3> origin{};
  QDoubleSpinBox* azimuth = nullptr;   ///< of the normal
  QDoubleSpinBox* elevation = nullptr; ///< of the normal
};

} // namespace nexrad::viewer
