// SPDX-License-Identifier: BSD-3-Clause
// Which part of the volume a pass of depth peeling asks for.
#ifndef vtkTextureSlicePeeling_h
#define vtkTextureSlicePeeling_h

class vtkAbstractMapper;
class vtkOpenGLRenderPass;
class vtkOpenGLState;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;

/// VTK's dual depth peeling draws a volume several times a frame, each time by two pictures: of
/// what is in front of the geometry that is not peeled yet, and of what is behind it. Its textures
/// tell between which depths a pixel's part of the volume lies (TextureSliceRayFS).
class vtkTextureSlicePeeling
{
public:
  enum Stage
  {
    None,    ///< the volume is not peeled
    Outside, ///< in front of all translucent geometry, and behind it
    Between, ///< between two peels
    Rest     ///< all that is left when there are no peels any more
  };

  /// Asks the render passes that draw the volume what they want.
  /// @return one line that says why they cannot have it; nullptr if they can
  const char* Update(vtkRenderer* renderer, vtkAbstractMapper* mapper, vtkVolume* volume);
  Stage GetStage() const { return this->Asked; }

  /// The pictures to be drawn one after the other; picture 0 is in front if there are two.
  int CountPictures() const { return this->Asked == Outside || this->Asked == Between ? 2 : 1; }
  /// Chooses the picture that is drawn next.
  void SetPicture(int picture) { this->Picture = picture; }

  void SetUniforms(vtkShaderProgram* program) const;
  /// How a picture joins the textures of the pass.
  void SetBlending(vtkOpenGLState* state) const;

private:
  Stage Asked = None;
  int Picture = 0;
  vtkOpenGLRenderPass* Pass = nullptr;
  vtkAbstractMapper* Mapper = nullptr;
  vtkVolume* Volume = nullptr;
};

#endif
