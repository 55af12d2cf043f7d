// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceFrame.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

// OpenGL's: a spot light's cone is at most this wide, degrees from its axis.
constexpr double WidestCone = 90.0;

std::array<float, 3> ToFloat(const double v[3], double factor = 1.0)
{
  return {static_cast<float>(v[0] * factor), static_cast<float>(v[1] * factor),
    static_cast<float>(v[2] * factor)};
}

using Vector = std::array<double, 3>;
using Plane = std::array<double, 4>;

double Evaluate(const Plane& plane, const Vector& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

Plane RowOf(const std::array<double, 16>& matrix, std::size_t row)
{
  return {matrix[4 * row], matrix[4 * row + 1], matrix[4 * row + 2], matrix[4 * row + 3]};
}

/// The depth of a place as a function of its box coordinates.
Plane MakeDepth(const vtkTextureSliceView& view)
{
  const Plane z = RowOf(view.BoxToCamera, 2);
  return {-z[0], -z[1], -z[2], -z[3]};
}

/// Nearest and farthest depth of the part of the box in front of the near plane.
std::pair<double, double> DepthRange(const vtkTextureSliceView& view, const Plane& depth)
{
  double nearest = std::numeric_limits<double>::max();
  double farthest = std::numeric_limits<double>::lowest();
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double value = Evaluate(depth, {view.Part[corner & 1], view.Part[2 + ((corner >> 1) & 1)],
                                           view.Part[4 + ((corner >> 2) & 1)]});
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  return {std::max(nearest, view.NearDepth), farthest};
}

/// Data length of one unit of depth along the axis of the view.
double FindDataPerDepth(const vtkTextureSliceView& view)
{
  const auto& m = view.BoxToCamera;
  const double rows[3][3] = {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}};
  const double back[3] = {0.0, 0.0, -1.0};
  Vector direction{}; // in box coordinates
  vtkMath::LinearSolve3x3(rows, back, direction.data());
  return std::hypot(direction[0] * view.EdgeLength[0], direction[1] * view.EdgeLength[1],
    direction[2] * view.EdgeLength[2]);
}

/// How far the slices must go towards the eye so that none of them lies on faces between voxels:
/// there the scalar jumps, and rounding would take now the one voxel and now the other.
double FindShift(
  const vtkTextureSliceView& view, const Plane& depth, double nearest, double depthStep, int slices)
{
  constexpr double close = 0.05; // of a voxel
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The depth of a voxel, and how far the depths of a plane of voxels differ.
    const double voxel = view.Faces[axis] > 0.0 ? std::abs(depth[axis]) / view.Faces[axis] : 0.0;
    const double others = std::abs(depth[(axis + 1) % 3]) + std::abs(depth[(axis + 2) % 3]);
    if (voxel <= 0.0 || others > close * voxel)
    {
      continue;
    }
    const double middles = 0.5 * (depth[(axis + 1) % 3] + depth[(axis + 2) % 3]) + depth[3];
    int onFaces = 0;
    for (int i = 0; i < slices; ++i)
    {
      const double place = (nearest + (i + 0.5) * depthStep - middles) / depth[axis];
      const double voxels = (place - view.FirstFace[axis]) * view.Faces[axis];
      onFaces += std::abs(voxels - std::round(voxels)) < close ? 1 : 0;
    }
    // By chance, one slice in ten is that close to a face.
    return onFaces * 5 > slices ? 0.25 * std::min(voxel, depthStep) : 0.0;
  }
  return 0.0;
}

int CountSlices(const vtkTextureSliceView& view, double nearest, double farthest)
{
  const double thickness = farthest - nearest;
  double count = view.NumberOfSlices;
  if (view.NumberOfSlices <= 0)
  {
    constexpr double rounding = 0.01; // a camera that is turned a little sees as many slices
    count = std::ceil(thickness * FindDataPerDepth(view) / view.SampleDistance - rounding);
  }
  return static_cast<int>(
    std::clamp(count, 1.0, double{vtkTextureSlicePlanes::MaximumNumberOfSlices}));
}

/// Where the rays of the pixels meet the plane of that depth. On it, the last clip coordinate is
/// the same everywhere.
vtkTextureSlicePixelMap MapPixels(const vtkTextureSliceView& view, double depthOfPlane)
{
  const Plane right = RowOf(view.BoxToClip, 0);
  const Plane up = RowOf(view.BoxToClip, 1);
  const Plane depth = MakeDepth(view);
  const double rows[3][3] = {
    {right[0], right[1], right[2]}, {up[0], up[1], up[2]}, {depth[0], depth[1], depth[2]}};
  const auto solve = [&rows](double x, double y, double z)
  {
    const double known[3] = {x, y, z};
    Vector place{};
    vtkMath::LinearSolve3x3(rows, known, place.data());
    return place;
  };
  const Vector somewhere = solve(0.0, 0.0, depthOfPlane - depth[3]);
  const double w = Evaluate(RowOf(view.BoxToClip, 3), somewhere);
  return {solve(2.0 * w / view.Viewport[0], 0.0, 0.0), solve(0.0, 2.0 * w / view.Viewport[1], 0.0),
    solve(-w - right[3], -w - up[3], depthOfPlane - depth[3])};
}

