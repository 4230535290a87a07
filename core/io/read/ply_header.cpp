#include "core/io/read/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

using Words = std::vector<std::string_view>;

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames = {{
    {"char", PlyType::Int8},
    {"int8", PlyType::Int8},
    {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},
    {"short", PlyType::Int16},
    {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},
    {"uint16", PlyType::UInt16},
    {"int", PlyType::Int32},
    {"int32", PlyType::Int32},
    {"uint", PlyType::UInt32},
    {"uint32", PlyType::UInt32},
    {"float", PlyType::Float32},
    {"float32", PlyType::Float32},
    {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
}};

/// Reads the header's lines. They end in LF, CR LF or CR; the first line shows in which, because
/// binary data behind the last line may begin with a byte that looks like part of a line end.
class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source), p_(source.text()) {
    const std::size_t end = source.bytes.find_first_of("\r\n");
    if (end == std::string_view::npos) return;
    lineEnd_ = source.bytes[end] == '\n' ? "\n" : "\r";
    if (source.bytes.substr(end, 2) == "\r\n") lineEnd_ = "\r\n";
  }

  PlyHeader read();

 private:
  Words nextLine();
  void readFormat(const Words& words);
  void readElement(const Words& words);
  void readProperty(const Words& words);
  PlyType type(std::string_view name) const;

  const Source& source_;
  const char* p_;
  const char* line_ = nullptr;  ///< begin of the present line
  std::string_view lineEnd_ = "\n";
  PlyHeader header_;
};

Words HeaderReader::nextLine() {
  const std::string_view rest(p_, static_cast<std::size_t>(source_.end() - p_));
  const std::size_t end = rest.find(lineEnd_);
  if (end == std::string_view::npos) source_.fail("its header has no end_header line");
  line_ = p_;
  p_ += end + lineEnd_.size();
  Words words;
  const std::string_view line = rest.substr(0, end);
  constexpr std::string_view kBlanks = " \t\r";
  for (std::size_t begin = line.find_first_not_of(kBlanks); begin < line.size();) {
    const std::size_t stop = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, stop - begin));
    begin = line.find_first_not_of(kBlanks, stop);
  }
  return words;
}

PlyHeader HeaderReader::read() {
  if (const Words first = nextLine(); first.size() != 1 || first[0] != "ply") {
    source_.fail("it is not a PLY mesh: it does not begin with ply");
  }
  bool formatSeen = false;
  for (;;) {
    const Words words = nextLine();
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format") {
      readFormat(words);
      formatSeen = true;
    } else if (words[0] == "element") {
      readElement(words);
    } else if (words[0] == "property") {
      readProperty(words);
    } else {
      source_.failAtLine(line_, "of the header begins with " +
                                    quotedWord(words[0].data(), words[0].data() + words[0].size()) +
                                    ", which PLY does not know");
    }
  }
  if (!formatSeen) source_.fail("its header has no format line");
  header_.data = p_;
  return std::move(header_);
}

void HeaderReader::readFormat(const Words& words) {
  using Encoding = PlyHeader::Encoding;
  if (words.size() >= 2 && words[1] == "ascii") {
    header_.encoding = Encoding::Ascii;
  } else if (words.size() >= 2 && words[1] == "binary_little_endian") {
    header_.encoding = Encoding::LittleEndian;
  } else if (words.size() >= 2 && words[1] == "binary_big_endian") {
    header_.encoding = Encoding::BigEndian;
  } else {
    source_.failAtLine(line_, "names a format other than ascii, binary_little_endian and "
                              "binary_big_endian");
  }
}

void HeaderReader::readElement(const Words& words) {
  if (words.size() < 3) source_.failAtLine(line_, "gives no name and count for an element");
  const IntegerResult count = parseInteger(words[2].data(), words[2].data() + words[2].size());
  if (count.status != NumberStatus::Ok || count.end != words[2].data() + words[2].size() ||
      count.value < 0) {
    source_.failAtLine(line_, "gives no usable count for an element");
  }
  header_.elements.push_back({std::string(words[1]), static_cast<std::size_t>(count.value), {}});
}

void HeaderReader::readProperty(const Words& words) {
  if (header_.elements.empty()) source_.failAtLine(line_, "has a property before any element");
  PlyProperty property;
  if (words.size() >= 5 && words[1] == "list") {
    property.list = true;
    property.countType = type(words[2]);
    property.type = type(words[3]);
    property.name = words[4];
    if (!plyIsWhole(property.countType)) {
      source_.failAtLine(line_, "counts a list in numbers with fractions");
    }
  } else if (words.size() >= 3 && words[1] != "list") {
    property.type = type(words[1]);
    property.name = words[2];
  } else {
    source_.failAtLine(line_, "describes a property without type and name");
  }
  header_.elements.back().properties.push_back(std::move(property));
}

PlyType HeaderReader::type(std::string_view name) const {
  for (const auto& [text, type] : kTypeNames) {
    if (name == text) return type;
  }
  source_.failAtLine(line_,
                     "has the unknown type " + quotedWord(name.data(), name.data() + name.size()));
}

}  // namespace

std::size_t plySize(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  return static_cast<std::size_t>(found - properties.begin());
}

bool PlyElement::hasList() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list; });
}

std::size_t PlyElement::smallestRow() const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += plySize(p.list ? p.countType : p.type);
  return size;
}

PlyHeader readPlyHeader(const Source& source) { return HeaderReader(source).read(); }

}  // namespace chartflood
