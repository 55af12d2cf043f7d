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