std::array<float, 4> MapDepths(
  const vtkTextureSliceView& view, const Vector& onNearest, const Vector& toNext)
{
  const Plane zRow = RowOf(view.BoxToClip, 2);
  const Plane wRow = RowOf(view.BoxToClip, 3);
  const double z = Evaluate(zRow, onNearest);
  const double w = Evaluate(wRow, onNearest);
  const double zStep = Evaluate({zRow[0], zRow[1], zRow[2], 0.0}, toNext);
  const double wStep = Evaluate({wRow[0], wRow[1], wRow[2], 0.0}, toNext);
  return {static_cast<float>(w - z), static_cast<float>(w), static_cast<float>(zStep - wStep),
    static_cast<float>(wStep)};
}

/// The first and the last of the three parts of an axis of which some region is drawn.
std::array<std::size_t, 2> FindKeptParts(int regionFlags, std::size_t axis)
{
  constexpr std::array<unsigned int, 3> weights{1, 3, 9};
  std::array<std::size_t, 2> kept{2, 0};
  for (unsigned int region = 0; region < 27; ++region)
  {
    if ((static_cast<unsigned int>(regionFlags) >> region & 1U) != 0)
    {
      const std::size_t part = region / weights[axis] % 3;
      kept = {std::min(kept[0], part), std::max(kept[1], part)};
    }
  }
  return kept;
}

} // namespace

void vtkTextureSlicePlanes::Place(const vtkTextureSliceView& view)
{
  *this = vtkTextureSlicePlanes();
  const Plane depth = MakeDepth(view);
  const auto [nearest, farthest] = DepthRange(view, depth);
  if (!(nearest < farthest))
  {
    return;
  }
  this->NumberOfSlices = view.Plane ? 1 : CountSlices(view, nearest, farthest);
  this->DepthStep = (farthest - nearest) / this->NumberOfSlices;
  this->NearestDepth = nearest + 0.5 * this->DepthStep -
                       FindShift(view, depth, nearest, this->DepthStep, this->NumberOfSlices);
  this->DataStep = this->DepthStep * FindDataPerDepth(view);
  this->Places = MapPixels(view, this->NearestDepth);
  this->Steps = MapPixels(view, this->NearestDepth + this->DepthStep);
  for (std::size_t i = 0; i < 9; ++i)
  {
    this->Steps[i / 3][i % 3] -= this->Places[i / 3][i % 3];
  }
  this->DepthToSlice = MapDepths(view, this->Places[2], this->Steps[2]);
}

void vtkTextureSliceFrame::SetVolume(vtkImageData* image, bool cellData, vtkVolume* volume)
{
  this->CellData = cellData;
  int extent[6];
  double spacing[3];
  image->GetExtent(extent);
  image->GetSpacing(spacing);
  image->GetOrigin(this->Origin.data());

  const bool nearest = volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  std::array<double, 16> boxToIndex{};
  boxToIndex[15] = 1.0;
  vtkNew<vtkMatrix4x4> volumeToWorld;
  volume->GetMatrix(volumeToWorld);
  this->ShortestVoxelEdge = VTK_DOUBLE_MAX;
  const double meanSpacing =
    (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int intervals = extent[2 * axis + 1] - extent[2 * axis];
    boxToIndex[5 * axis] = intervals;
    boxToIndex[4 * axis + 3] = extent[2 * axis];
    this->Origin[axis] += extent[2 * axis] * spacing[axis];
    this->View.EdgeLength[axis] = intervals * spacing[axis];
    // Between two points, or at the faces of cells.
    this->View.Faces[axis] = nearest ? intervals : 0.0;
    this->View.FirstFace[axis] = (cellData ? 0.0 : 0.5) / intervals;
    // Point scalars sit at the centres of the outermost texels, cell scalars half a cell inside.
    const double texels = intervals + (cellData ? 0 : 1);
    this->TextureScale[axis] = static_cast<float>(intervals / texels);
    this->TextureBias[axis] = static_cast<float>(cellData ? 0.0 : 0.5 / texels);
    this->VoxelStep[axis] =
      static_cast<float>(1.0 / std::max(1, cellData ? intervals - 1 : intervals));
    this->InverseAspect[axis] = static_cast<float>(meanSpacing / (2.0 * spacing[axis]));

    const double* world = volumeToWorld->GetData();
    const double column = std::hypot(world[axis], world[4 + axis], world[8 + axis]);
    this->ShortestVoxelEdge = std::min(this->ShortestVoxelEdge, std::abs(spacing[axis]) * column);
  }
  std::array<double, 16> boxToData{};
  vtkMatrix4x4::Multiply4x4(
    image->GetIndexToPhysicalMatrix()->GetData(), boxToIndex.data(), boxToData.data());
  vtkMatrix4x4::Multiply4x4(volumeToWorld->GetData(), boxToData.data(), this->BoxToWorld.data());
}

