#ifdef TEXTURE_SLICE_SLABS
// Pre-integrated classification (Formulas L1). A piece of the ray is divided into slabs with samples at their
// ends. Along a slab, the scalar is linear from its front to its middle, and from there to its back.

// For each set of functions, and each label: colour times optical depth of a unit distance, and that depth,
// integrated over the entries from 0 on.
uniform TEXTURE_SLICE_INTEGRAL_TABLE integralTable;
// The number of the last entry, that of the scalar 1.
uniform float lastIntegral;

struct SlabEnd
{
  vec4 scalars;
  float visible; // below 0: hidden
};

SlabEnd FetchEnd(vec3 at)
{
  SlabEnd end;
  end.visible = FetchVisibility(at, end.scalars);
  return end;
}

// Which part of a slab is visible: the visible points end where the mask, linear along the slab, is
// one half.
float FindVisibleShare(SlabEnd front, SlabEnd back)
{
  if ((front.visible < 0.0) == (back.visible < 0.0))
  {
    return front.visible < 0.0 ? 0.0 : 1.0;
  }
  return max(front.visible, back.visible) / abs(front.visible - back.visible);
}

#define ENDS (TEXTURE_SLICE_SLABS + 1)

// A hidden end has the scalars of a visible end beside it.
void FillHiddenEnds(inout SlabEnd ends[ENDS])
{
  for (int i = 0; i < ENDS; ++i)
  {
    int before = max(i - 1, 0);
    int after = min(i + 1, ENDS - 1);
    if (ends[i].visible < 0.0)
    {
      ends[i].scalars = ends[before].visible < 0.0 ? ends[after].scalars : ends[before].scalars;
    }
  }
}

// The scalars at the ends of the slabs and in their middles, the nearest first.
#define POINTS (2 * TEXTURE_SLICE_SLABS + 1)

// The second difference of the scalars about three ends in a row.
vec4 FindBend(SlabEnd before, SlabEnd here, SlabEnd after)
{
  if (min(min(before.visible, here.visible), after.visible) < 0.0)
  {
    return vec4(0.0);
  }
  return before.scalars - 2.0 * here.scalars + after.scalars;
}

// The smaller one of two bends in the same direction: at a jump, whose bends have opposite directions,
// the scalars are linear.
vec4 LimitBend(vec4 a, vec4 b)
{
  return 0.5 * (sign(a) + sign(b)) * min(abs(a), abs(b));
}

// The middle of a slab is where the parabola has it that its ends and the next ones lie on.
void FindPoints(SlabEnd ends[ENDS], out vec4 points[POINTS])
{
  vec4 bends[TEXTURE_SLICE_SLABS - 1];
  for (int i = 0; i < TEXTURE_SLICE_SLABS - 1; ++i)
  {
    bends[i] = FindBend(ends[i], ends[i + 1], ends[i + 2]);
  }
  points[0] = ends[0].scalars;
  for (int i = 0; i < TEXTURE_SLICE_SLABS; ++i)
  {
    int first = clamp(i - 1, 0, TEXTURE_SLICE_SLABS - 3);
    vec4 bend = LimitBend(bends[first], bends[first + 1]);
    points[2 * i + 1] = 0.5 * (ends[i].scalars + ends[i + 1].scalars) - 0.125 * bend;
    points[2 * i + 2] = ends[i + 1].scalars;
  }
}

// Where two scalars in a row have the same entry, the second one has the entry on its other side: for
// equal scalars the mean between the two entries about them is the limit.
float FindEntry(float scalar, float before)
{
  float place = clamp(scalar * lastIntegral, 0.0, lastIntegral - 1.0);
  float entry = floor(place + 0.5);
  float otherSide = place >= entry ? entry + 1.0 : entry - 1.0;
  return entry == before ? otherSide : entry;
}

vec4 FetchIntegrals(sampler1D table, float entry, int row)
{
  return texelFetch(table, int(entry), 0);
}

vec4 FetchIntegrals(sampler2D table, float entry, int row)
{
  return texelFetch(table, ivec2(int(entry), row), 0);
}

// Adds a part behind others to an associated colour: the integrals at its front and back, and what
// makes their difference an optical depth.
vec4 AddPart(vec4 color, vec4 front, vec4 back, float scale)
{
  vec4 sum = abs(back - front);
  float opacity = (1.0 - color.a) * (1.0 - exp2(-sum.a * scale));
  return color + opacity * vec4(clamp(sum.rgb / max(sum.a, 1e-30), 0.0, 1.0), 1.0);
}

// The associated colour of a slab by the functions of one row. It has two parts, because its front hides some
// of its back. entry, integrals: at its front, then at its back.
vec4 IntegrateSlab(
  float middle, float back, float units, int row, inout float entry, inout vec4 integrals)
{
  vec4 color = vec4(0.0);
  for (int part = 0; part < 2; ++part)
  {
    float next = FindEntry(part == 0 ? middle : back, entry);
    vec4 behind = FetchIntegrals(integralTable, next, row);
    color = AddPart(color, integrals, behind, 0.5 * units / abs(next - entry));
    entry = next;
    integrals = behind;
  }
  return color;
}

