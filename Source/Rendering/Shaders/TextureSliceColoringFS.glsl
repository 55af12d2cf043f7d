// What a sample adds to the picture.

uniform float componentWeight[TEXTURE_SLICE_COMPONENTS];

#if TEXTURE_SLICE_FUNCTIONS > 1
// The unit distance of the first component over those of all.
uniform float unitDistanceRatio[TEXTURE_SLICE_COMPONENTS];
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE
// The sample and the vector to the next slice, where the part of the box that is drawn is -0.5 to 0.5
// along each axis.
in vec3 partPosition;
in vec3 partStep;

// Slice distances back to where the ray enters the part, and on to where it leaves it.
vec2 DistancesToFaces()
{
  vec3 perPart = 1.0 / (partStep + 1e-12); // not 0 along a face
  vec3 fromMiddle = partPosition * perPart;
  vec3 halfPart = abs(0.5 * perPart);
  vec3 entry = halfPart + fromMiddle;
  vec3 exit = halfPart - fromMiddle;
  return vec2(min(min(entry.x, entry.y), entry.z), min(min(exit.x, exit.y), exit.z));
}

// Slice distances that this sample stands for: half of one on either side. The first and the last
// sample on a ray stand for all up to the face of the box, so that each ray has its exact length.
float CountSteps()
{
  vec2 faces = DistancesToFaces();
  return (faces.x < 1.0 ? faces.x : 0.5) + (faces.y < 1.0 ? faces.y : 0.5);
}

// Unit distances that this sample stands for.
float CountUnits(int component)
{
#if TEXTURE_SLICE_FUNCTIONS > 1
  return CountSteps() * length(sampleStep) * unitDistanceRatio[component];
#else
  return CountSteps() * length(sampleStep);
#endif
}
#endif

#ifdef TEXTURE_SLICE_LABELS
// Rows of colour and opacity, one for each label from 1 on; then, with gradient opacity, as many rows
// of it.
uniform TEXTURE_SLICE_LABEL_TABLE labelTable;
uniform float labelTableScale;
uniform float labelTableBias;
// How much the label's functions count, the rest being the common ones.
uniform float labelWeight;

vec4 LookUpLabel(float scalar, int row)
{
  return LookUpRow(
    labelTable, scalar * labelTableScale + labelTableBias, row, TEXTURE_SLICE_LABEL_ROWS);
}
#endif

#ifdef TEXTURE_SLICE_TABLE_2D
// Colour and opacity over scalar (to the right) and gradient magnitude or second array (up), all sets of
// functions one above the other.
uniform sampler2D transferTable2D;
// Rows of one set.
uniform float table2DRows;

vec4 LookUp2D(vec4 scalars, float scalar, int functions)
{
#ifdef TEXTURE_SLICE_SECOND_ARRAY
  float up = FetchSecond(textureCoordinate, functions);
#else
  float up = Gradient(scalars, functions).w;
#endif
  float row = clamp(up * table2DRows, 0.5, table2DRows - 0.5);
  return texture(transferTable2D,
    vec2(scalar, row / table2DRows + float(functions)) / vec2(1.0, float(TEXTURE_SLICE_FUNCTIONS)));
}
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_PLANE
// Samples are coloured and blended.
#define TEXTURE_SLICE_BLENDS_SAMPLES 1
#endif

#if defined TEXTURE_SLICE_BLENDS_SAMPLES || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
#ifdef TEXTURE_SLICE_GRADIENT_OPACITY
// Label 0: the common functions.
float GradientOpacity(float magnitude, int component, int label)
{
#ifdef TEXTURE_SLICE_LABELS
  if (label > 0)
  {
    return LookUpLabel(magnitude, TEXTURE_SLICE_LABELS + label - 1).a;
  }
#endif
  return LookUp(magnitude, TEXTURE_SLICE_FUNCTIONS + component).a;
}
#endif

#ifdef TEXTURE_SLICE_GRADIENT_OPACITY
// The opacity of a step as the gradient weakens it: VTK's ray caster multiplies the opacity of a
// sample; of a slab, the extinction is multiplied, which is the limit for many samples.
float WeakenOpacity(float opacity, float gradientOpacity)
{
#ifdef TEXTURE_SLICE_SLABS
  return 1.0 - pow(1.0 - opacity, gradientOpacity);
#else
  return opacity * gradientOpacity;
#endif
}
#endif

#if defined TEXTURE_SLICE_SHADOWS && \
  (defined TEXTURE_SLICE_LIGHTS || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE)
// Of the light, and of the sky's, that arrive at a sample.
vec2 FindTransmittance(vec3 gradient)
{
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
  return FetchTransmittanceBeside(gradient);
#else
  return FetchTransmittance();
#endif
}
#endif

