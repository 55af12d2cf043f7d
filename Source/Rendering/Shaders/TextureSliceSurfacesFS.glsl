// Isosurfaces: where the scalar, linear between two places on a ray, has a value.
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// The values, ascending, 0 to 1 as the scalars are.
uniform float isoValues[TEXTURE_SLICE_ISO_VALUES];

// A surface is that of the last component, which gives its opacity; the first one gives the colour.
const int surfaceComponent = TEXTURE_SLICE_COMPONENTS - 1;

// One end of a piece of the ray, and the scalar there.
struct PieceEnd
{
  float at;
  float scalar;
  int level; // how many of the values are lower
};

// The piece of the ray that is looked at: between its ends no surface lies where their levels are equal.
PieceEnd nearEnd = PieceEnd(0.0, 0.0, 0);
PieceEnd farEnd = PieceEnd(0.0, 0.0, 0);
bool isSeen = false; // something at the far end

// Looks at the piece from the far end of this one on, or, after empty space, at the far end alone.
void GoOn(float next, bool empty)
{
  vec4 scalars;
  bool isNextSeen = FetchScalars(PlaceAt(next), scalars);
  nearEnd = farEnd;
  farEnd = PieceEnd(next, scalars[surfaceComponent], 0);
  for (int i = 0; i < TEXTURE_SLICE_ISO_VALUES; ++i)
  {
    farEnd.level += isoValues[i] < farEnd.scalar ? 1 : 0;
  }
  nearEnd.level = empty || !isSeen || !isNextSeen ? farEnd.level : nearEnd.level;
  isSeen = isNextSeen;
}

// Where a surface crosses the piece, and the scalars there: three steps of the secant method that keep
// the surface enclosed. False where nothing is to be seen.
bool FindSurface(float isoValue, out vec4 scalars)
{
  vec2 ends = vec2(nearEnd.at, farEnd.at);
  vec2 offsets = vec2(nearEnd.scalar, farEnd.scalar) - isoValue;
  for (int i = 0; i < 3; ++i)
  {
    float at = (ends.x * offsets.y - ends.y * offsets.x) / (offsets.y - offsets.x);
    textureCoordinate = PlaceAt(at);
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

// The nearest surface of the piece; what is behind it is left.
void GatherSurface()
{
  bool rising = farEnd.level > nearEnd.level;
  int surface = rising ? nearEnd.level : nearEnd.level - 1;
  nearEnd.level += rising ? 1 : -1;
  vec4 onSurface;
  if (FindSurface(isoValues[surface], onSurface) && IsLeft(textureCoordinate))
  {
#ifdef TEXTURE_SLICE_SHADOWS
    litSurface = lightSurfaces[surface];
    sideOfEye = rising ? -1.0 : 1.0;
#endif
    vec4 color = LookUp(isoValues[surface], 0);
#if TEXTURE_SLICE_COMPONENTS > 1
    color.rgb = LookUp(onSurface.x, 0).rgb;
#endif
    color = Finish(color, onSurface, surfaceComponent, 0);
    Add(vec4(color.rgb * color.a, color.a));
  }
}
#endif
