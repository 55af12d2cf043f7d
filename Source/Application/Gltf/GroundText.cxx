// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/GroundText.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>
#include <vtkVectorText.h>

namespace nexrad::scene
{

vtkSmartPointer<vtkPolyData> MakeGroundText(
  const std::string& text, const std::array<double, 2>& corner, double height, double size)
{
  vtkNew<vtkVectorText> letters; // whose capitals are 1 high
  letters->SetText(text.c_str());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(letters->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> flat = triangles->GetOutput();
  vtkNew<vtkPoints> placed;
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    const double* letter = flat->GetPoint(i);
    placed->InsertNextPoint(corner[0] + size * letter[0], corner[1] + size * letter[1], height);
  }
  flat->SetPoints(placed);
  return flat;
}

} // namespace nexrad::scene
