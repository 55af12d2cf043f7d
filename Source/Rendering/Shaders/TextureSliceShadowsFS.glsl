// What of the light arrives at a sample.
#ifdef TEXTURE_SLICE_SHADOWS

// Red: the transmittance to the light. Green: its mean over the sky (Formulas L2).
uniform sampler3D lightTexture;
// From the volume's texture coordinates to those of the light.
uniform vec3 lightTextureScale;
// How strong shadow and occlusion are, 0 to 1.
uniform vec2 lightStrength;

#ifdef TEXTURE_SLICE_SCATTERING
// Half of VolumetricScatteringBlending.
uniform float scattering;
#endif

// Of the light, and of the sky's, with shadow and occlusion at full strength.
vec2 FetchTransmittance()
{
  return texture(lightTexture, textureCoordinate * lightTextureScale).rg;
}

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// Towards the light, of length 1: in data coordinates, and in cells of the light volume.
uniform vec3 toLight;
uniform vec3 toLightInCells;
// A cell: data lengths of its edges, and texture coordinates of the volume.
uniform vec3 lightCellEdge;
uniform vec3 lightCellStep;
// Value, 0 to 1 as the scalars are, and transmittance of each surface.
uniform vec2 lightSurfaces[TEXTURE_SLICE_ISO_VALUES];

// The surface that is lit, and which way along the gradient the eye is: 1 or -1.
int litSurface = 0;
float sideOfEye = 1.0;

// How far from the surface light is looked up, in the distances at which no cell that is
// interpolated lies behind the surface.
const float lightClearance = 1.25;
// Cosines of the angles to the light between which a surface begins to shadow itself.
const float grazing = 0.1;

// What the other surfaces let through between the lit one and the place where light is looked up,
// whose scalar differs by that. Of a surface near that place the light volume contains a part of
// what it takes, because cells on either side are interpolated: 1.7 is what errs least.
float CrossOtherSurfaces(float change)
{
  float left = 1.0;
#if TEXTURE_SLICE_ISO_VALUES > 1
  for (int i = 0; i < TEXTURE_SLICE_ISO_VALUES; ++i)
  {
    float share = (lightSurfaces[i].x - lightSurfaces[litSurface].x) / change; // of the way
    float part = share > 0.0 ? clamp(1.7 - share, 0.0, 1.0) : 0.0;
    left *= i != litSurface ? mix(1.0, lightSurfaces[i].y, part) : 1.0;
  }
#endif
  return left;
}

// The light, and the sky's, of a place on a surface are those beside it on the side of the eye: on
// the way to the light, where the shadows are the same, or straight off where that leads along the
// surface. Light from behind as the eye sees it has crossed the surface.
vec2 FetchTransmittanceBeside(vec3 gradient)
{
  vec3 toEye = sideOfEye * gradient * sign(inverseAspect);
  vec3 slope = toEye * lightCellEdge;
  vec3 normal = slope * inversesqrt(max(dot(slope, slope), 1e-30));
  float clearance = lightClearance * dot(abs(normal), vec3(1.0));
  float approach = dot(normal, toLightInCells);
  float way = clearance * min(1.0 / max(approach, 1e-3), 4.0 * max(approach, 0.0));
  vec3 beside =
    (way * toLightInCells + (clearance - way * approach) * normal) * lightCellStep;
  vec2 arriving = texture(lightTexture, (textureCoordinate + beside) * lightTextureScale).rg;
#if TEXTURE_SLICE_ISO_VALUES > 1
  // The gradient says what the scalar there is: the change over two voxels, times their aspect.
  float change = 0.5 * dot(gradient / inverseAspect, beside / voxelStep);
  arriving *= CrossOtherSurfaces(abs(change) > 1e-30 ? change : 1e-30);
#endif
  float facing = dot(toEye, toLight) * inversesqrt(max(dot(toEye, toEye), 1e-30));
  float most = mix(lightSurfaces[litSurface].y, 1.0, smoothstep(-grazing, grazing, facing));
  return vec2(min(arriving.r, most), arriving.g);
}
#endif

vec2 Weaken(vec2 transmittance)
{
  return mix(vec2(1.0), transmittance, lightStrength);
}
#endif
