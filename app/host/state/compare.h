#pragma once
/// Results kept beside the live ones, to be looked at side by side or through a wipe. Knows no
/// window: which halves there are, how each is looked at and what stands under it.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/host/insight/insight.h"
#include "core/session/session.h"
#include "render/passes/renderer.h"
#include "render/scene/camera.h"
#include "render/scene/render_settings.h"

namespace chartflood {

/// What stands under a half.
struct CompareFigures {
  std::string method;
  std::size_t charts = 0;
  std::optional<double> spread;               ///< standard deviation over mean, Gauss areas
  std::optional<double> stretch, stretchStd;  ///< L2 over the charts, see the report
  std::optional<double> seams;                ///< seam and cut length over root of area
};
CompareFigures compareFigures(const Results& results);

/// How a half is looked at where the switches let each go its own way.
struct CompareLook {
  Camera camera;
  RenderSettings render;
};

/// A state that was kept: enough to be shown, and to be made live again with the same labels.
struct StoredResult {
  std::string name;  ///< "A"
  Document document;
  std::shared_ptr<const Results> results;  ///< never null
  CompareFigures figures;
  std::vector<SeedMark> seeds;
  CompareLook look;
  Index selectedChart = kNone;
  /// What is shown beside the results where it differs from the live ones; see paneInsight().
  mutable std::shared_ptr<Insight> insight;
  bool ofMethods = false;  ///< put here by the comparison of methods, the next may replace it
};

/// A half (or third) of the view: a stored result or the live state.
struct ComparePane {
  static constexpr std::size_t kLive = static_cast<std::size_t>(-1);
  std::size_t stored = kLive;  ///< index into Compare::stored
  bool live() const { return stored == kLive; }
  bool operator==(const ComparePane&) const = default;
};

/// Names of what is stored.
inline constexpr std::array<const char*, 3> kCompareSlots = {"A", "B", "C"};

struct Compare {
  enum class Layout { Off, SideBySide, Wipe };
  static constexpr std::size_t kMostPanes = 3;

  std::vector<StoredResult> stored;
  Layout layout = Layout::Off;
  double wipe = 0.5;  ///< share of the width left of the line, in (0, 1)
  bool linkCameras = true, linkColors = true, linkRange = true, linkChecker = true;
  CompareLook liveLook;    ///< of the live half while another is active
  ComparePane underMouse;  ///< the half that hovered faces and charts belong to
  ComparePane active;      ///< whose camera and colours the view's settings are

  /// The halves from left to right: what is stored, and the live state where fewer than two are.
  /// A wipe has two. Empty while nothing is stored or the layout is off.
  std::vector<ComparePane> panes() const;
  bool showing() const { return !panes().empty(); }
  /// Keeps a state under a name, in the place of an older one of that name.
  void store(StoredResult result);
  const StoredResult* find(const std::string& name) const;
  /// Takes in that charts stored before they were laid flat are flat now.
  void update(const std::shared_ptr<const Results>& live);
};

/// "A", or "Live".
std::string paneName(const Compare& compare, ComparePane pane);

/// The values of `mine` that differ between the two: "p 3", "Charts 20"; at most so many, and an
/// ellipsis where there are more.
std::vector<std::string> differingParameters(const Parameters& mine, const Parameters& other,
                                             std::size_t most = 4);

/// One scale for several halves: from the smallest to the largest value; nothing when none of them
/// has a scale of values.
std::optional<std::pair<double, double>>
commonRange(const std::vector<std::optional<ScalarRange>>& ranges);

}  // namespace chartflood
