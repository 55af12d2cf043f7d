// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradTransferFunction
 * @brief   Colour and opacity of a radar moment as four splines
 *
 * Red, green, blue and opacity are cubic Hermite splines over the moment's values (dBZ for
 * reflectivity, m/s for velocity, …) with Cardinal tangents of tension
 * 0 at nodes that need not be evenly spaced (Formulas T10): at a node the slope is that from the
 * node before to the node after, at the first and last node that to the neighbour. Beyond the first
 * and last node a channel keeps its value. Results are clamped to 0 to 1. A channel that a table of
 * ramps or of opacities set goes from node to node in straight lines instead.
 *
 * A new object has the National Weather Service's reflectivity colours (Formulas R4), each colour's
 * node in the middle of its 5 dBZ, and the opacity of the preset "all echo".
 *
 * Volume properties take it through FillProperty. Opacities are those of the property's unit
 * distance.
 */
#ifndef vtkNexradTransferFunction_h
#define vtkNexradTransferFunction_h

#include "vtkNexradSceneModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr
#include <string> // for the text of a file

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkVolumeProperty;
struct vtkNexradColorMap;

class VTKNEXRADSCENE_EXPORT vtkNexradTransferFunction : public vtkObject
{
public:
  static vtkNexradTransferFunction* New();
  vtkTypeMacro(vtkNexradTransferFunction, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Takes over nodes, bins and iso-values of another one.
   */
  void DeepCopy(vtkNexradTransferFunction* other);

  /**
   * Whether nodes, bins and iso-values are those of another one.
   */
  bool IsEqual(vtkNexradTransferFunction* other) const;

  enum ChannelType
  {
    RED = 0,
    GREEN = 1,
    BLUE = 2,
    OPACITY = 3
  };

  ///@{
  /**
   * The nodes of a channel in ascending order. AddNode replaces a node at the same dBZ; MoveNode
   * keeps it between its neighbours. Values are clamped to 0 to 1. Returns the node's index, or -1
   * (with an error) when there is no such channel or node or a number is not finite. Changing red,
   * green or blue drops the bins.
   */
  int GetNumberOfNodes(int channel) const;
  bool GetNode(int channel, int index, double node[2]) const;
  int AddNode(int channel, double dBZ, double value);
  int MoveNode(int channel, int index, double dBZ, double value);
  bool RemoveNode(int channel, int index);
  void RemoveAllNodes(int channel);
  ///@}

  ///@{
  /**
   * Whether a channel goes from node to node in straight lines, in place of a spline. Off by
   * default; removing all nodes of a channel switches it off.
   */
  void SetLinear(int channel, bool linear);
  bool IsLinear(int channel) const;
  ///@}

  /**
   * Value of a channel, 0 to 1; 0 without nodes, and for what is not a number.
   */
  double Evaluate(int channel, double dBZ);

  /**
   * First and last node of all channels, dBZ; 0 and 0 without nodes.
   */
  void GetRange(double range[2]) const;

  /**
   * Stretches and shifts all nodes and bins so that the range becomes [first, last], first < last.
   * For maps whose points lie between 0 and 1.
   */
  void Rescale(double first, double last);

  ///@{
  /**
   * Puts the channels into VTK's functions, splines as sixteen linear pieces between neighbouring
   * nodes.
   */
  void FillColorFunction(vtkColorTransferFunction* function);
  void FillOpacityFunction(vtkPiecewiseFunction* function);
  ///@}

  /**
   * Gives a volume property both functions, for all components as one, and the iso-values. Its unit
   * distance, interpolation and shading stay.
   */
  void FillProperty(vtkVolumeProperty* property);

  ///@{
  /**
   * The values whose surfaces are to be drawn, in the unit of the data: those of the preset
   * "iso-values" and of SetOpacityToIsoValues. None once the opacity is changed in another way. A
   * mapper draws them as surfaces in the isosurface blend mode, and as shells in the composite one.
   */
  int GetNumberOfIsoValues() const;
  double GetIsoValue(int index) const; ///< 0 for no such index
  ///@}

  /**
   * The colour of the surface of a value: that of the bar's step which holds the value (a step
   * holds its lower end); where there is none, that of the channels. FillColorFunction has these
   * colours about the iso-values, so that a surface between two steps does not get a mixture of
   * both.
   */
  void GetSurfaceColor(double value, double color[3]);

  ///@{
  /**
   * The steps of a colour bar: each has a range in dBZ, a colour at its lower and one at its upper
   * end (the same, or a ramp). None when the colours came from nodes.
   */
  int GetNumberOfBins() const;
  bool GetBin(int index, double range[2], double lower[3], double upper[3]) const;
  ///@}

  ///@{
  /**
   * How a colour bar writes the values: factor × value + offset in a unit of its own, with so much
   * from one label to the next (0: any) and so many decimals (-1: as many as it takes). Tables of
   * GRLevelX set it, as knots for data in m/s; by default the unit is empty, that of the data.
   */
  const char* GetLabelUnit() const;
  double GetLabelFactor() const;
  double GetLabelOffset() const;
  double GetLabelStep() const;
  int GetLabelDecimals() const;
  ///@}

  /**
   * The colour of range-folded values; false when the map has none.
   */
  bool GetRangeFoldedColor(double color[3]) const;

  /**
   * The colours in steps, as a colour bar shows them; as FillColorFunction without bins.
   */
  void FillSteppedColorFunction(vtkColorTransferFunction* function);

  ///@{
  /**
   * Presets: "all echo" (a veil that thickens into cores), "storm cores" (from 40 dBZ), "hail"
   * (from 50 dBZ), "clear air" (−20 to 20 dBZ, in colours of its own below 5 dBZ), "iso-values"
   * (surfaces at 20, 35 and 50 dBZ), "colour-blind safe" (the opacity of "all echo"; each step
   * lighter than the one before, also to eyes that do not tell red from green) are for
   * reflectivity. One each is for the other moments: "velocity" (m/s, green towards the radar, red
   * away from it; the fast is opaque), "spectrum width" (m/s), "differential reflectivity" (dB),
   * "differential phase" (degrees), "correlation coefficient" (0.2 to 1.05; the low is opaque),
   * "clutter power" (dB), "storm-relative velocity" (m/s), "azimuthal shear" and "radial
   * divergence" (1/s), "specific differential phase" (degrees/km). A preset sets colours and
   * opacity. Returns false, with an error that lists the names, when there is no such preset.
   */
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index); ///< nullptr for no such index
  /// Name of the array that a preset is for, as "REF" or "VEL"; nullptr for no such index.
  static const char* GetPresetArray(int index);
  /// Name of the number-th preset, from 0 on, for an array; nullptr when there is none.
  static const char* FindPreset(const char* array, int number = 0);
  bool ApplyPreset(const char* name);
  ///@}

