// An OpenGL context without any window system.
#pragma once

#include <string>

namespace lodestone {

/// OpenGL 3.2 core on Mesa's surfaceless EGL platform. Works with no display at all; the picture is read
/// back.
class EglContext {
 public:
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  [[nodiscard]] bool isValid() const { return context_ != nullptr; }
  [[nodiscard]] const std::string& problem() const { return problem_; }
  void makeCurrent();
  void doneCurrent();
  [[nodiscard]] bool isCurrent() const;

 private:
  void open();

  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
  std::string problem_;
};

}  // namespace lodestone