#ifdef TEXTURE_SLICE_LIGHTS
#ifdef TEXTURE_SLICE_SCATTERING
// How much of the light is scattered within the volume, as VTK 9.2's ray caster mixes it: the more,
// the less a place is like a surface.
float ScatteredPart(float gradient, float opacity)
{
  float fading = 2.0 * exp(-2.0 * scattering * gradient * opacity);
  return scattering < 0.5 ? scattering * fading
                          : (1.0 - scattering) * fading + 2.0 * scattering - 1.0;
}
#endif

// The light and the sky's light that arrive: the sky lights what is ambient, the light the rest.
vec3 LightAndShade(vec4 color, vec4 gradient, vec4 surface)
{
#ifdef TEXTURE_SLICE_SHADOWS
  vec2 transmittance = FindTransmittance(gradient.xyz);
  vec2 arriving = Weaken(transmittance);
  vec4 shadowed = vec4(surface.xyz * arriving.yxx, surface.w);
  vec3 lit = clamp(Light(color.rgb, gradient.xyz, shadowed), 0.0, 1.0);
#ifdef TEXTURE_SLICE_SCATTERING
  surface.xy *= vec2(arriving.y, transmittance.x);
  vec3 scattered = clamp(Scatter(color.rgb, surface), 0.0, 1.0);
  lit = mix(lit, scattered, ScatteredPart(gradient.w, color.a));
#endif
  return lit;
#else
  return clamp(Light(color.rgb, gradient.xyz, surface), 0.0, 1.0);
#endif
}
#endif

// Gradient opacity, light and shadow on the colour of one step.
vec4 Finish(vec4 color, vec4 scalars, int component, int label)
{
#ifdef TEXTURE_SLICE_GRADIENT
  vec4 gradient = Gradient(scalars, component);
#ifdef TEXTURE_SLICE_GRADIENT_OPACITY
  color.a = WeakenOpacity(color.a, GradientOpacity(gradient.w, component, label));
#endif
#ifdef TEXTURE_SLICE_LIGHTS
  color.rgb = LightAndShade(color, gradient, material[component]);
#endif
#endif
#if defined TEXTURE_SLICE_SHADOWS && !defined TEXTURE_SLICE_LIGHTS
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
  vec2 arriving = Weaken(FindTransmittance(gradient.xyz));
  color.rgb *= arriving.x * arriving.y;
#else
  color.rgb *= FetchLight();
#endif
#endif
  return color;
}
#endif

#ifdef TEXTURE_SLICE_BLENDS_SAMPLES
#if TEXTURE_SLICE_FUNCTIONS > 1
// Components that have their own functions: their colours are added by their weights.
vec4 AddComponents(vec4 colors[TEXTURE_SLICE_COMPONENTS])
{
  float total = 0.0;
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    total += colors[i].a * componentWeight[i];
  }
  vec4 sum = vec4(0.0);
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    if (total > 0.0 && componentWeight[i] > 0.0)
    {
      sum.rgb += colors[i].rgb * colors[i].a * componentWeight[i];
      sum.a += colors[i].a * colors[i].a / total;
    }
  }
  return sum;
}
#endif
#endif

#if defined TEXTURE_SLICE_BLENDS_SAMPLES && !defined TEXTURE_SLICE_SLABS
// Formulas R1: the opacity of a step, from the optical depth of a unit distance; two-dimensional
// tables hold its opacity. A plane has no thickness: its opacity is that of the table.
float StepOpacity(float alpha, int component)
{
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_PLANE
  return alpha;
#elif defined TEXTURE_SLICE_TABLE_2D
  return 1.0 - pow(1.0 - alpha, CountUnits(component));
#else
  return 1.0 - exp2(-alpha * CountUnits(component));
#endif
}

// Colour of one step for a component that has functions of its own, or for a single set of functions.
vec4 StepColor(vec4 color, vec4 scalars, int component, int label)
{
  if (color.a <= 0.0)
  {
    return vec4(0.0);
  }
  color.a = StepOpacity(color.a, component);
  return Finish(color, scalars, component, label);
}

#if TEXTURE_SLICE_FUNCTIONS > 1
vec4 Classify(vec4 scalars, int component)
{
#ifdef TEXTURE_SLICE_TABLE_2D
  return LookUp2D(scalars, scalars[component], component);
#else
  return LookUp(scalars[component], component);
#endif
}

bool Gather(vec4 scalars, out vec4 gathered)
{
  vec4 colors[TEXTURE_SLICE_COMPONENTS];
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    colors[i] = StepColor(Classify(scalars, i), scalars, i, 0);
  }
  gathered = AddComponents(colors);
  return gathered.a > 0.0;
}
#else
vec4 LookUpBoth(vec4 scalars, float scalar)
{
#ifdef TEXTURE_SLICE_TABLE_2D
  return LookUp2D(scalars, scalar, 0);
#else
  return LookUp(scalar, 0);
#endif
}