// The associated colours of the slabs by one component's functions.
void IntegrateComponent(
  vec4 points[POINTS], float units[TEXTURE_SLICE_SLABS], int row, out vec4 colors[TEXTURE_SLICE_SLABS])
{
#if TEXTURE_SLICE_FUNCTIONS > 1
  int component = row;
  float ratio = unitDistanceRatio[row];
#else
  const int component = TEXTURE_SLICE_COMPONENTS - 1;
  const float ratio = 1.0;
#endif
  float entry = FindEntry(points[0][component], -1.0);
  vec4 integrals = FetchIntegrals(integralTable, entry, row);
  for (int i = 0; i < TEXTURE_SLICE_SLABS; ++i)
  {
    colors[i] = IntegrateSlab(points[2 * i + 1][component], points[2 * i + 2][component], ratio * units[i],
      row, entry, integrals);
#if TEXTURE_SLICE_FUNCTIONS == 1 && TEXTURE_SLICE_COMPONENTS == 2
    colors[i].rgb = colors[i].a * LookUp(points[2 * i + 1].x, 0).rgb;
#elif TEXTURE_SLICE_FUNCTIONS == 1 && TEXTURE_SLICE_COMPONENTS > 2
    colors[i].rgb = colors[i].a * clamp(points[2 * i + 1].rgb, 0.0, 1.0);
#endif
  }
}

// A slab with its colours before gradient opacity and light.
struct Slab
{
  vec4 colors[TEXTURE_SLICE_FUNCTIONS]; // associated
  vec4 scalars;                         // in the middle
  float at;                             // of the middle, on the ray
  vec3 place;                           // and as texture coordinates
#ifdef TEXTURE_SLICE_LABELS
  vec4 labelled; // associated colour by the label's functions
  int label;
#endif
};

#ifdef TEXTURE_SLICE_LABELS
// The same by the functions of the label in the slab's middle. scalars: front, middle and back.
void AddLabel(inout Slab slab, vec3 scalars, float units)
{
  slab.label = FetchLabel(slab.place);
  int row = FindRow(0, slab.label);
  float entry = FindEntry(scalars.x, -1.0);
  vec4 integrals = FetchIntegrals(integralTable, entry, row);
  slab.labelled = IntegrateSlab(scalars.y, scalars.z, units, row, entry, integrals);
}
#endif

vec4 FinishColor(vec4 color, vec4 scalars, int component, int label)
{
  return color.a > 0.0 ? Finish(vec4(color.rgb / color.a, color.a), scalars, component, label)
                       : vec4(0.0);
}

vec4 FinishSlab(Slab slab)
{
  sampleAt = slab.at;
#if !defined TEXTURE_SLICE_GRADIENT && !defined TEXTURE_SLICE_LABELS && TEXTURE_SLICE_FUNCTIONS == 1
  return slab.colors[0];
#else
  textureCoordinate = slab.place;
#if TEXTURE_SLICE_FUNCTIONS > 1
  vec4 colors[TEXTURE_SLICE_COMPONENTS];
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    colors[i] = FinishColor(slab.colors[i], slab.scalars, i, 0);
  }
  return AddComponents(colors);
#else
  vec4 color = FinishColor(slab.colors[0], slab.scalars, 0, 0);
#ifdef TEXTURE_SLICE_LABELS
  if (slab.label > 0)
  {
    color = mix(color, FinishColor(slab.labelled, slab.scalars, 0, slab.label), labelWeight);
  }
#endif
  return vec4(color.rgb * color.a, color.a);
#endif
#endif
}

#ifdef TEXTURE_SLICE_GRADIENT
// TEXTURE_SLICE_SLABS, unknown to the compiler, which would take seconds for copies of gradient and light.
uniform int slabsOfPiece;
#endif

// Divides a piece of the ray into slabs. frontEnd: at the front of the piece, then at its back.
void GatherPiece(float front, float back, inout SlabEnd frontEnd)
{
  float thickness = (back - front) / float(TEXTURE_SLICE_SLABS);
  SlabEnd ends[ENDS];
  ends[0] = frontEnd;
  for (int i = 1; i <= TEXTURE_SLICE_SLABS; ++i)
  {
    ends[i] = FetchEnd(PlaceAt(front + float(i) * thickness));
  }
  frontEnd = ends[TEXTURE_SLICE_SLABS];
  FillHiddenEnds(ends);
  vec4 points[POINTS];
  FindPoints(ends, points);
  Slab slabs[TEXTURE_SLICE_SLABS];
  float units[TEXTURE_SLICE_SLABS];
  for (int i = 0; i < TEXTURE_SLICE_SLABS; ++i)
  {
    slabs[i].at = front + (float(i) + 0.5) * thickness;
    slabs[i].place = PlaceAt(slabs[i].at);
    slabs[i].scalars = points[2 * i + 1];
    units[i] = !IsLeft(slabs[i].place)
      ? 0.0
      : FindVisibleShare(ends[i], ends[i + 1]) * thickness * length(sampleStep);
#ifdef TEXTURE_SLICE_LABELS
    AddLabel(slabs[i], vec3(points[2 * i].x, points[2 * i + 1].x, points[2 * i + 2].x), units[i]);
#endif
  }
  for (int row = 0; row < TEXTURE_SLICE_FUNCTIONS; ++row)
  {
    vec4 colors[TEXTURE_SLICE_SLABS];
    IntegrateComponent(points, units, row, colors);
    for (int i = 0; i < TEXTURE_SLICE_SLABS; ++i)
    {
      slabs[i].colors[row] = colors[i];
    }
  }
#ifdef TEXTURE_SLICE_GRADIENT
  int count = slabsOfPiece;
#else
  const int count = TEXTURE_SLICE_SLABS;
#endif
  for (int i = 0; i < count; ++i)
  {
    Add(FinishSlab(slabs[i]));
    if (i != 1)
    {
      EndTurn();
    }
  }
}
#endif
