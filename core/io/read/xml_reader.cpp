#include "core/io/read/xml_reader.h"

#include <new>

#include <expat.h>

namespace chartflood {

namespace {

constexpr char kSeparator = '\n';  // cannot be part of an address
/// The library looks at an unfinished tag again from its start with every piece.
constexpr std::size_t kLongestTag = 4 << 20;

XmlName splitName(const char* text) {
  const std::string_view whole(text);
  const std::size_t at = whole.rfind(kSeparator);
  if (at == std::string_view::npos) return {"", whole};
  return {whole.substr(0, at), whole.substr(at + 1)};
}

}  // namespace

const char* XmlAttributes::find(std::string_view local, std::string_view space) const {
  for (const char** p = pairs_; *p != nullptr; p += 2) {
    const XmlName name = splitName(p[0]);
    if (name.local != local || name.space.empty() != space.empty()) continue;
    if (name.space.find(space) != std::string_view::npos) return p[1];
  }
  return nullptr;
}

/// What the library calls; `user` is the reader.
struct XmlCallbacks {
  template <class Call>
  static void guarded(void* user, Call call) {
    XmlReader& reader = *static_cast<XmlReader*>(user);
    if (reader.thrown_ || !reader.problem_.empty()) return;
    try {
      call(reader);
    } catch (...) {
      reader.thrown_ = std::current_exception();
      XML_StopParser(reader.parser_, XML_FALSE);
    }
  }
  static void begin(void* user, const char* name, const char** attributes) {
    guarded(user, [&](XmlReader& reader) {
      reader.handler_.begin(splitName(name), XmlAttributes(attributes));
    });
  }
  static void end(void* user, const char* name) {
    guarded(user, [&](XmlReader& reader) { reader.handler_.end(splitName(name)); });
  }
  static void declare(void* user, const char* prefix, const char* space) {
    guarded(user, [&](XmlReader& reader) {
      reader.namespaces_[prefix == nullptr ? "" : prefix] = space == nullptr ? "" : space;
    });
  }
  static void documentType(void* user, const char*, const char*, const char*, int) {
    guarded(user, [&](XmlReader& reader) {
      reader.stop("declares a document type, which such files may not have");
    });
  }
};

XmlReader::XmlReader(Handler& handler)
    : handler_(handler), parser_(XML_ParserCreateNS(nullptr, kSeparator)) {
  if (parser_ == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser_, this);
  XML_SetElementHandler(parser_, XmlCallbacks::begin, XmlCallbacks::end);
  XML_SetStartNamespaceDeclHandler(parser_, XmlCallbacks::declare);
  XML_SetStartDoctypeDeclHandler(parser_, XmlCallbacks::documentType);
}

XmlReader::~XmlReader() { XML_ParserFree(parser_); }

void XmlReader::stop(const char* problem) {
  problem_ = problem;
  XML_StopParser(parser_, XML_FALSE);
}

std::string XmlReader::feed(std::string_view piece, bool last) {
  const XML_Status status =
      XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), last ? 1 : 0);
  if (thrown_) std::rethrow_exception(thrown_);
  if (!problem_.empty()) return problem_;
  if (status != XML_STATUS_OK) {
    const XML_Error error = XML_GetErrorCode(parser_);
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    return std::string("is no valid XML (") + XML_ErrorString(error) + ")";
  }
  fed_ += piece.size();
  const XML_Index told = XML_GetCurrentByteIndex(parser_);
  if (told >= 0 && fed_ - static_cast<std::size_t>(told) > kLongestTag) {
    return "has a tag of more than 4 megabytes";
  }
  return "";
}

std::size_t XmlReader::line() const {
  return static_cast<std::size_t>(XML_GetCurrentLineNumber(parser_));
}

std::string XmlReader::namespaceOf(std::string_view prefix) const {
  const auto found = namespaces_.find(prefix);
  return found == namespaces_.end() ? "" : found->second;
}

}  // namespace chartflood
