// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class vtkTextProperty;

namespace nexrad::scene
{

/// Sets the face of all letters: Inter (Data/README.md), which is compiled in. Where the operating
/// system gives no file without a folder (it needs memfd_create and /proc), VTK's own Arial.
void SetFace(vtkTextProperty* property, bool bold);

} // namespace nexrad::scene
