// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/TransferFunction/TransferFunctionHistory.h"

#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>

#include <utility>

namespace nexrad::viewer
{

TransferFunctionState TransferFunctionState::Of(vtkNexradVolumeScene* scene)
{
  TransferFunctionState state;
  state.preset = scene->GetPreset();
  if (auto* shown = scene->GetTransferFunction())
  {
    state.function = vtkSmartPointer<vtkNexradTransferFunction>::New();
    state.function->DeepCopy(shown);
  }
  return state;
}

bool TransferFunctionState::operator==(const TransferFunctionState& other) const
{
  return preset == other.preset &&
         (function ? function->IsEqual(other.function) : other.function == nullptr);
}

TransferFunctionChange::TransferFunctionChange(const QString& text, State stateBefore,
  State stateAfter, std::function<void(const State&)> applyState)
  : QUndoCommand(text)
  , before(std::move(stateBefore))
  , after(std::move(stateAfter))
  , apply(std::move(applyState))
{
}

void TransferFunctionChange::undo()
{
  made = false;
  apply(before);
}

void TransferFunctionChange::redo()
{
  if (!std::exchange(made, true))
  {
    apply(after);
  }
}

} // namespace nexrad::viewer
