// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/VolumeAppearance.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkWeakPointer.h>

#include <QTimer>
#include <QUndoStack>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <tuple>

class QBoxLayout;
class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QMenu;
class QSpinBox;
class QToolButton;
class vtkImageData;
class vtkNexradTransferFunction;
class vtkNexradVolumeScene;
class vtkRenderer;

namespace nexrad::viewer
{

/// The preset of a scene, and its colours and opacities as they were changed since.
struct TransferFunctionState
{
  std::string preset;
  vtkSmartPointer<vtkNexradTransferFunction> function; ///< a copy; nullptr: the scene has none yet

  /// What a scene has now.
  static TransferFunctionState Of(vtkNexradVolumeScene* scene);
  bool operator==(const TransferFunctionState& other) const;
};

class Soon;
class TransferFunctionChart;

/// Edits the colours and opacities of a scene as four splines, with undo and redo.
class TransferFunctionEditor : public QWidget
{
  Q_OBJECT

public:
  explicit TransferFunctionEditor(vtkNexradVolumeScene* shownScene, QWidget* parent = nullptr);
  ~TransferFunctionEditor() override;

  TransferFunctionChart* Chart() const { return chart; }

  /// Adds undo and redo, with their keys.
  void AddActions(QMenu* menu);

  /// Shows what the scene has now: its colours and opacities, its volume's histogram, its theme. A
  /// scene that is drawn while the editor is visible is followed without this.
  void Follow();

  /// Takes the colours, and the opacities if it has any, of a file of vtkNexradTransferFunction.
  void ReadFile(const QString& path);
  void WriteFile(const QString& path);

signals:
  /// Colours or opacities were changed here.
  void Changed();
  /// The scene's preset was changed here.
  void PresetChanged();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  /// What the editor shows of the scene's settings: the function (compared, never followed) and its
  /// time, theme, preset, and the array of the colours.
  using Settings = std::tuple<const void*, vtkMTimeType, std::optional<scene::ThemeChoice>,
    std::string, std::string>;

  void AddPresets(QBoxLayout* column);
  void AddChannels(QBoxLayout* column);
  void AddPointRow(QBoxLayout* column);
  void AddIsoValues(QBoxLayout* column);
  QDoubleSpinBox* AddNumber(QBoxLayout* row, const QString& name, const QString& tip);
  QToolButton* AddButton(QBoxLayout* row, const QString& text, const QString& name,
    const QString& tip, const std::function<void()>& press);

  vtkNexradTransferFunction* Shown() const;
  void FollowDrawing();
  void FollowVolume();
  void FollowMoment(const std::string& name);
  void FollowUnit();
  void FollowFunction();
  void FollowPoint();
  void FollowPresets();
  void ShowHistogram();

  void ChoosePreset(int index);
  void ChooseChannel(int channel);
  void ChoosePoint(int number);
  void MovePoint();
  void AddPoint();
  void DeletePoint();
  void SetIsoValues();
  void AskForFile();
  void AskWhereToWrite();
  void Finish(const QString& what);
  void Apply(const TransferFunctionState& state);
  void Say(const QString& text);

  vtkSmartPointer<vtkNexradVolumeScene> scene;
  vtkSmartPointer<vtkRenderer> renderer; ///< of the scene, observed
  unsigned long drawnTag = 0;
  QUndoStack history;
  TransferFunctionState known; ///< at the last entry of the history
  TransferFunctionChart* chart = nullptr;
  /// After the picture that was asked for: numbers that change are painted, and with them the
  /// window.
  Soon* follow = nullptr;
  QComboBox* presets = nullptr;
  QButtonGroup* channels = nullptr;
  QSpinBox* point = nullptr;
  QDoubleSpinBox* value = nullptr;
  QDoubleSpinBox* level = nullptr;
  QToolButton* remove = nullptr;
  QLineEdit* isoValues = nullptr;
  QLabel* message = nullptr;
  std::string moment;                   ///< of the volume, as "REF"
  scene::LabelUnit labels;              ///< in which values are shown
  vtkWeakPointer<vtkImageData> counted; ///< volume of the histogram
  vtkMTimeType countedTime = 0;
  QTimer pause; ///< after a histogram: a series that plays may change more often
  Settings followed;
};

} // namespace nexrad::viewer
