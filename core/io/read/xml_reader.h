#pragma once
/// XML as a row of events, without ever holding the whole document.

#include <cstddef>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace chartflood {

/// A name with the namespace that it belongs to ("" for none).
struct XmlName {
  std::string_view space, local;
};

/// The attributes of an element, as long as its event lasts.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// The value of the attribute without namespace, or of one whose namespace has `space` in its
  /// address; null when the element has none.
  const char* find(std::string_view local, std::string_view space = "") const;

 private:
  const char** pairs_;
};

/// Takes the text piece by piece and calls the handler for elements. Document types are refused:
/// nothing is declared, expanded or fetched.
class XmlReader {
 public:
  class Handler {
   public:
    virtual ~Handler() = default;
    virtual void begin(const XmlName& name, const XmlAttributes& attributes) = 0;
    virtual void end(const XmlName& name) = 0;
  };

  explicit XmlReader(Handler& handler);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// \returns "" or what is wrong with the text. \throws what the handler throws
  std::string feed(std::string_view piece, bool last);
  /// Line of the event that is being told, counted from 1.
  std::size_t line() const;
  /// The namespace that a prefix stood for when it was last declared, "" for an unknown one.
  std::string namespaceOf(std::string_view prefix) const;

 private:
  friend struct XmlCallbacks;
  void stop(const char* problem);

  Handler& handler_;
  XML_ParserStruct* parser_;
  std::map<std::string, std::string, std::less<>> namespaces_;
  std::exception_ptr thrown_;  ///< by the handler; must not fly through the library
  std::string problem_;
  std::size_t fed_ = 0;
};

}  // namespace chartflood