  ///@{
  /**
   * Makes the opacity a thin shell about each of the values: `opacity`, or the one of `opacities`
   * with the same index, there; 0 from `halfWidth` dBZ away. Values in any order, farther apart
   * than twice the half width (nearer ones are one shell); the colours stay.
   */
  void SetOpacityToIsoValues(
    const double* values, int count, double opacity = 0.8, double halfWidth = 2.0);
  void SetOpacityToIsoValues(
    const double* values, const double* opacities, int count, double halfWidth = 2.0);
  ///@}

  ///@{
  /**
   * Reads or writes a colour map by the ending of its name: .json (ParaView's; nodes, bins and
   * iso-values come back as they were), .pal (GRLevelX tables, colours in bytes: the bins without
   * opacity, or samples of the splines with it), .csv (read only: lines "dbz,#rrggbb" below a
   * heading). A file without opacities leaves the opacity as it is, but of a table nothing shows
   * below its first step. Each line of a .pal table that cannot be read is passed over, with a
   * warning of one line that names the file and the line. Returns false, with an error of one line
   * that names the file and what is wrong; then nothing changed.
   */
  bool ReadFile(const char* path);
  bool WriteFile(const char* path);
  ///@}

  ///@{
  /**
   * The text that WriteFile puts into a .json file: a list of one colour map. ParseJSON takes it
   * over as ReadFile does; false, with an error, for a text that is none.
   */
  std::string FormatJSON();
  bool ParseJSON(const std::string& text);
  ///@}

protected:
  vtkNexradTransferFunction();
  ~vtkNexradTransferFunction() override;

private:
  vtkNexradTransferFunction(const vtkNexradTransferFunction&) = delete;
  void operator=(const vtkNexradTransferFunction&) = delete;

  void TakeOver(vtkNexradColorMap map);
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
