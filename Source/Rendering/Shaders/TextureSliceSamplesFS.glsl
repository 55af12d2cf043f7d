// What the samples of a ray add up to.

// What was gathered so far, in the terms of the blend mode.
vec4 picture = vec4(0.0);

#if TEXTURE_SLICE_FUNCTIONS == 1
// Of dependent components the last one gives the opacity.
vec4 ClassifyDependent(vec4 scalars)
{
  vec4 color = Classify(scalars, scalars[TEXTURE_SLICE_COMPONENTS - 1], 0);
#if TEXTURE_SLICE_COMPONENTS == 2
  color.rgb = Classify(scalars, scalars.x, 0).rgb;
#elif TEXTURE_SLICE_COMPONENTS > 2
  color.rgb = clamp(scalars.rgb, 0.0, 1.0);
#endif
  return color;
}
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
  // Of a small depth the difference has few digits: two terms of its series err by less.
  float depth = 0.69314718 * alpha * CountUnits(component);
  return depth < 0.01 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
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
bool Gather(vec4 scalars, out vec4 gathered)
{
  vec4 colors[TEXTURE_SLICE_COMPONENTS];
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    colors[i] = StepColor(Classify(scalars, scalars[i], i), scalars, i, 0);
  }
  gathered = AddComponents(colors);
  return gathered.a > 0.0;
}
#else
bool Gather(vec4 scalars, out vec4 gathered)
{
  vec4 color = StepColor(ClassifyDependent(scalars), scalars, 0, 0);
#ifdef TEXTURE_SLICE_LABELS
  int label = FetchLabel(textureCoordinate);
  if (label > 0)
  {
    vec4 labelled = StepColor(LookUp(scalars.x, FindRow(0, label)), scalars, 0, label);
    color = mix(color, labelled, labelWeight);
  }
#endif
  gathered = vec4(color.rgb * color.a, color.a);
  return color.a > 0.0;
}
#endif
#endif

#if TEXTURE_SLICE_BLEND >= TEXTURE_SLICE_MAXIMUM && TEXTURE_SLICE_BLEND <= TEXTURE_SLICE_ADDITIVE
// Of projections, scalars are gathered.
bool Gather(vec4 scalars, out vec4 gathered)
{
  gathered = scalars;
  return true;
}
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MAXIMUM || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MINIMUM
// The extremes are coloured at the end of the ray.
bool isSampled = false;

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_MAXIMUM
#define FARTHER(a, b) max(a, b)
#else
#define FARTHER(a, b) min(a, b)
#endif

void Add(vec4 scalars)
{
#ifdef TEXTURE_SLICE_EXTREME_SAMPLE
  // All components of the sample with the extreme of the last one, the nearest of several.
  const int last = TEXTURE_SLICE_COMPONENTS - 1;
  picture = isSampled && FARTHER(picture[last], scalars[last]) == picture[last] ? picture : scalars;
#else
  picture = isSampled ? FARTHER(picture, scalars) : scalars;
#endif
  isSampled = true;
}

vec4 FindPicture()
{
  if (!isSampled)
  {
    return vec4(0.0);
  }
#ifdef TEXTURE_SLICE_EXTREME_SAMPLE
  vec4 color = ClassifyDependent(picture);
  return vec4(color.rgb * color.a, color.a);
#else
  vec4 sum = vec4(0.0);
  for (int i = 0; i < TEXTURE_SLICE_COMPONENTS; ++i)
  {
    vec4 color = LookUp(picture[i], i);
    sum += componentWeight[i] * vec4(color.rgb * color.a, color.a);
  }
  return sum;
#endif
}
#elif TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_AVERAGE
// The scalars of each component that count in an average, 0 to 1 as they are.
uniform vec4 averageFrom;
uniform vec4 averageTo;

// For each set of functions, the picture is the sum of scalar times opacity; and these are the samples that count.
vec4 samples = vec4(0.0);

