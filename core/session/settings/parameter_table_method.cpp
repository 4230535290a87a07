// Rows of the parameter table: the methods and what is their own.

#include "core/segment/registry.h"
#include "core/session/settings/parameter_table.h"

namespace chartflood {

namespace {

std::vector<ParameterChoice> methodChoices() {
  std::vector<ParameterChoice> choices;
  for (const Segmenter& segmenter : segmenterTable()) {
    choices.push_back({segmenter.id, segmenter.title});
  }
  return choices;
}

}  // namespace

std::vector<ParameterInfo> methodRows() {
  return {
      {.id = "method",
       .label = "Method",
       .symbol = "",
       .member = &Parameters::method,
       .stage = Stage::Seeds,
       .group = "Method",
       .help = "How the charts are found.",
       .source = "3",
       .choices = methodChoices()},
      {.id = "even",
       .label = "Even out",
       .symbol = "",
       .member = &Parameters::even,
       .stage = Stage::Flood,
       .group = "Method",
       .help =
           "What all charts are to have alike. Error: what the method itself lowers, so that no "
           "chart is much worse than the others. Area: charts of equal size. Auto: Gauss area "
           "with t-flooding, nothing with the others, as in their papers.",
       .source = "5",
       .choices = {{"auto", "Auto"}, {"error", "Error"}, {"area", "Area"}, {"off", "Off"}}},
      {.id = "vsa-seeding",
       .label = "Coming to charts",
       .symbol = "",
       .member = &Parameters::vsaSeeding,
       .stage = Stage::Seeds,
       .group = "Method",
       .help =
           "One by one: a new chart where the planes fit worst. Doubling: one in every chart at "
           "once. Random: all at once anywhere.",
       .source = "",
       .choices = {{"one-by-one", "One by one"}, {"doubling", "Doubling"}, {"random", "Random"}},
       .method = "vsa"},
      {.id = "vsa-teleport",
       .label = "Move stuck charts",
       .symbol = "",
       .member = &Parameters::vsaTeleport,
       .stage = Stage::Iterations,
       .group = "Method",
       .help = "Joins two charts that hardly differ and spends the freed one where the planes fit "
               "worst.",
       .source = "4",
       .method = "vsa"},
      {.id = "mcgim-lambda",
       .label = "Roundness",
       .symbol = "\u03bb",
       .member = &Parameters::mcgimLambda,
       .sliderMin = 1,
       .sliderMax = 10,
       .hardMin = 0.1,
       .hardMax = 1000,
       .scale = SliderScale::Log,
       .format = "%.2f",
       .stage = Stage::Flood,
       .group = "Method",
       .help = "Low: charts keep to flat ground and end at folds. High: round charts, wherever the "
               "folds are.",
       .source = "",
       .method = "mcgim"},
      {.id = "mcgim-normals",
       .label = "Facing of a chart",
       .symbol = "",
       .member = &Parameters::mcgimNormals,
       .stage = Stage::Flood,
       .group = "Method",
       .help = "Frozen: which way a chart faces is that of the round before. Running: it follows "
               "the chart as it grows.",
       .source = "",
       .choices = {{"frozen", "Frozen"}, {"running", "Running"}},
       .method = "mcgim"},
      {.id = "mcgim-disks",
       .label = "Grow as disks",
       .symbol = "",
       .member = &Parameters::mcgimDisks,
       .stage = Stage::Flood,
       .group = "Method",
       .help =
           "Charts refuse what would make them rings or give them holes, while there is anything "
           "else to take.",
       .source = "",
       .method = "mcgim"},
      {.id = "search",
       .label = "Search",
       .symbol = "",
       .member = &Parameters::search,
       .stage = Stage::Seeds,
       .group = "Method",
       .help = "Literal: the paper's rounds on the whole mesh. Fast: rounds on a coarse view of "
               "it, then "
               "a few around the seams, for big meshes. Auto: fast above 300,000 faces.",
       .source = "3.4",
       .choices = {{"auto", "Auto"}, {"literal", "Literal"}, {"fast", "Fast"}},
       .method = "t-flooding"},
      {.id = "start",
       .label = "Start",
       .symbol = "",
       .member = &Parameters::start,
       .stage = Stage::Seeds,
       .group = "Method",
       .help =
           "Flood: seeds far apart, as in the paper. Creases: the parts between sharp edges, for "
           "machine parts. Auto: creases where these divide the model or ring a turned body, and "
           "planes where it is made of few.",
       .source = "3.4",
       .choices = {{"auto", "Auto"}, {"flood", "Flood"}, {"creases", "Creases"}},
       .method = "t-flooding"},
      {.id = "seeding",
       .label = "First seeds",
       .symbol = "",
       .member = &Parameters::seeding,
       .stage = Stage::Seeds,
       .group = "Method",
       .help = "Spread: all at once, far apart. One by one: a flood before each new seed, and all "
               "move after it, as the paper prints it; these rounds come before those that count.",
       .source = "3.4",
       .choices = {{"spread", "Spread"}, {"one-by-one", "One by one"}},
       .method = "t-flooding"},
  };
}

}  // namespace chartflood
