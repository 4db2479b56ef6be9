#include "gui/view3d/gpu_mesh.h"

#include <cstddef>

#include <vtk_glew.h>

namespace lodestone {

void GpuMesh::setMesh(std::shared_ptr<const NodeMesh> mesh) {
  mesh_ = std::move(mesh);
  counts_.clear();
  offsets_.clear();
}

void GpuMesh::setRanges(const std::vector<MeshRange>& ranges) {
  counts_.clear();
  offsets_.clear();
  std::uint64_t end = 0;
  for (const MeshRange& range : ranges) {
    if (range.count == 0) continue;
    if (!counts_.empty() && range.first == end) {
      counts_.back() += static_cast<int>(range.count);
    } else {
      counts_.push_back(static_cast<int>(range.count));
      offsets_.push_back(reinterpret_cast<const void*>(range.first * sizeof(std::uint32_t)));
    }
    end = std::uint64_t{range.first} + range.count;
  }
}

void GpuMesh::upload() {
  release();
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh_->vertices.size() * sizeof(MeshVertex)),
               mesh_->vertices.data(), GL_STATIC_DRAW);
  glGenBuffers(1, &indices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh_->indices.size() * sizeof(std::uint32_t)), mesh_->indices.data(),
               GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(MeshVertex),
                         reinterpret_cast<const void*>(offsetof(MeshVertex, tag)));
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  uploaded_ = mesh_;
}

void GpuMesh::draw() {
  if (empty()) return;
  if (uploaded_ != mesh_) upload();
  glBindVertexArray(array_);
  glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, offsets_.data(),
                      static_cast<GLsizei>(counts_.size()));
  glBindVertexArray(0);
}

void GpuMesh::release() {
  if (array_ != 0) {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &vertices_);
    glDeleteBuffers(1, &indices_);
  }
  array_ = vertices_ = indices_ = 0;
  uploaded_.reset();
}

}  // namespace lodestone
