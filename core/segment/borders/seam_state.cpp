#include "core/segment/borders/seam_state.h"

namespace chartflood {

void measureSeamCharts(SeamState& state, std::size_t charts) {
  const SeamLevel& level = *state.level;
  state.charts.resize(charts);
  for (SeamChart& chart : state.charts) {
    chart.value = chart.area = 0;
    chart.euler = 0;
    chart.nodes.clear();
  }
  for (Index i = 0; i < level.nodeCount(); ++i) {
    SeamChart& chart = state.charts[state.label[i]];
    chart.nodes.push_back(i);
    chart.value += level.value[i];
    chart.area += level.area[i];
    chart.euler += level.euler[i];
    for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
      if (level.arcHead[arc] < i || state.label[level.arcHead[arc]] != state.label[i]) continue;
      chart.value += level.arcValue[arc];
      chart.euler += level.arcEuler[arc];
    }
  }
  for (Index c = 0; c < level.cornerCount(); ++c) {
    const Index first = state.label[level.cornerNode[level.cornerNodeBegin[c]]];
    bool one = true;
    for (Index k = level.cornerNodeBegin[c]; k < level.cornerNodeBegin[c + 1] && one; ++k) {
      one = state.label[level.cornerNode[k]] == first;
    }
    if (!one) continue;
    state.charts[first].value += level.cornerValue[c];
    ++state.charts[first].euler;
  }
}

}  // namespace chartflood
