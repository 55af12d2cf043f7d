// Light on a sample whose surface is across the gradient.
#ifdef TEXTURE_SLICE_LIGHTS

// Ambient, diffuse, specular and specular power of each component.
uniform vec4 material[TEXTURE_SLICE_COMPONENTS];
uniform bool twoSided;

vec3 UnitOrZero(vec3 v)
{
  float size = length(v);
  return size > 0.0 ? v / size : vec3(0.0);
}

// What a surface returns diffusely, and specularly, of a light to an eye.
vec2 Reflect(vec3 normal, vec3 light, vec3 eye, float power)
{
  float diffuse = dot(normal, light);
#ifdef TEXTURE_SLICE_MIRRORED_HIGHLIGHTS
  float specular = twoSided || diffuse > 0.0 ? dot(2.0 * diffuse * normal - light, eye) : 0.0;
#else
  float specular = dot(normal, UnitOrZero(light + eye));
  specular = twoSided ? abs(specular) : specular;
#endif
  diffuse = twoSided ? abs(diffuse) : diffuse;
  return vec2(max(diffuse, 0.0), specular > 0.0 ? pow(specular, power) : 0.0);
}

#if TEXTURE_SLICE_LIGHTS == 0
// A single headlight, in data coordinates.
uniform vec3 lightDiffuse;
uniform vec3 lightSpecular;
uniform vec3 eyeInBox;
// Signed data length of the box's edges.
uniform vec3 boxEdges;

// The eye as seen from where the ray enters the box: in a parallel view, too, the light stands where
// the camera does.
vec3 DirectionToEye()
{
  vec3 towards = sampleStep / abs(boxEdges);
  vec3 box = (textureCoordinate - textureBias) / textureScale;
  vec3 steps = (box - vec3(lessThan(towards, vec3(0.0)))) / towards;
  vec3 entry = box - min(min(steps.x, steps.y), steps.z) * towards;
  return normalize((eyeInBox - entry) * boxEdges);
}

vec3 Light(vec3 color, vec3 gradient, vec4 surface)
{
#ifdef TEXTURE_SLICE_PARALLEL
  vec3 toEye = DirectionToEye();
#else
  vec3 toEye = -normalize(sampleStep * sign(boxEdges));
#endif
  vec2 returned = Reflect(UnitOrZero(gradient), toEye, toEye, surface.w);
  return color * (surface.x + surface.y * returned.x * lightDiffuse) +
    surface.z * returned.y * lightSpecular;
}
#else
// Any lights, in camera coordinates.
uniform mat4 boxToCamera;
uniform mat3 gradientToCamera;
uniform vec3 lightAmbient;
uniform vec3 lightDiffuse[TEXTURE_SLICE_LIGHTS];
uniform vec3 lightSpecular[TEXTURE_SLICE_LIGHTS];
uniform vec3 lightDirection[TEXTURE_SLICE_LIGHTS];
uniform vec3 lightPosition[TEXTURE_SLICE_LIGHTS];
uniform vec3 lightAttenuation[TEXTURE_SLICE_LIGHTS];
// Whether it has a position, the cosine of its cone (-2: no cone), its exponent.
uniform vec3 lightCone[TEXTURE_SLICE_LIGHTS];

// Which way a light shines at a place, and how much of it arrives.
vec4 Beam(int light, vec3 place)
{
  if (lightCone[light].x == 0.0)
  {
    return vec4(lightDirection[light], 1.0);
  }
  vec3 path = place - lightPosition[light];
  float distance = length(path);
  vec3 direction = path / distance;
  vec3 fading = lightAttenuation[light];
  float arriving = 1.0 / (fading.x + distance * (fading.y + distance * fading.z));
  float offAxis = dot(direction, lightDirection[light]);
  if (lightCone[light].y > -2.0)
  {
    arriving *= offAxis >= lightCone[light].y ? pow(offAxis, lightCone[light].z) : 0.0;
  }
  return vec4(direction, arriving);
}

vec3 Light(vec3 color, vec3 gradient, vec4 surface)
{
  vec3 box = (textureCoordinate - textureBias) / textureScale;
  vec3 place = (boxToCamera * vec4(box, 1.0)).xyz;
#ifdef TEXTURE_SLICE_PARALLEL
  vec3 away = vec3(0.0, 0.0, -1.0);
#else
  vec3 away = normalize(place);
#endif
  // The gradient points into the echo, as the light does on the lit side.
  vec3 normal = UnitOrZero(gradientToCamera * gradient);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  for (int light = 0; light < TEXTURE_SLICE_LIGHTS; ++light)
  {
    vec4 beam = Beam(light, place);
    vec2 returned = Reflect(normal, beam.xyz, away, surface.w) * beam.w;
    diffuse += returned.x * lightDiffuse[light];
    specular += returned.y * lightSpecular[light];
  }
  return surface.x * lightAmbient + surface.y * diffuse * color + surface.z * specular;
}
#endif
#endif

// What of the light arrives at a sample.
#ifdef TEXTURE_SLICE_SHADOWS
// Red: transmittance to the light, green: its mean over the sky (Formulas L2); joined, red: what both leave.
uniform sampler3D lightTexture;
// From the volume's texture coordinates to those of the light.
uniform vec3 lightTextureScale;
// How strong shadow and occlusion are, 0 to 1.
uniform vec2 lightStrength;

vec2 Weaken(vec2 transmittance)
{
  return mix(vec2(1.0), transmittance, lightStrength);
}

#ifdef TEXTURE_SLICE_LIT_TURNS
// What shadow and occlusion leave of a colour that has no shading.
float FetchLight(vec3 at)
{
  return min(1.0, textureLod(lightTexture, at * lightTextureScale, 0.0).r);
}
#elif TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
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

// How far from the surface light is looked up, so that no interpolated cell lies behind the surface.
const float lightClearance = 1.25;
// Cosine of the angle to the light at which a surface begins to shadow itself.
const float grazing = 0.1;

// What the other surfaces let through up to the place where light is looked up, whose scalar differs by that.
// A surface near that place is partly in the light there, between cells: 1.7 is what errs least.
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

// The light on a surface is that beside it on the side of the eye: on the way to the light, where the shadows
// are the same, or straight off where that leads along the surface. Light from behind has crossed the surface.
vec2 FindArriving(vec3 gradient)
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
  return Weaken(vec2(min(arriving.r, 1.0 - taken), arriving.g));
}
#else
// Of the light, and of the sky's.
vec2 FindArriving(vec3 gradient)
{
  return Weaken(textureLod(lightTexture, textureCoordinate * lightTextureScale, 0.0).rg);
}
#endif
#endif
