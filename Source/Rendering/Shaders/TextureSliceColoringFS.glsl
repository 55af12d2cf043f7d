// Rows of colour and opacity over 0 to 1, one for each set of functions and one for each label from 1 on;
// then, with gradient opacity, as many rows of it. A single row is a 1-D texture, whose look-up reads half as
// many texels. Composite: alpha is the optical depth of a unit distance, in factors of 2 (Formulas R1).
uniform TEXTURE_SLICE_TABLE transferTable;
// From 0 to 1 to the centres of the first and the last entry.
uniform float tableScale;
uniform float tableBias;

vec4 LookUpRow(sampler1D table, float at, int row, int rows)
{
  return textureLod(table, at, 0.0);
}

vec4 LookUpRow(sampler2D table, float at, int row, int rows)
{
  return textureLod(table, vec2(at, (float(row) + 0.5) / float(rows)), 0.0);
}

vec4 LookUp(float scalar, int row)
{
  return LookUpRow(transferTable, scalar * tableScale + tableBias, row, TEXTURE_SLICE_ROWS);
}

uniform float componentWeight[TEXTURE_SLICE_COMPONENTS];
// The unit distance of the first component over those of all.
uniform float unitDistanceRatio[TEXTURE_SLICE_COMPONENTS];

// Unit distances of a component that the sample stands for.
float CountUnits(int component)
{
#if TEXTURE_SLICE_FUNCTIONS > 1
  return sampleUnits * unitDistanceRatio[component];
#else
  return sampleUnits;
#endif
}

// The row of a component's functions, or of a label's above 0.
int FindRow(int component, int label)
{
  return label > 0 ? TEXTURE_SLICE_FUNCTIONS + label - 1 : component;
}

#ifdef TEXTURE_SLICE_LABELS
// How much the label's functions count, the rest being the common ones.
uniform float labelWeight;
#endif

#ifdef TEXTURE_SLICE_TABLE_2D
// Over scalar (to the right) and gradient magnitude or second array (up), all sets one above the other.
uniform sampler2D transferTable2D;

// What a set of functions makes of a scalar.
vec4 Classify(vec4 scalars, float scalar, int functions)
{
#ifdef TEXTURE_SLICE_SECOND_ARRAY
  float up = FetchSecond(textureCoordinate, functions);
#else
  float up = Gradient(scalars, functions).w;
#endif
  float rows = float(textureSize(transferTable2D, 0).y / TEXTURE_SLICE_FUNCTIONS); // of one set
  float row = clamp(up * rows, 0.5, rows - 0.5);
  return textureLod(transferTable2D,
    vec2(scalar, row / rows + float(functions)) / vec2(1.0, float(TEXTURE_SLICE_FUNCTIONS)), 0.0);
}
#else
vec4 Classify(vec4 scalars, float scalar, int functions)
{
  return LookUp(scalar, functions);
}
#endif

#if TEXTURE_SLICE_BLEND == TEXTURE_SLICE_COMPOSITE || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_PLANE
// Samples are coloured and blended.
#define TEXTURE_SLICE_BLENDS_SAMPLES 1
#endif

#if defined TEXTURE_SLICE_BLENDS_SAMPLES || TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
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

// Gradient opacity, light and shadow on the colour of one step.
vec4 Finish(vec4 color, vec4 scalars, int component, int label)
{
#ifdef TEXTURE_SLICE_GRADIENT
  vec4 gradient = Gradient(scalars, component);
#ifdef TEXTURE_SLICE_GRADIENT_OPACITY
  color.a = WeakenOpacity(color.a, LookUp(gradient.w, TEXTURE_SLICE_ROWS / 2 + FindRow(component, label)).a);
#endif
#ifdef TEXTURE_SLICE_LIGHTS
  vec4 surface = material[component];
#ifdef TEXTURE_SLICE_SHADOWS
  // The sky lights what is ambient, the light the rest.
  surface.xyz *= FindArriving(gradient.xyz).yxx;
#endif
  color.rgb = clamp(Light(color.rgb, gradient.xyz, surface), 0.0, 1.0);
#endif
#endif
#if defined TEXTURE_SLICE_SHADOWS && !defined TEXTURE_SLICE_LIGHTS && \
  TEXTURE_SLICE_BLEND == TEXTURE_SLICE_ISOSURFACE
  vec2 arriving = FindArriving(gradient.xyz);
  color.rgb *= arriving.x * arriving.y;
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

