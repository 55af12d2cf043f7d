#ifdef TEXTURE_SLICE_SLABS
// Pre-integrated classification (Formulas L1): slabs between two planes. Along a slab, the scalar is
// linear from its front to its middle, and from there to its back.

// For each set of functions, the integrals over the scalars from 0 on: colour times optical depth of
// a unit distance, and that depth; the integrals are counted in entries.
uniform TEXTURE_SLICE_INTEGRAL_TABLE integralTable;
// The number of the last entry, that of the scalar 1.
uniform float lastIntegral;

// Scalars at one end of a slab.
struct SlabEnd
{
  vec4 scalars;
#ifdef TEXTURE_SLICE_HIDING
  float visible; // below 0: hidden
#endif
};

SlabEnd FetchEnd(vec3 at)
{
  SlabEnd end;
#ifdef TEXTURE_SLICE_HIDING
  end.visible = FetchVisibility(at, end.scalars);
#else
  FetchScalars(at, end.scalars);
#endif
  return end;
}

// Which part of a slab is visible: the visible points end where the mask, linear along the slab, is
// one half.
float FindVisibleShare(SlabEnd front, SlabEnd back)
{
#ifdef TEXTURE_SLICE_HIDING
  if ((front.visible < 0.0) == (back.visible < 0.0))
  {
    return front.visible < 0.0 ? 0.0 : 1.0;
  }
  return max(front.visible, back.visible) / abs(front.visible - back.visible);
#else
  return 1.0;
#endif
}

// The second difference of the scalars about three ends in a row.
vec4 FindBend(SlabEnd before, SlabEnd here, SlabEnd after)
{
#ifdef TEXTURE_SLICE_HIDING
  if (min(min(before.visible, here.visible), after.visible) < 0.0)
  {
    return vec4(0.0);
  }
#endif
  return before.scalars - 2.0 * here.scalars + after.scalars;
}

// The smaller one of two bends in the same direction: at a jump, whose bends have opposite directions,
// the scalars are linear.
vec4 LimitBend(vec4 a, vec4 b)
{
  return 0.5 * (sign(a) + sign(b)) * min(abs(a), abs(b));
}

// Integrals are read at whole entries, because interpolating two of them costs a software renderer
// twice as much.
float FindEntry(float scalar, float lastEntry)
{
  return floor(clamp(scalar * lastEntry, 0.0, lastEntry - 1.0) + 0.5);
}

