#include "app/cli/comparison_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace chartflood {

namespace {

template <class... Values>
std::string printed(const char* format, Values... values) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

std::string rowText(const ComparisonRow& row) {
  const std::string over =
      row.gaussStdOverMean ? printed("%.3g", *row.gaussStdOverMean) : std::string("-");
  return printed("%-11s %6zu %10.4g %8s   %8.4g %10.4g %8.4g %8.4g   %8.4g   %8.4g %6.0f%% %9.2f\n",
                 row.method.c_str(), row.charts, row.gaussStdEq3, over.c_str(), row.circleMean,
                 row.circleStd, row.circleMedian, row.circleMax, row.freeMean,
                 row.seamLengthOverSqrtArea, 100 * row.cutShare, row.segmentMilliseconds / 1000);
}

}  // namespace

std::string comparisonText(std::span<const ComparisonRow> rows) {
  std::string text;
  for (const bool alike : {true, false}) {
    const auto inTable = [&](const ComparisonRow& row) { return row.alike == alike; };
    if (std::none_of(rows.begin(), rows.end(), inTable)) continue;
    if (!text.empty()) text += '\n';
    text += alike ? "The same borders for all methods\n" : "Charts as each method leaves them\n";
    text += "                     Gauss area            L2, charts on circles                 free"
            "       seams and cuts      time\n"
            "method      charts  std eq. 3 std/mean       mean        std   median      max       "
            "mean   / sqrt A    cuts         s\n";
    for (const ComparisonRow& row : rows) {
      if (inTable(row)) text += rowText(row);
    }
  }
  return text;
}

std::vector<std::string> comparisonCaption(const ComparisonRow& row) {
  return {row.method, printed("Gauss area std %.3g sr", row.gaussStdEq3),
          printed("circle L2 %.3g (%.3g)", row.circleMean, row.circleStd),
          printed("seams %.3g", row.seamLengthOverSqrtArea)};
}

}  // namespace chartflood
