#include "gui/view3d/gl_program.h"

#include <array>
#include <stdexcept>

#include <vtk_glew.h>

namespace lodestone {

unsigned GlProgram::compile(unsigned kind, const char* source) const {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (!done) {
    std::array<char, 2048> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error("shader " + name_ + ": " + log.data());
  }
  return shader;
}

void GlProgram::use() {
  if (id_ == 0) {
    const GLuint vertex = compile(GL_VERTEX_SHADER, vertexSource_);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentSource_);
    id_ = glCreateProgram();
    glAttachShader(id_, vertex);
    glAttachShader(id_, fragment);
    glBindAttribLocation(id_, 0, "position");
    glBindAttribLocation(id_, 1, "tag");
    glBindFragDataLocation(id_, 0, "outColour");
    glLinkProgram(id_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint done = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &done);
    if (!done) throw std::runtime_error("shader " + name_ + " does not link");
  }
  glUseProgram(id_);
}

void GlProgram::release() {
  if (id_ != 0) glDeleteProgram(id_);
  id_ = 0;
}

void GlProgram::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(id_, uniform), value);
}
void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(id_, uniform), value);
}
void GlProgram::set(const char* uniform, float x, float y) const {
  glUniform2f(glGetUniformLocation(id_, uniform), x, y);
}
void GlProgram::set3f(const char* uniform, float x, float y, float z) const {
  glUniform3f(glGetUniformLocation(id_, uniform), x, y, z);
}
void GlProgram::setMatrix(const char* uniform, const float* columnMajor) const {
  glUniformMatrix4fv(glGetUniformLocation(id_, uniform), 1, GL_FALSE, columnMajor);
}

}  // namespace lodestone
