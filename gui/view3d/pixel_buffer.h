// The off-screen buffers that the geometry pass fills: node and normal of each pixel, and its depth.
#pragma once

class vtkOpenGLState;

namespace lodestone {

class PixelBuffer {
 public:
  /// Makes it current for drawing, cleared, at this size.
  void begin(vtkOpenGLState& state, int width, int height);
  /// Binds the pixel texture to unit 0 and the depths to unit 1.
  void bindTextures() const;
  [[nodiscard]] bool fits(int width, int height) const {
    return frame_ != 0 && width == width_ && height == height_;
  }
  void release();

 private:
  void allocate(vtkOpenGLState& state, int width, int height);

  unsigned frame_ = 0;
  unsigned pixels_ = 0;
  unsigned depths_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace lodestone
