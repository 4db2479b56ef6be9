#include "model/io/meshes/obj_names.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <assimp/IOStream.hpp>

namespace lodestone {
namespace {

constexpr char kSpace = '\x1F';  // no name of a text editor's making has it, and assimp takes it as a letter

/// A stream whose "o" and "g" lines have no space after the first letter of the name.
class NamesStream : public Assimp::IOStream {
 public:
  NamesStream(Assimp::IOStream* file, Assimp::IOSystem& system) : file_(file), system_(system) {}
  ~NamesStream() override { system_.Close(file_); }

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (file_->Tell() != expected_) at_ = At::LineStart;  // after a jump: assimp's jumps begin at line starts
    const std::size_t read = file_->Read(buffer, size, count);
    expected_ = file_->Tell();
    auto* bytes = static_cast<char*>(buffer);
    std::for_each(bytes, bytes + read * size, [&](char& c) { c = next(c); });
    return read;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override { return file_->Seek(offset, origin); }
  [[nodiscard]] std::size_t Tell() const override { return file_->Tell(); }
  [[nodiscard]] std::size_t FileSize() const override { return file_->FileSize(); }
  void Flush() override { file_->Flush(); }

 private:
  enum class At { LineStart, Key, BeforeName, Name, Rest };

  char next(char c) {
    const bool space = c == ' ' || c == '\t';
    if (c == '\n' || c == '\r') {
      at_ = At::LineStart;
    } else if (at_ == At::LineStart && !space) {
      at_ = c == 'o' || c == 'g' ? At::Key : At::Rest;
    } else if (at_ == At::Key) {
      at_ = space ? At::BeforeName : At::Rest;
    } else if (at_ == At::BeforeName && !space) {
      at_ = At::Name;
    }
    return at_ == At::Name && space ? kSpace : c;
  }

  Assimp::IOStream* file_;
  Assimp::IOSystem& system_;
  At at_ = At::LineStart;
  std::size_t expected_ = 0;
};

}  // namespace

Assimp::IOStream* ObjNames::Open(const char* file, const char* mode) {
  Assimp::IOStream* stream = DefaultIOSystem::Open(file, mode);
  std::string_view name(file);
  if (!stream || name.size() < 4) return stream;
  std::string ending(name.substr(name.size() - 4));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending == ".obj" ? new NamesStream(stream, *this) : stream;
}

std::string takeNameBack(std::string name) {
  while (!name.empty() && name.back() == kSpace) name.pop_back();
  std::replace(name.begin(), name.end(), kSpace, ' ');
  return name;
}

}  // namespace lodestone
