// What a sample adds to the picture.

// Rows of colour and opacity over 0 to 1, one for each set of functions; then, with gradient
// opacity, as many rows of it.
uniform sampler2D transferTable;
// From 0 to 1 to the centres of the first and the last entry.
uniform float tableScale;
uniform float tableBias;
uniform float inverseUnitDistance[TEXTURE_SLICE_COMPONENTS];
uniform float componentWeight[TEXTURE_SLICE_COMPONENTS];

vec4 LookUp(float scalar, int row)
{
  return texture(transferTable,
    vec2(scalar * tableScale + tableBias, (float(row) + 0.5) / float(TEXTURE_SLICE_ROWS)));
}

// Formulas R1: the opacity of a step is that of a unit distance to the power of their ratio.
float StepOpacity(float opacity, int component)
{
  return 1.0 - pow(1.0 - opacity, length(sampleStep) * inverseUnitDistance[component]);
}

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
// Gradient opacity and light on a colour.
vec4 Finish(vec4 color, vec4 scalars, int component)
{
#ifdef TEXTURE_SLICE_GRADIENT
  vec4 gradient = Gradient(scalars, component);
#ifdef TEXTURE_SLICE_GRADIENT_OPACITY
  color.a *= LookUp(gradient.w, TEXTURE_SLICE_FUNCTIONS + component).a;
#endif
#ifdef TEXTURE_SLICE_LIGHTS
  color.rgb = clamp(Light(color.rgb, gradient.xyz, material[component]), 0.0, 1.0);
#endif
#endif
  return color;
}
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE
#if TEXTURE_SLICE_FUNCTIONS > 1
// Components that have their own functions: their colours are added by their weights.
bool Gather(vec4 scalars, out vec4 gathered)
{
  vec4 colors[TEXTURE_SLICE_COMPONENTS];
  float total = 0.0;
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    vec4 color = LookUp(scalars[i], i);
    color.a = StepOpacity(color.a, i);
    colors[i] = color.a > 0.0 ? Finish(color, scalars, i) : vec4(0.0);
    total += colors[i].a * componentWeight[i];
  }
  gathered = vec4(0.0);
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    if (total > 0.0 && componentWeight[i] > 0.0)
    {
      gathered.rgb += colors[i].rgb * colors[i].a * componentWeight[i];
      gathered.a += colors[i].a * colors[i].a / total;
    }
  }
  return total > 0.0;
}
#else
// Colour and opacity of a unit distance.
vec4 Classify(vec4 scalars)
{
#if TEXTURE_SLICE_COMPONENTS == 1
  return LookUp(scalars.x, 0);
#elif TEXTURE_SLICE_COMPONENTS == 2
  return vec4(LookUp(scalars.x, 0).rgb, LookUp(scalars.y, 0).a);
#else
  return vec4(clamp(scalars.rgb, 0.0, 1.0), LookUp(scalars.a, 0).a);
#endif
}

bool Gather(vec4 scalars, out vec4 gathered)
{
  vec4 color = Classify(scalars);
  if (color.a <= 0.0)
  {
    return false;
  }
  color.a = StepOpacity(color.a, 0);
  color = Finish(color, scalars, 0);
  gathered = vec4(color.rgb * color.a, color.a);
  return true;
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
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE
// Red: the sum of scalar times opacity. Alpha: above 0 where there are samples.
bool Gather(vec4 scalars, out vec4 gathered)
{
  float sum = 0.0;
  float steps = length(sampleStep);
#if TEXTURE_SLICE_FUNCTIONS > 1
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    sum += scalars[i] * LookUp(scalars[i], i).a * steps * inverseUnitDistance[i] * componentWeight[i];
  }
#else
  sum = scalars.x * LookUp(scalars[TEXTURE_SLICE_COMPONENTS - 1], 0).a * steps * inverseUnitDistance[0];
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
// From the vector to the next slice to texture coordinates.
uniform vec3 stepToTexture;
// Where the box begins and ends.
uniform vec3 boxLow;
uniform vec3 boxHigh;

vec4 SurfaceColor(float isoValue, vec4 scalars)
{
  vec4 color = LookUp(isoValue, 0);
  return color.a > 0.0 ? Finish(color, scalars, 0) : vec4(0.0);
}

// The surfaces between this sample and the one before it on the ray, the nearest first.
bool Gather(vec4 scalars, out vec4 gathered)
{
  vec3 before = textureCoordinate - sampleStep * stepToTexture;
  vec4 nearer;
  if (any(lessThan(before, boxLow)) || any(greaterThan(before, boxHigh)) ||
    !FetchScalars(before, nearer))
  {
    return false;
  }
  bool rising = scalars.x > nearer.x;
  vec2 between = vec2(min(nearer.x, scalars.x), max(nearer.x, scalars.x));
  gathered = vec4(0.0);
  for (int i = 0; i < TEXTURE_SLICE_ISO_VALUES; ++i)
  {
    float isoValue = isoValues[rising ? i : TEXTURE_SLICE_ISO_VALUES - 1 - i];
    if (isoValue >= between.x && isoValue < between.y)
    {
      vec4 color = SurfaceColor(isoValue, scalars);
      gathered += (1.0 - gathered.a) * vec4(color.rgb * color.a, color.a);
    }
  }
  return gathered.a > 0.0;
}
#endif
