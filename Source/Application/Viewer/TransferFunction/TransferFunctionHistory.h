// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <QUndoCommand>

#include <functional>
#include <string>

class vtkNexradTransferFunction;
class vtkNexradVolumeScene;

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

/// A change from one state to another, which was made already when it is pushed.
class TransferFunctionChange : public QUndoCommand
{
public:
  using State = TransferFunctionState;

  /// `apply` gives the scene a state.
  TransferFunctionChange(const QString& text, State stateBefore, State stateAfter,
    std::function<void(const State&)> applyState);

  void undo() override;
  void redo() override;

private:
  State before;
  State after;
  std::function<void(const State&)> apply;
  bool made = true;
};

} // namespace nexrad::viewer
