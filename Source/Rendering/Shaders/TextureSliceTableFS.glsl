// Rows of colour and opacity over 0 to 1, one for each set of functions; then, with gradient
// opacity, as many rows of it. A single row is a 1-D texture: its look-up reads half as many texels.
// Composite: the alpha of the sets of functions is the optical depth of a unit distance, for each
// factor of 2 that it weakens what is behind (Formulas R1).
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
