// What of the light arrives at a sample.
#ifdef TEXTURE_SLICE_SHADOWS

uniform sampler3D lightTexture;

// From the volume's texture coordinates to those of the light.
uniform vec3 lightTextureScale;

#if !defined TEXTURE_SLICE_LIGHTS && TEXTURE_SLICE_BLEND != TEXTURE_SLICE_ISOSURFACE
// What shadow and occlusion leave of a colour that has no shading: the light texture holds that.
float FetchLight()
{
  return textureLod(lightTexture, textureCoordinate * lightTextureScale, 0.0).r;
}
#else
// Of the texture, red: the transmittance to the light; green: its mean over the sky (Formulas L2).

// How strong shadow and occlusion are, 0 to 1.
uniform vec2 lightStrength;

// Of the light, and of the sky's, with shadow and occlusion at full strength.
vec2 FetchTransmittance()
{
  return textureLod(lightTexture, textureCoordinate * lightTextureScale, 0.0).rg;
}

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// Towards the light, of length 1, in cells of the light volume.
uniform vec3 toLight;
// Times a gradient: its direction in cells, and the change of the scalar (0 to 1) over a cell.
uniform vec3 gradientToCells;
uniform vec3 gradientToChange;
// Texture coordinates of one cell of the light.
uniform vec3 lightCell;
// Value, 0 to 1 as the scalars are, and what is taken of the light, of each surface.
uniform vec2 lightSurfaces[TEXTURE_SLICE_ISO_VALUES];

// The surface that is lit, and which way along the gradient the eye is: 1 or -1.
vec2 litSurface = vec2(0.0);
float sideOfEye = 1.0;

// How far from the surface light is looked up, in the distances at which no cell that is
// interpolated lies behind the surface.
const float lightClearance = 1.25;
// Cosine of the angle to the light at which a surface begins to shadow itself.
const float grazing = 0.1;

// What the other surfaces let through between the lit one and the place where light is looked up,
// whose scalar differs by that. Of a surface near that place the light volume contains a part of
// what it takes, because cells on either side are interpolated: 1.7 is what errs least.
float CrossOtherSurfaces(float change)
{
  float left = 1.0;
  float perChange = 1.0 / change;
  for (int i = 0; i < TEXTURE_SLICE_ISO_VALUES; ++i)
  {
    float share = (lightSurfaces[i].x - litSurface.x) * perChange; // of the way
    left -= share > 0.0 ? left * clamp(1.7 - share, 0.0, 1.0) * lightSurfaces[i].y : 0.0;
  }
  return left;
}

// The light, and the sky's, of a place on a surface are those beside it on the side of the eye: on
// the way to the light, where the shadows are the same, or straight off where that leads along the
// surface. Light from behind as the eye sees it has crossed the surface.
vec2 FetchTransmittanceBeside(vec3 gradient)
{
  vec3 slope = gradient * gradientToCells;
  vec3 normal = slope * (sideOfEye * inversesqrt(max(dot(slope, slope), 1e-30)));
  float clearance = lightClearance * dot(abs(normal), vec3(1.0));
  float approach = dot(normal, toLight);
  float way = clearance * min(1.0 / max(approach, 1e-3), max(4.0 * approach, 0.0));
  vec3 cells = way * toLight + (clearance - way * approach) * normal;
  vec2 arriving =
    textureLod(lightTexture, textureCoordinate * lightTextureScale + cells * lightCell, 0.0).rg;
#if TEXTURE_SLICE_ISO_VALUES > 1
  arriving *= CrossOtherSurfaces(dot(gradient * gradientToChange, cells));
#endif
  float taken = litSurface.y * clamp(0.5 - approach * (0.5 / grazing), 0.0, 1.0);
  return vec2(min(arriving.r, 1.0 - taken), arriving.g);
}
#endif

vec2 Weaken(vec2 transmittance)
{
  return mix(vec2(1.0), transmittance, lightStrength);
}
#endif
#endif
