#include "model/io/citygml/citygml_xml.h"

#include <algorithm>
#include <array>
#include <exception>
#include <memory>

#include <expat.h>
#include <iconv.h>

#include "model/io/citygml/citygml_names.h"

namespace lodestone::citygml {
namespace {

constexpr int kBufferSize = 1 << 18;
constexpr int kDeepest = 256;

}  // namespace

/// One run of Expat over one document.
class XmlSession {
 public:
  explicit XmlSession(XmlHandler& handler)
      : handler_(handler), parser_(XML_ParserCreateNS(nullptr, kSeparator), &XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_Parser p = parser_.get();
    XML_SetUserData(p, this);
    XML_SetElementHandler(p, &start, &end);
    XML_SetCharacterDataHandler(p, &text);
    XML_SetStartDoctypeDeclHandler(p, &doctype);
    XML_SetUnknownEncodingHandler(p, &encoding, nullptr);
    handler_.lineOf_ = [p] { return static_cast<std::size_t>(XML_GetCurrentLineNumber(p)); };
  }
  ~XmlSession() { handler_.lineOf_ = nullptr; }
  XmlSession(const XmlSession&) = delete;
  XmlSession& operator=(const XmlSession&) = delete;

  std::optional<XmlFailure> run(const ByteSource& source) {
    for (;;) {
      void* buffer = XML_GetBuffer(parser_.get(), kBufferSize);
      if (!buffer) throw std::bad_alloc();
      const std::size_t count = source(static_cast<char*>(buffer), kBufferSize);
      const bool last = count == 0;
      const XML_Status status =
          XML_ParseBuffer(parser_.get(), static_cast<int>(count), last ? XML_TRUE : XML_FALSE);
      if (thrown_) std::rethrow_exception(thrown_);
      if (status != XML_STATUS_OK) return failure(last, static_cast<const char*>(buffer), count);
      if (last) return std::nullopt;
    }
  }

 private:
  static XmlSession& self(void* user) { return *static_cast<XmlSession*>(user); }

  /// Expat is C: nothing may be thrown through it.
  template <class Call>
  void guarded(Call&& call) {
    if (thrown_ || refused_) return;
    try {
      call();
    } catch (...) {
      thrown_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }
  void refuse(Code code, std::string text) {
    refused_ = XmlFailure{code, std::move(text), XML_GetCurrentLineNumber(parser_.get())};
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  static void XMLCALL start(void* user, const XML_Char* name, const XML_Char** attributes) {
    XmlSession& session = self(user);
    if (++session.depth_ > kDeepest) return session.refuse(Code::NestingTooDeep, {});
    session.guarded([&] { session.handler_.startElement(name, attributes); });
  }
  static void XMLCALL end(void* user, const XML_Char*) {
    XmlSession& session = self(user);
    --session.depth_;
    session.guarded([&] { session.handler_.endElement(); });
  }
  static void XMLCALL text(void* user, const XML_Char* begin, int length) {
    XmlSession& session = self(user);
    if (!session.handler_.collecting_) return;
    session.guarded([&] { session.handler_.text_.append(begin, static_cast<std::size_t>(length)); });
  }
  static void XMLCALL doctype(void* user, const XML_Char* name, const XML_Char*, const XML_Char*, int) {
    self(user).refuse(Code::EntityRefused, "DOCTYPE " + std::string(name));
  }

  /// Expat asks for encodings that it does not know: one-byte ones are answered from iconv.
  static int XMLCALL encoding(void*, const XML_Char* name, XML_Encoding* info) {
    const iconv_t converter = iconv_open("UTF-32LE", name);
    if (converter == reinterpret_cast<iconv_t>(-1)) return XML_STATUS_ERROR;
    for (int byte = 0; byte < 256; ++byte) {
      char in = static_cast<char>(byte);
      std::array<unsigned char, 8> out{};
      char* from = &in;
      char* to = reinterpret_cast<char*>(out.data());
      std::size_t inLeft = 1;
      std::size_t outLeft = out.size();
      const bool known =
          iconv(converter, &from, &inLeft, &to, &outLeft) != static_cast<std::size_t>(-1) && outLeft == 4;
      info->map[byte] = known ? out[0] | out[1] << 8 | out[2] << 16 : -1;
      if (!known) iconv(converter, nullptr, nullptr, nullptr, nullptr);
    }
    iconv_close(converter);
    info->data = nullptr;
    info->convert = nullptr;
    info->release = nullptr;
    return XML_STATUS_OK;
  }

  XmlFailure failure(bool atEnd, const char* buffer, std::size_t count) const {
    if (refused_) return *refused_;
    XML_Parser p = parser_.get();
    const XML_Error error = XML_GetErrorCode(p);
    XmlFailure result{Code::FileMalformed, XML_ErrorString(error), XML_GetCurrentLineNumber(p)};
    switch (error) {
      case XML_ERROR_NO_ELEMENTS:
      case XML_ERROR_UNCLOSED_TOKEN:
      case XML_ERROR_PARTIAL_CHAR:
      case XML_ERROR_UNCLOSED_CDATA_SECTION:
        if (atEnd) result.code = Code::FileTruncated;
        break;
      case XML_ERROR_UNKNOWN_ENCODING:
      case XML_ERROR_INCORRECT_ENCODING:
        result.code = Code::EncodingBad;
        break;
      case XML_ERROR_INVALID_TOKEN:
        if (isHighByte(buffer, count)) result.code = Code::EncodingBad;
        break;
      case XML_ERROR_UNDEFINED_ENTITY:
        result.code = Code::EntityRefused;
        break;
      default:
        break;
    }
    return result;
  }

  /// The byte at the error is not ASCII: the text is not what the declaration says.
  bool isHighByte(const char* buffer, std::size_t count) const {
    int offset = 0;
    int size = 0;
    const char* context = XML_GetInputContext(parser_.get(), &offset, &size);
    if (context && offset >= 0 && offset < size) return static_cast<unsigned char>(context[offset]) >= 0x80;
    return std::any_of(buffer, buffer + count, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  }

  XmlHandler& handler_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::exception_ptr thrown_;
  std::optional<XmlFailure> refused_;
  int depth_ = 0;
};

std::optional<XmlFailure> parseXml(const ByteSource& source, XmlHandler& handler) {
  XmlSession session(handler);
  return session.run(source);
}

}  // namespace lodestone::citygml
