// Isosurfaces: where the scalar, linear between two places on a ray, has a value.
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// The values, ascending, 0 to 1 as the scalars are.
uniform float isoValues[TEXTURE_SLICE_ISO_VALUES];

// A surface is that of the last component, which gives its opacity; the first one gives the colour.
const int surfaceComponent = TEXTURE_SLICE_COMPONENTS - 1;

vec4 SurfaceColor(float isoValue, vec4 scalars)
{
  vec4 color = LookUp(isoValue, 0);
#if TEXTURE_SLICE_COMPONENTS > 1
  color.rgb = LookUp(scalars.x, 0).rgb;
#endif
  return color.a > 0.0 ? Finish(color, scalars, surfaceComponent, 0) : vec4(0.0);
}

// Where a surface crosses the ray between two samples, and the scalars there: three steps of the
// secant method that keep the surface enclosed. False where nothing is to be seen.
bool FindSurface(float isoValue, vec3 nearEnd, float nearScalar, vec3 farEnd, float farScalar,
  out vec4 scalars)
{
  vec2 ends = vec2(0.0, 1.0);
  vec2 offsets = vec2(nearScalar, farScalar) - isoValue;
  for (int i = 0; i < 3; ++i)
  {
    float at = (ends.x * offsets.y - ends.y * offsets.x) / (offsets.y - offsets.x);
    textureCoordinate = mix(nearEnd, farEnd, at);
    if (!FetchScalars(textureCoordinate, scalars))
    {
      return false;
    }
    float offset = scalars[surfaceComponent] - isoValue;
    bool beyond = (offset < 0.0) == (offsets.y < 0.0);
    ends = beyond ? vec2(ends.x, at) : vec2(at, ends.y);
    // Halving the offset of the end that stays keeps both ends moving.
    offsets = beyond ? vec2(0.5 * offsets.x, offset) : vec2(offset, 0.5 * offsets.y);
    if (offset == 0.0)
    {
      break;
    }
  }
  return true;
}

// The scalars of the last place on the ray, and whether there is something to see.
vec4 lastScalars;
bool isLastSeen = false;

// The surfaces between two scalars in a row, the nearest first.
void GatherSurfaces(vec3 nearEnd, float nearScalar, vec3 farEnd, float farScalar)
{
  bool rising = farScalar > nearScalar;
  vec2 between = vec2(min(nearScalar, farScalar), max(nearScalar, farScalar));
  for (int i = 0; i < TEXTURE_SLICE_ISO_VALUES; ++i)
  {
    int surface = rising ? i : TEXTURE_SLICE_ISO_VALUES - 1 - i;
    float isoValue = isoValues[surface];
    vec4 onSurface;
    if (isoValue >= between.x && isoValue < between.y &&
      FindSurface(isoValue, nearEnd, nearScalar, farEnd, farScalar, onSurface) &&
      IsLeft(textureCoordinate))
    {
#ifdef TEXTURE_SLICE_SHADOWS
      litSurface = lightSurfaces[surface];
      sideOfEye = rising ? -1.0 : 1.0;
#endif
      vec4 color = SurfaceColor(isoValue, onSurface);
      Add(vec4(color.rgb * color.a, color.a));
    }
  }
}

void GatherPiece(float front, float back, bool begins)
{
  vec3 nearEnd = PlaceAt(front);
  vec3 farEnd = PlaceAt(back);
  if (begins)
  {
    isLastSeen = FetchScalars(nearEnd, lastScalars);
  }
  vec4 scalars;
  bool isSeen = FetchScalars(farEnd, scalars);
  if (isLastSeen && isSeen)
  {
    GatherSurfaces(nearEnd, lastScalars[surfaceComponent], farEnd, scalars[surfaceComponent]);
  }
  lastScalars = scalars;
  isLastSeen = isSeen;
}
#endif