// Colour and what StepOpacity takes.
vec4 Classify(vec4 scalars)
{
#if TEXTURE_SLICE_COMPONENTS == 1
  return LookUpBoth(scalars, scalars.x);
#elif TEXTURE_SLICE_COMPONENTS == 2
  return vec4(LookUpBoth(scalars, scalars.x).rgb, LookUpBoth(scalars, scalars.y).a);
#else
  return vec4(clamp(scalars.rgb, 0.0, 1.0), LookUpBoth(scalars, scalars.a).a);
#endif
}

bool Gather(vec4 scalars, out vec4 gathered)
{
  vec4 color = StepColor(Classify(scalars), scalars, 0, 0);
#ifdef TEXTURE_SLICE_LABELS
  int label = FetchLabel(textureCoordinate);
  if (label > 0)
  {
    vec4 labelled = StepColor(LookUpLabel(scalars.x, label - 1), scalars, 0, label);
    color = mix(color, labelled, labelWeight);
  }
#endif
  gathered = vec4(color.rgb * color.a, color.a);
  return color.a > 0.0;
}
#endif
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MAXIMUM || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MINIMUM
// The extremes are coloured when all slices are drawn.
bool Gather(vec4 scalars, out vec4 gathered)
{
  gathered = scalars;
  return true;
}

#ifdef TEXTURE_SLICE_EXTREME_SAMPLE
// The depth test keeps the sample with the extreme of the last component, the nearest one of several;
// below the depth 1 that is there before.
float ExtremeDepth(vec4 scalars)
{
  float scalar = clamp(scalars[TEXTURE_SLICE_COMPONENTS - 1], 0.0, 1.0);
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MAXIMUM
  scalar = 1.0 - scalar;
#endif
  return 0.9999 * scalar;
}
#endif
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE
// Red: the sum of scalar times opacity. Alpha: above 0 where there are samples.
bool Gather(vec4 scalars, out vec4 gathered)
{
  float sum = 0.0;
#if TEXTURE_SLICE_FUNCTIONS > 1
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    sum += scalars[i] * LookUp(scalars[i], i).a * CountUnits(i) * componentWeight[i];
  }
#else
  sum = scalars.x * LookUp(scalars[TEXTURE_SLICE_COMPONENTS - 1], 0).a * CountUnits(0);
#endif
  gathered = vec4(sum, 0.0, 0.0, 1.0);
  return true;
}
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_AVERAGE
// The scalars that count, 0 to 1 as they are.
uniform vec2 averageRange;

// Red: the sum of scalar times opacity. Alpha: the number of samples.
bool Gather(vec4 scalars, out vec4 gathered)
{
#if TEXTURE_SLICE_FUNCTIONS > 1
  float sum = 0.0;
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    sum += scalars[i] * LookUp(scalars[i], i).a * componentWeight[i];
  }
  gathered = vec4(sum, 0.0, 0.0, 1.0);
  return true;
#else
  gathered = vec4(scalars.x * LookUp(scalars[TEXTURE_SLICE_COMPONENTS - 1], 0).a, 0.0, 0.0, 1.0);
  return scalars.x >= averageRange.x && scalars.x <= averageRange.y;
#endif
}
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// The values, ascending, 0 to 1 as the scalars are.
uniform float isoValues[TEXTURE_SLICE_ISO_VALUES];
// From sampleStep to texture coordinates.
uniform vec3 stepToTexture;
// Where the box begins and ends.
uniform vec3 boxLow;
uniform vec3 boxHigh;

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

// The surfaces between this sample and the one before it on the ray, the nearest first.
bool Gather(vec4 scalars, out vec4 gathered)
{
  vec3 here = textureCoordinate;
  vec3 before = here - sampleStep * stepToTexture;
  vec4 nearer;
  if (any(lessThan(before, boxLow)) || any(greaterThan(before, boxHigh)) ||
    !FetchScalars(before, nearer))
  {
    return false;
  }
  float nearScalar = nearer[surfaceComponent];
  float farScalar = scalars[surfaceComponent];
  bool rising = farScalar > nearScalar;
  vec2 between = vec2(min(nearScalar, farScalar), max(nearScalar, farScalar));
  gathered = vec4(0.0);
  for (int i = 0; i < TEXTURE_SLICE_ISO_VALUES; ++i)
  {
    int surface = rising ? i : TEXTURE_SLICE_ISO_VALUES - 1 - i;
    float isoValue = isoValues[surface];
    vec4 onSurface;
    if (isoValue >= between.x && isoValue < between.y &&
      FindSurface(isoValue, before, nearScalar, here, farScalar, onSurface) &&
      IsLeft(textureCoordinate))
    {
#ifdef TEXTURE_SLICE_SHADOWS
      litSurface = lightSurfaces[surface];
      sideOfEye = rising ? -1.0 : 1.0;
#endif
      vec4 color = SurfaceColor(isoValue, onSurface);
      gathered += (1.0 - gathered.a) * vec4(color.rgb * color.a, color.a);
    }
  }
  return gathered.a > 0.0;
}
#endif
