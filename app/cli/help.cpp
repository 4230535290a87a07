#include "app/cli/help.h"

#include <algorithm>
#include <string_view>

#include "app/cli/option_table.h"
#include "core/io/mesh_formats.h"

namespace chartflood {

namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kIndent = 30;  // of the explanations

constexpr const char* kUsage = R"(Usage: chartflood [options] [mesh or session]

Cuts a surface mesh into charts that flatten well, by flooding it along its Gaussian curvature
(Yamauchi, Gumhold, Zayer, Seidel: Mesh segmentation driven by Gaussian curvature, 2005).
Without an option that asks for a result it opens a window. Options are written --name=value or
--name value, switches --name or --name=off. After -- every word is a file name.
)";

constexpr const char* kExamples = R"(
Examples
  chartflood bunny.obj
      Opens the window; Space starts the flood.
  chartflood bunny.obj --output=bunny.png --export-labels=bunny.txt
      Twenty charts, as a picture and as one number per face.
  chartflood bunny.obj --charts=8 --speed-power=3 --report=- --verbose=info
      Eight charts whose borders cling to creases; all figures on standard output.
  chartflood --sample=rocket --steps=4000 --color-by=flood-order --output=flood.png
      The flood on its way, coloured by the order in which faces were taken.
  chartflood statue.ply --preset=paper --seeds=0,250,731 --charts=3 --output=three.png
      The printed method from three chosen faces.
  chartflood broken.stl --info
      What the file holds and what was repaired.

Leaves with 0 when all is done, 1 when it failed (one sentence says why; no file was changed), 2 for
wrong usage and 130 when it was interrupted.
)";

/// Columns that a UTF-8 text takes on the screen; all characters used here take one.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// Appends the words of `text`, broken before kWidth, starting at column `column`; the lines that
/// follow are indented.
void appendWrapped(std::string& out, std::string_view text, std::size_t column,
                   std::size_t indent = kIndent) {
  bool first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' ', 1), text.size());
    std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    if (column + columns(word) > kWidth) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
      first = true;
    }
    if (first && word.starts_with(' ')) word.remove_prefix(1);
    first = false;
    out += word;
    column += columns(word);
  }
  out += "\n";
}

std::string optionText(const OptionInfo& option) {
  std::string text = "  --" + option.name + (option.isSwitch() ? "" : "=" + option.value);
  if (text.size() + 2 > kIndent)
    text += "\n" + std::string(kIndent, ' ');
  else
    text.resize(kIndent, ' ');
  appendWrapped(text, option.help, kIndent);
  return text;
}

/// The formats of meshes, read well apart from tried.
std::string formatText() {
  std::string text;
  appendWrapped(text,
                "Reads " + extensionList(FormatReader::Own) +
                    ". Tries, through the import library (Assimp), " +
                    extensionList(FormatReader::Library) + ".",
                0, 0);
  return text;
}

}  // namespace

std::string helpText() {
  std::string text = kUsage + formatText();
  std::string group;
  for (const OptionInfo& option : optionTable()) {
    if (option.group != group) text += "\n" + option.group + "\n";
    group = option.group;
    text += optionText(option);
  }
  return text + kExamples;
}

}  // namespace chartflood
