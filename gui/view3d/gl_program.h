// One shader program, compiled when first used and forgotten with its context.
#pragma once

#include <string>

namespace lodestone {

class GlProgram {
 public:
  GlProgram(std::string name, const char* vertexSource, const char* fragmentSource)
      : name_(std::move(name)), vertexSource_(vertexSource), fragmentSource_(fragmentSource) {}

  /// Makes it current. \throw std::runtime_error with the compiler's log when it does not compile.
  void use();
  /// Forgets the program; the context it was made in must be current.
  void release();

  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, float x, float y) const;
  /// Three floats, from any vector type with [] (Vec3, std::array).
  template <class Vector>
  void set3(const char* uniform, const Vector& v) const {
    set3f(uniform, static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
  }
  void setMatrix(const char* uniform, const float* columnMajor) const;

 private:
  void set3f(const char* uniform, float x, float y, float z) const;
  [[nodiscard]] unsigned compile(unsigned kind, const char* source) const;

  std::string name_;
  const char* vertexSource_;
  const char* fragmentSource_;
  unsigned id_ = 0;
};

}  // namespace lodestone
