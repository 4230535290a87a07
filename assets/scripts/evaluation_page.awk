# Writes the page of evaluate.sh from its table of values; see there for the columns.
BEGIN { FS = "\t" }
{
  mesh = $1
  if (!(mesh in triangles)) order[++meshes] = mesh
  triangles[mesh] = $2
  add("gauss", $8); add("mean", $10); add("deviation", $11); add("median", $12)
  add("free", $14); add("seams", $15); add("seconds", $17)
}

function k(mesh, set, borders, method) { return mesh SUBSEP set SUBSEP borders SUBSEP method }
function ratio(a, b) { return b > 0 ? sprintf("%.2g", a / b) : "-" }
function short(x) { return x >= 99.5 ? sprintf("%.0f", x) : sprintf("%.3g", x) }

# Every generator seed adds one figure of a kind; value gives their median.
function add(kind, figure) {
  figures[kind, $1, $3, $5, $6] = figures[kind, $1, $3, $5, $6] " " figure
}
function value(kind, key,    list, n, i, j, x) {
  n = split(figures[kind, key], list, " ")
  for (i = 2; i <= n; ++i) {
    x = list[i]
    for (j = i - 1; j >= 1 && list[j] + 0 > x + 0; --j) list[j + 1] = list[j]
    list[j + 1] = x
  }
  return list[int((n + 1) / 2)] + 0
}

# What stands in a cell; the number whose ratios are printed is value of the same kind.
function cell(kind, key) {
  if (kind == "mean") return short(value(kind, key)) " (" short(value("deviation", key)) ")"
  if (kind == "median")
    return short(value(kind, key)) " (" short(value("mean", key)) "), " short(value("seams", key))
  return short(value(kind, key))
}

function head() {
  print "| Mesh (triangles) | MCGIM | VSA | t-flooding | t-flooding / VSA | / MCGIM |"
  print "|---|---|---|---|---|---|"
}
function rowsOf(set, borders, kind,    i, m, a, b, c) {
  for (i = 1; i <= meshes; ++i) {
    m = order[i]
    a = k(m, set, borders, "mcgim"); b = k(m, set, borders, "vsa"); c = k(m, set, borders, "t-flooding")
    printf "| %s (%s) | %s | %s | %s | %s | %s |\n", m, triangles[m], cell(kind, a), cell(kind, b),
      cell(kind, c), ratio(value(kind, c), value(kind, b)), ratio(value(kind, c), value(kind, a))
  }
}
function printed(model, a, b, c, overB, overA) {
  printf "| *%s, as printed* | %s | %s | %s | %s | %s |\n", model, a, b, c, overB, overA
}
function printedGauss() {
  printed("Happy (19976)", "64.3", "69.0", "25.6", "0.37", "0.40")
  printed("Rocket (80354)", "11.0", "17.3", "4.55", "0.26", "0.41")
  printed("Santa (151558)", "14.3", "18.9", "2.48", "0.13", "0.17")
}
function printedStretch() {
  printed("Happy (19976)", "8.1 (7.8)", "12.4 (12.6)", "7.3 (4.7)", "0.59", "0.90")
  printed("Rocket (80354)", "29.1 (39.3)", "28.2 (21.5)", "17.9 (7.3)", "0.63", "0.62")
  printed("Santa (151558)", "22.9 (11.6)", "60.1 (47.1)", "17.2 (8.6)", "0.29", "0.75")
}
function part(title, text) { print "\n## " title "\n\n" text "\n" }
function table(title, set, borders, kind) {
  print "\n**" title "**\n"
  head()
  rowsOf(set, borders, kind)
  print ""
}

END {
  print "# Evaluation beside the paper's\n"
  print "Made by `assets/scripts/evaluate.sh PROGRAM MESH-FOLDER OUTPUT-FOLDER`; 20 charts. Every method runs with"
  print "the generator seeds 1, 2 and 3: each figure is the median of these three runs, ratios are those of the"
  print "medians, pictures are of seed 1. What the figures say is judged in [findings.md](findings.md)."
  part("What can be compared", \
    "The paper's Rocket and Santa are not public, and public copies of the Happy Buddha are other\n" \
    "decimations: absolute values are those of other shapes. What can be set beside the paper are ratios\n" \
    "between the methods on one mesh. The paper does not say whether its L2 stretch is free of scale; here it\n" \
    "is (1: no distortion), which changes each chart's value but favours no method. Rivals are this program's\n" \
    "own: VSA with teleportation, and the chart growth of MCGIM without its later steps. All methods get the\n" \
    "same cuts into disks and the same unwrap. Gauss areas are in steradians, seams in square roots of the\n" \
    "surface, borders and cuts together. Means count every chart the same, as in table 1; one collapsed\n" \
    "chart is enough to make a mean useless, so medians stand beside them.")
  part("The paper's parameters", \
    "`--preset=paper` (`paper-happy`, with p = 3, for the Happy Buddha): charts on circles, borders as flooded,\n" \
    "no cuts beyond the paper's.")
  print "**Table 2: standard deviation (equation 3) of Gauss area**\n"
  head(); rowsOf("paper", "left", "gauss"); printedGauss()
  print "\n**Table 1: L2 stretch on circles, mean over charts (standard deviation)**\n"
  head(); rowsOf("paper", "left", "mean"); printedStretch()
  table("Median of L2 stretch on circles (mean), seams", "paper", "left", "median")
  table("Seconds for the charts", "paper", "left", "seconds")
  part("This program's parameters, charts as each method leaves them", \
    "T-flooding with its seam cuts, which are part of the method here; the rivals' borders as grown.")
  print "**Standard deviation (equation 3) of Gauss area**\n"
  head(); rowsOf("ours", "left", "gauss"); printedGauss()
  print "\n**L2 stretch on circles, mean over charts (standard deviation)**\n"
  head(); rowsOf("ours", "left", "mean"); printedStretch()
  table("L2 stretch with free outlines (the default unwrap), mean", "ours", "left", "free")
  table("Seams", "ours", "left", "seams")
  table("Seconds for the charts, borders included", "ours", "left", "seconds")
  part("The same borders for all", \
    "Every method's borders are finished in the same way; t-flooding keeps its balance, each rival its own\n" \
    "cost. Cells: median over charts of L2 stretch on circles (mean), seams, each\n" \
    "the median of the generator seeds 1, 2 and 3 of that method; ratios are of the first figure.")
  print "**Tidied face by face (`--refine=moves`): charts stay what their method made them**\n"
  head(); rowsOf("moves", "alike", "median")
  table("Shortest by minimum cuts (`--refine=cuts`), each method with its own aim as the price", \
        "ours", "alike", "median")
  table("Standard deviation of Gauss area after minimum cuts", "ours", "alike", "gauss")
  part("Pictures", \
    "Figure 5: Gauss area of corners, creases and triangles. Figure 6: charts and checkerboards by MCGIM, VSA\n" \
    "and t-flooding, here with this program's parameters; the output folder has those of all meshes and with\n" \
    "the paper's parameters, too.")
  for (i = 1; i <= meshes && i <= 2; ++i) {
    m = order[i]
    if (i > 1) print ""
    print "### " m "\n"
    printf "![corners](pictures/%s-gauss-vertex.png) ![creases](pictures/%s-gauss-edge.png)\n", m, m
    printf "![triangles](pictures/%s-gauss-face.png)\n\n", m
    printf "![charts and checkerboards of the methods](pictures/%s-ours.png)\n", m
  }
}
