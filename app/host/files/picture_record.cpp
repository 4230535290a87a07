#include "app/host/files/picture_record.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <system_error>

#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr const char* kSessionKey = "chartflood session";
constexpr const char* kRecordKey = "chartflood picture";
constexpr int kLargestSide = 16384;

template <class Number>
std::string plain(Number value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

template <class Number>
bool readPlain(std::string_view text, Number least, Number most, Number& value) {
  Number read{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  const bool fits =
      error == std::errc() && end == text.data() + text.size() && read >= least && read <= most;
  if (fits) value = read;
  return fits;
}

/// Takes one line in; false when its value cannot be.
bool take(std::string_view key, std::string_view value, PictureRecord& record) {
  if (key == "model") {
    // A name alone: a picture from elsewhere must not point anywhere.
    record.model = std::filesystem::path(value).filename().string();
    return true;
  }
  if (key == "view") {
    record.view = value;
    return value == "3d" || value == "uv" || value == "both";
  }
  if (key == "width") return readPlain(value, 1, kLargestSide, record.width);
  if (key == "height") return readPlain(value, 1, kLargestSide, record.height);
  if (key == "smooth") {
    return readPlain(value, 1, 4, record.smooth) && record.smooth != 3;
  }
  if (key == "line-scale") return readPlain(value, 0.01, 100.0, record.lineScale);
  if (key == "playhead") {
    return readPlain(value, std::size_t{0}, std::size_t{1} << 40, record.playhead.emplace());
  }
  return true;
}

struct Texts {
  std::string session;
  PictureRecord record;
};

Texts readTexts(const std::filesystem::path& file) {
  const ImageTexts texts = readPngTexts(file);
  Texts found;
  bool recorded = false;
  for (const auto& [key, value] : texts) {
    if (key == kSessionKey) found.session = value;
    if (key != kRecordKey) continue;
    found.record = readRecord(value, file.string());
    recorded = true;
  }
  if (found.session.empty() || !recorded) {
    throw ReadError(file.string(), "it does not say how it was made: only pictures that the window "
                                   "of chartflood saved do");
  }
  return found;
}

}  // namespace

std::string recordText(const PictureRecord& record) {
  std::string text;
  if (!record.model.empty()) text += "model=" + record.model + '\n';
  text += "view=" + record.view + '\n';
  text += "width=" + plain(record.width) + '\n';
  text += "height=" + plain(record.height) + '\n';
  text += "smooth=" + plain(record.smooth) + '\n';
  text += "line-scale=" + plain(record.lineScale) + '\n';
  if (record.playhead) text += "playhead=" + plain(*record.playhead) + '\n';
  return text;
}

PictureRecord readRecord(const std::string& text, const std::string& file) {
  PictureRecord record;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t middle = line.find('=');
    const std::string_view all(line);
    if (middle == std::string::npos ||
        !take(all.substr(0, middle), all.substr(middle + 1), record)) {
      throw ReadError(file, "'" + line + "' in it is nothing a picture can be like");
    }
  }
  return record;
}

ImageTexts pictureTexts(const std::string& session, const PictureRecord& record,
                        const std::string& commandLine) {
  return {{"Software", "chartflood " CHARTFLOOD_VERSION},
          {"Description", commandLine},
          {kRecordKey, recordText(record)},
          {kSessionKey, session}};
}

bool isPngFile(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return ending == ".png";
}

bool holdsSession(const std::filesystem::path& file) {
  if (!isPngFile(file)) return false;
  try {
    readTexts(file);
    return true;
  } catch (const ReadError&) {
    return false;
  }
}

PictureSource readPictureSource(const std::filesystem::path& file,
                                const std::filesystem::path& model) {
  const Texts texts = readTexts(file);
  std::filesystem::path wanted = model;
  if (wanted.empty() && !texts.record.model.empty()) {
    wanted = file.parent_path() / texts.record.model;
    std::error_code error;
    if (!std::filesystem::exists(wanted, error)) {
      throw ReadError(file.string(), "its model " + texts.record.model +
                                         " does not lie beside it; put it there, or name both");
    }
  }
  return {readSessionText(texts.session, file.string(), wanted), texts.record};
}

std::string modelOfPicture(const std::filesystem::path& file) {
  return readTexts(file).record.model;
}

}  // namespace chartflood