void Add(vec4 scalars)
{
  for (int i = 0; i < TEXTURE_SLICE_FUNCTIONS; ++i)
  {
    // Of dependent components the last one gives the opacity.
    float opacity = LookUp(scalars[i + TEXTURE_SLICE_COMPONENTS - TEXTURE_SLICE_FUNCTIONS], i).a;
#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ADDITIVE
    float counts = CountUnits(i);
    samples[i] = 1.0;
#else
    float counts = scalars[i] >= averageFrom[i] && scalars[i] <= averageTo[i] ? 1.0 : 0.0;
    samples[i] += counts;
#endif
    picture[i] += counts * scalars[i] * opacity * componentWeight[i];
  }
}

// Grey, opaque where there are samples.
vec4 FindPicture()
{
  float grey = dot(picture / max(samples, 1.0), vec4(1.0));
  return dot(samples, vec4(1.0)) > 0.0 ? vec4(vec3(clamp(grey, 0.0, 1.0)), 1.0) : vec4(0.0);
}
#elif defined TEXTURE_SLICE_PLACES
// The first place that is seen, as texture coordinates; alpha is 1 there.
void Add(vec4 gathered)
{
  picture = picture.a > 0.0 || gathered.a <= 0.0 ? picture : vec4(textureCoordinate, 1.0);
}

// Where nothing is seen, the beginning of the ray, with an alpha of one half.
vec4 FindPicture()
{
  return picture.a > 0.0 ? picture : vec4(PlaceAt(raySpan.x), 0.5);
}
#else
// Formulas T9, R3: associated colour, front to back.
#ifdef TEXTURE_SLICE_LIT_TURNS
// Samples of one turn of the loop are lit together, at the mean of their places.
vec3 unlit = vec3(0.0);
// The sum of their places times the opacities that they add, and that of these opacities.
vec2 ofTurn = vec2(0.0);

void Add(vec4 gathered)
{
  gathered *= 1.0 - picture.a;
  picture.a += gathered.a;
  unlit += gathered.rgb;
  ofTurn += gathered.a * vec2(sampleAt, 1.0);
}

void EndTurn()
{
  picture.rgb += unlit * FetchLight(PlaceAt(ofTurn.x / max(ofTurn.y, 1e-30)));
  unlit = vec3(0.0);
  ofTurn = vec2(0.0);
}
#else
void Add(vec4 gathered)
{
  picture += (1.0 - picture.a) * gathered;
}
#endif

vec4 FindPicture()
{
  return picture;
}
#endif

#if !defined TEXTURE_SLICE_LIT_TURNS || defined TEXTURE_SLICE_PLACES
void EndTurn()
{
}
#endif

#ifdef TEXTURE_SLICE_CONTOURS
// Contours of the first component, 0 to 1 as the scalars are: what is in front of the first one is left out.
uniform float contours[TEXTURE_SLICE_CONTOURS];
float scalarBefore = 0.0;
bool isSampleBefore = false;
bool isBehindContour = false;

bool IsBehindContour(float scalar)
{
  for (int i = 0; i < TEXTURE_SLICE_CONTOURS && isSampleBefore; ++i)
  {
    isBehindContour = isBehindContour || (scalarBefore < contours[i]) != (scalar < contours[i]);
  }
  scalarBefore = scalar;
  isSampleBefore = true;
  return isBehindContour;
}
#endif

#if !defined TEXTURE_SLICE_SLABS && TEXTURE_SLICE_BLEND != TEXTURE_SLICE_ISOSURFACE
void GatherSample(float at)
{
  sampleAt = at;
  textureCoordinate = PlaceAt(at);
  vec4 scalars;
  vec4 gathered;
  if (!IsLeft(textureCoordinate) || !FetchScalars(textureCoordinate, scalars))
  {
    return;
  }
#ifdef TEXTURE_SLICE_CONTOURS
  if (!IsBehindContour(scalars.x))
  {
    return;
  }
#endif
  if (Gather(scalars, gathered))
  {
    Add(gathered);
  }
}
#endif
