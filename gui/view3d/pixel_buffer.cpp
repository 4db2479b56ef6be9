#include "gui/view3d/pixel_buffer.h"

#include <array>

#include <vtkOpenGLState.h>
#include <vtk_glew.h>

namespace lodestone {
namespace {

unsigned makeTexture(int internalFormat, unsigned format, unsigned type, int width, int height) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
  glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, type, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

}  // namespace

void PixelBuffer::allocate(vtkOpenGLState& state, int width, int height) {
  release();
  width_ = width;
  height_ = height;
  state.vtkglActiveTexture(GL_TEXTURE0);
  pixels_ = makeTexture(GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, width, height);
  depths_ = makeTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width, height);
  glGenFramebuffers(1, &frame_);
  state.vtkglBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, pixels_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_, 0);
}

void PixelBuffer::begin(vtkOpenGLState& state, int width, int height) {
  if (!fits(width, height)) allocate(state, width, height);
  state.vtkglBindFramebuffer(GL_FRAMEBUFFER, frame_);
  const GLenum target = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &target);
  state.vtkglViewport(0, 0, width, height);
  state.vtkglDepthMask(GL_TRUE);
  state.vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const std::array<GLuint, 4> nothing{};
  const GLfloat farthest = 1;
  glClearBufferuiv(GL_COLOR, 0, nothing.data());
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void PixelBuffer::bindTextures() const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, pixels_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, depths_);
}

void PixelBuffer::release() {
  if (frame_ != 0) {
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &pixels_);
    glDeleteTextures(1, &depths_);
  }
  frame_ = pixels_ = depths_ = 0;
}

}  // namespace lodestone