// Where two scalars in a row have the same entry, the second one has the entry on its other side: for
// equal scalars the mean between the two entries about them is the limit.
float FindNextEntry(float before, float scalar, float lastEntry)
{
  float place = clamp(scalar * lastEntry, 0.0, lastEntry - 1.0);
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

// Associated colour of a slab, so many unit distances thick, by one component's functions. A slab has two
// parts, because its front hides some of its back. scalars: front, middle and back.
vec4 IntegrateComponent(vec4 scalars[3], float units, int row)
{
#if TEXTURE_SLICE_FUNCTIONS > 1
  int component = row;
  units *= unitDistanceRatio[row];
#else
  const int component = TEXTURE_SLICE_COMPONENTS - 1;
#endif
  float last = FindEntry(scalars[0][component], lastIntegral);
  vec4 front = FetchIntegrals(integralTable, last, row);
  vec4 color = vec4(0.0);
  for (int k = 1; k <= 2; ++k)
  {
    float entry = FindNextEntry(last, scalars[k][component], lastIntegral);
    vec4 back = FetchIntegrals(integralTable, entry, row);
    color = AddPart(color, front, back, 0.5 * units / abs(entry - last));
    last = entry;
    front = back;
  }
#if TEXTURE_SLICE_FUNCTIONS == 1 && TEXTURE_SLICE_COMPONENTS == 2
  color.rgb = color.a * LookUp(scalars[1].x, 0).rgb;
#elif TEXTURE_SLICE_FUNCTIONS == 1 && TEXTURE_SLICE_COMPONENTS > 2
  color.rgb = color.a * clamp(scalars[1].rgb, 0.0, 1.0);
#endif
  return color;
}

// A slab with its colours before gradient opacity and light.
struct Slab
{
  vec4 colors[TEXTURE_SLICE_FUNCTIONS]; // associated
  vec4 scalars;                         // in the middle
  vec3 place;                           // of the middle, as texture coordinates
#ifdef TEXTURE_SLICE_LABELS
  vec4 labelled; // associated colour by the label's functions
  int label;
#endif
};

#ifdef TEXTURE_SLICE_LABELS
uniform TEXTURE_SLICE_INTEGRAL_TABLE labelIntegralTable;
uniform float lastLabelIntegral;

// The same by the functions of the label in the slab's middle. scalars: front, middle and back.
void AddLabel(inout Slab slab, vec3 scalars, float units)
{
  slab.labelled = vec4(0.0);
  slab.label = FetchLabel(slab.place);
  if (slab.label == 0)
  {
    return;
  }
  int row = slab.label - 1;
  float last = FindEntry(scalars.x, lastLabelIntegral);
  vec4 front = FetchIntegrals(labelIntegralTable, last, row);
  for (int k = 1; k <= 2; ++k)
  {
    float entry = FindNextEntry(last, scalars[k], lastLabelIntegral);
    vec4 back = FetchIntegrals(labelIntegralTable, entry, row);
    slab.labelled = AddPart(slab.labelled, front, back, 0.5 * units / abs(entry - last));
    last = entry;
    front = back;
  }
}
#endif

// Whether any function shows something of a slab.
bool IsVisible(Slab slab)
{
  float opacity = 0.0;
  for (int i = 0; i < TEXTURE_SLICE_FUNCTIONS; ++i)
  {
    opacity += slab.colors[i].a;
  }
#ifdef TEXTURE_SLICE_LABELS
  opacity += slab.labelled.a;
#endif
  return opacity > 0.0;
}

// Gradient opacity and light on an associated colour.
vec4 FinishColor(vec4 color, vec4 scalars, int component, int label)
{
  return color.a > 0.0 ? Finish(vec4(color.rgb / color.a, color.a), scalars, component, label)
                       : vec4(0.0);
}

// The associated colour of a slab.
vec4 FinishSlab(Slab slab)
{
#if !defined TEXTURE_SLICE_GRADIENT && !defined TEXTURE_SLICE_SHADOWS && \
  !defined TEXTURE_SLICE_LABELS && TEXTURE_SLICE_FUNCTIONS == 1
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

// The ends of slabs in a row: before the slab, its front, its back, and behind it.
SlabEnd ends[4];
bool isFirstSlab = true;

void FetchEnds(float front, float back, bool begins)
{
  isFirstSlab = begins;
  if (begins)
  {
    ends[1] = FetchEnd(PlaceAt(front));
    ends[2] = FetchEnd(PlaceAt(back));
  }
  else
  {
    ends[0] = ends[1];
    ends[1] = ends[2];
    ends[2] = ends[3];
  }
  if (back < raySpan.y)
  {
    ends[3] = FetchEnd(PlaceAt(min(back + 1.0, raySpan.y)));
  }
}

// How far the middle of the slab is off the line between its ends: where the parabola has it that they
// and the next ones lie on. A slab that ends between two planes is taken as linear.
vec4 FindBow(float front, float back)
{
  if (back - front < 0.999)
  {
    return vec4(0.0);
  }
  bool isLastSlab = back >= raySpan.y;
  vec4 before = isFirstSlab ? vec4(0.0) : FindBend(ends[0], ends[1], ends[2]);
  vec4 behind = isLastSlab ? before : FindBend(ends[1], ends[2], ends[3]);
  return -0.125 * LimitBend(isFirstSlab ? behind : before, behind);
}

void FindScalars(float front, float back, out vec4 scalars[3])
{
  scalars[0] = ends[1].scalars;
  scalars[2] = ends[2].scalars;
#ifdef TEXTURE_SLICE_HIDING
  // A hidden end has the scalars of the visible one.
  scalars[0] = ends[1].visible < 0.0 ? scalars[2] : scalars[0];
  scalars[2] = ends[2].visible < 0.0 ? scalars[0] : scalars[2];
#endif
  scalars[1] = 0.5 * (scalars[0] + scalars[2]) + FindBow(front, back);
}

void GatherPiece(float front, float back, bool begins)
{
  FetchEnds(front, back, begins);
  Slab slab;
  slab.place = PlaceAt(0.5 * (front + back));
  float share = IsLeft(slab.place) ? FindVisibleShare(ends[1], ends[2]) : 0.0;
  if (share <= 0.0)
  {
    return;
  }
  float units = share * (back - front) * length(sampleStep);
  vec4 scalars[3];
  FindScalars(front, back, scalars);
  slab.scalars = scalars[1];
  for (int row = 0; row < TEXTURE_SLICE_FUNCTIONS; ++row)
  {
    slab.colors[row] = IntegrateComponent(scalars, units, row);
  }
#ifdef TEXTURE_SLICE_LABELS
  AddLabel(slab, vec3(scalars[0].x, scalars[1].x, scalars[2].x), units);
#endif
  if (IsVisible(slab))
  {
    Add(FinishSlab(slab));
  }
}
#endif