std::array<float, 4> vtkTextureSliceFrame::GetStair() const
{
  constexpr float most = 4.0f;
  const auto [longest, shortest] = std::minmax_element(this->InverseAspect.begin(),
    this->InverseAspect.end(), [](float a, float b) { return std::abs(a) < std::abs(b); });
  const auto axis = static_cast<std::size_t>(shortest - this->InverseAspect.begin());
  std::array<float, 4> stair{};
  stair[axis] = this->VoxelStep[axis];
  stair[3] = std::min(most, std::floor(0.5f * std::abs(*shortest / *longest)));
  return stair;
}

void vtkTextureSliceFrame::SetCamera(vtkRenderer* renderer)
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  vtkMatrix4x4* worldToCamera = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkMatrix4x4* cameraToClip = nullptr;
  vtkMatrix4x4* worldToClip = nullptr;
  // These come column by column.
  camera->GetKeyMatrices(renderer, worldToCamera, normals, cameraToClip, worldToClip);

  const auto fromBox = [this](vtkMatrix4x4* columns, std::array<double, 16>& rows)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(columns);
    matrix->Transpose();
    vtkMatrix4x4::Multiply4x4(matrix->GetData(), this->BoxToWorld.data(), rows.data());
  };
  fromBox(worldToCamera, this->View.BoxToCamera);
  fromBox(worldToClip, this->View.BoxToClip);
  this->View.NearDepth = camera->GetClippingRange()[0];
}

void vtkTextureSliceFrame::SetCuts(vtkVolumeMapper* mapper)
{
  this->Cut = {};
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const int count = planes != nullptr ? planes->GetNumberOfItems() : 0;
  for (int i = 0; i < count; ++i)
  {
    this->Cut.Planes.push_back(this->ToBox(planes->GetItem(i)));
  }
  const int regions = mapper->GetCroppingRegionFlags();
  const double* cropping = mapper->GetCroppingRegionPlanes();
  for (std::size_t axis = 0; axis < 3 && mapper->GetCropping() != 0; ++axis)
  {
    const double edge = this->View.EdgeLength[axis];
    const double low = (cropping[2 * axis] - this->Origin[axis]) / edge;
    const double high = (cropping[2 * axis + 1] - this->Origin[axis]) / edge;
    const auto [lower, upper] = std::minmax(low, high); // a negative spacing swaps them
    const std::array<double, 4> borders{
      0.0, std::clamp(lower, 0.0, 1.0), std::clamp(upper, 0.0, 1.0), 1.0};
    const auto [first, last] = FindKeptParts(regions, axis);
    this->Cut.Part[2 * axis] = borders[first];
    this->Cut.Part[2 * axis + 1] = borders[last + 1];
    // The part alone does not do it for other regions.
    if (regions != VTK_CROP_SUBVOLUME)
    {
      this->Cut.CropFlags = regions;
      this->Cut.CropLow[axis] = low;
      this->Cut.CropHigh[axis] = high;
    }
  }
  this->View.Part = this->Cut.Part;
}

std::array<double, 4> vtkTextureSliceFrame::ToBox(vtkPlane* plane) const
{
  double normal[3];
  double origin[3];
  plane->GetNormal(normal);
  plane->GetOrigin(origin);
  const double world[4] = {normal[0], normal[1], normal[2],
    -(normal[0] * origin[0] + normal[1] * origin[1] + normal[2] * origin[2])};
  // A plane goes from world to box coordinates by the matrix that takes points from box to world.
  std::array<double, 4> box{};
  for (std::size_t i = 0; i < 16; ++i)
  {
    box[i % 4] += world[i / 4] * this->BoxToWorld[i];
  }
  return box;
}

std::array<double, 3> vtkTextureSliceFrame::GetDataDirection(
  const std::array<double, 3>& world) const
{
  std::array<double, 16> worldToBox{};
  vtkMatrix4x4::Invert(this->BoxToWorld.data(), worldToBox.data());
  std::array<double, 3> data{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      data[axis] += worldToBox[4 * axis + column] * world[column];
    }
    data[axis] *= std::abs(this->View.EdgeLength[axis]);
  }
  return data;
}

