#pragma once
/// The numbers of one run as plain values: what the report file holds. Gauss areas in steradians,
/// lengths and areas in model units.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/index.h"
#include "core/model/comparison.h"
#include "core/model/input_mesh.h"
#include "core/model/unwrap.h"

namespace chartflood {

/// What the input file holds.
struct InputReport {
  std::string file;
  std::size_t faces = 0;     ///< as the file lists them, dropped ones included
  std::size_t vertices = 0;  ///< as the file lists them, unused ones included, copies left out
  std::size_t triangles = 0, components = 0, boundaryLoops = 0;
  long genus = 0;
  std::vector<Repair> repairs;
};

/// Gauss area of the mesh and its distribution over the charts.
struct GaussReport {
  double total = 0, vertices = 0, edges = 0, faces = 0;
  std::optional<double> mean, stdEq3, std;  ///< absent without charts
  /// Absent without charts, and when the mean is too small for ratios.
  std::optional<double> stdOverMean, maxOverMean;
};

struct IterationReport {
  std::size_t iteration = 0;
  std::optional<double> stdOverMean;  ///< absent when the mean is too small for ratios
  std::size_t movedSeeds = 0;
};

/// One of several runs that were tried.
struct RunReport {
  int rngSeed = 0;
  std::size_t charts = 0;
  std::optional<double> stdOverMean;
  double seamLengthOverSqrtArea = 0;
  std::optional<double> l2AreaWeighted, l2Max;  ///< absent where its charts were not laid flat
  bool chosen = false;
};

/// A chart that stretches more than it was to.
struct AboveLimit {
  std::size_t chart = 0;
  double l2 = 1, limit = 1;
};

struct ChartReport {
  std::size_t chart = 0;
  std::optional<Index> seedFace;  ///< number of the face in the input file
  std::size_t faces = 0;
  double area = 0, gaussArea = 0, perimeter = 0;
  long euler = 0;                        ///< after cutting, where charts were cut
  std::size_t boundaryLoops = 0;         ///< the same
  bool disk = false;                     ///< the same
  std::optional<double> cutLength;       ///< absent before cutting
  std::optional<Distortion> distortion;  ///< absent when the chart is not laid flat
};

/// One figure over all charts that are laid flat, each chart counting the same.
struct Spread {
  double mean = 0, std = 0, median = 0, max = 0;
};

/// How much the charts are distorted in the plane.
struct StretchReport {
  Spread l2;
  double l2AreaWeighted = 0;  ///< root of the area-weighted mean of squares
  double linfMax = 0;
  Spread area, angle;
  std::size_t flippedTriangles = 0;
};

/// Milliseconds of each stage; absent when it did not run.
struct TimingReport {
  std::optional<double> read, gaussArea, floodGraph, segment, cut, unwrap, pack;
};

/// One method's result.
struct ResultReport {
  std::string method;
  std::optional<std::string> search;  ///< "literal" or "fast", of t-flooding
  std::size_t charts = 0;
  std::size_t iterations = 0;
  std::optional<std::size_t> bestIteration;  ///< absent before the first round is done
  std::string stopReason;
  GaussReport gaussArea;
  /// Edges between two charts and edges of cuts, each once; absent without charts.
  std::optional<double> seamLength;
  std::optional<double> seamLengthOverSqrtArea;
  std::optional<double> cutLength;          ///< the part of cuts; absent before cutting
  std::optional<double> creaseShare;        ///< of the length of sharp edges, on borders of charts
  std::optional<StretchReport> stretch;     ///< absent when no chart is laid flat
  std::optional<double> texelDensity;       ///< pixels per unit of the model
  std::optional<double> packingEfficiency;  ///< share of the texture that charts cover
  std::vector<AboveLimit> aboveLimit;       ///< ascending by chart
  std::vector<IterationReport> history;
  std::vector<RunReport> seedRuns;   ///< generator seeds that were tried
  std::vector<RunReport> chartRuns;  ///< numbers of charts that were tried
  std::vector<ChartReport> perChart;
  TimingReport timing;
};

struct Report {
  std::string version;
  InputReport input;
  /// Option ids with their values, in the order of the parameter table.
  std::vector<std::pair<std::string, std::variant<bool, int, double, std::string>>> parameters;
  std::vector<Index> seeds;  ///< placed by hand, faces of the input file; empty: by the method
  std::vector<ResultReport> results;
  std::vector<ComparisonRow> comparison;  ///< of several methods; empty: there was one
  std::size_t peakMemoryBytes = 0;
};

}  // namespace chartflood