std::array<float, 4> vtkTextureSliceFrame::ToTexture(const std::array<double, 4>& box) const
{
  std::array<float, 4> texture{};
  double constant = box[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double coefficient = box[axis] / static_cast<double>(this->TextureScale[axis]);
    texture[axis] = static_cast<float>(coefficient);
    constant -= coefficient * static_cast<double>(this->TextureBias[axis]);
  }
  texture[3] = static_cast<float>(constant);
  return texture;
}

bool vtkTextureSliceFrame::IsFlat() const
{
  const Vector& edges = this->View.EdgeLength;
  return !(std::abs(edges[0] * edges[1] * edges[2]) > 0.0) ||
         !(std::abs(vtkMatrix4x4::Determinant(this->BoxToWorld.data())) > 0.0);
}

std::array<float, 16> vtkTextureSliceFrame::ToColumns(const std::array<double, 16>& rows)
{
  std::array<float, 16> columns{};
  for (std::size_t i = 0; i < 16; ++i)
  {
    columns[i] = static_cast<float>(rows[4 * (i % 4) + i / 4]);
  }
  return columns;
}

void vtkTextureSliceLights::Update(vtkRenderer* renderer)
{
  *this = vtkTextureSliceLights();
  this->TwoSided = renderer->GetTwoSidedLighting() != 0;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch() != 0)
    {
      this->OnlyHeadlight =
        this->Count == 0 && light->LightTypeIsHeadlight() != 0 && light->GetPositional() == 0;
      this->Append(renderer, light);
      ++this->Count;
    }
  }
}

void vtkTextureSliceLights::Append(vtkRenderer* renderer, vtkLight* light)
{
  const double intensity = light->GetIntensity();
  const auto ambient = ToFloat(light->GetAmbientColor(), intensity);
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->Ambient[i] += ambient[i];
  }
  this->Vectors["lightDiffuse"].push_back(ToFloat(light->GetDiffuseColor(), intensity));
  this->Vectors["lightSpecular"].push_back(ToFloat(light->GetSpecularColor(), intensity));

  double position[3];
  double direction[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(direction);
  vtkMath::Subtract(direction, position, direction);
  vtkMath::Normalize(direction);
  vtkTransform* toCamera = renderer->GetActiveCamera()->GetModelViewTransformObject();
  this->Vectors["lightDirection"].push_back(ToFloat(toCamera->TransformNormal(direction)));
  this->Vectors["lightPosition"].push_back(ToFloat(toCamera->TransformPoint(position)));

  this->Vectors["lightAttenuation"].push_back(ToFloat(light->GetAttenuationValues()));
  const double angle = light->GetConeAngle();
  const double cosine = angle <= WidestCone ? std::cos(vtkMath::RadiansFromDegrees(angle)) : -2.0;
  // Whether it has a position, cosine of the cone or -2, exponent.
  const double cone[3] = {light->GetPositional() != 0 ? 1.0 : 0.0, cosine, light->GetExponent()};
  this->Vectors["lightCone"].push_back(ToFloat(cone));
}

void vtkTextureSliceLights::SetUniforms(
  vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const
{
  program->SetUniformi("twoSided", this->TwoSided ? 1 : 0);
  program->SetUniform3f("lightAmbient", this->Ambient.data());
  for (const auto& [name, values] : this->Vectors)
  {
    program->SetUniform3fv(name, this->Count, reinterpret_cast<const float(*)[3]>(values.data()));
  }
  std::array<double, 16> cameraToBox{};
  vtkMatrix4x4::Invert(frame.View.BoxToCamera.data(), cameraToBox.data());
  const double eye[3] = {cameraToBox[3], cameraToBox[7], cameraToBox[11]};
  program->SetUniform3f("eyeInBox", ToFloat(eye).data());
  program->SetUniform3f("boxEdges", ToFloat(frame.View.EdgeLength.data()).data());
  // Normals go the other way about: by the transposed matrix from camera to box coordinates, column
  // by column, and from data to box lengths by the edges.
  std::array<float, 9> gradientToCamera{};
  for (std::size_t i = 0; i < 9; ++i)
  {
    gradientToCamera[i] =
      static_cast<float>(cameraToBox[4 * (i / 3) + i % 3] * frame.View.EdgeLength[i / 3]);
  }
  auto boxToCamera = vtkTextureSliceFrame::ToColumns(frame.View.BoxToCamera);
  program->SetUniformMatrix4x4("boxToCamera", boxToCamera.data());
  program->SetUniformMatrix3x3("gradientToCamera", gradientToCamera.data());
}
