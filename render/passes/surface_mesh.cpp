#include "render/passes/surface_mesh.h"

#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace chartflood {

namespace {

/// Bit i of triangle t: its side i lies inside a polygon.
std::vector<std::uint8_t> innerSides(const Mesh& mesh) {
  std::vector<std::uint8_t> inner(mesh.triangleCount(), 0);
  if (mesh.facesAreTriangles()) return inner;
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    if (!mesh.isDiagonal(side)) continue;
    inner[side / 3] = static_cast<std::uint8_t>(inner[side / 3] | 1u << side % 3);
  }
  return inner;
}

/// Six times the volume inside a closed surface; negative when its triangles face inwards.
double signedVolume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const auto p = mesh.positions();
    sum += glm::dot(p[a], glm::cross(p[b], p[c]));
  }
  return sum;
}

void viewAsTexture(gl::Texture& texture, GLenum format, const gl::Buffer& buffer) {
  texture = gl::Texture::create();
  glBindTexture(GL_TEXTURE_BUFFER, texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
}

}  // namespace

void SurfaceArrays::upload(const SurfaceVertices& vertices) {
  using Vertex = SurfaceVertices::Vertex;
  hasNormals_ = vertices.hasNormals;
  glBindVertexArray(vertexArray_.id());
  gl::uploadBuffer<Vertex>(vertices_, GL_ARRAY_BUFFER, vertices.vertices);
  gl::uploadBuffer<Index>(indices_, GL_ELEMENT_ARRAY_BUFFER, vertices.indices);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, sizeof(Vertex),
                        reinterpret_cast<const void*>(offsetof(Vertex, normal)));
  if (vertices.texture.empty()) {
    glDisableVertexAttribArray(2);
    texturePlaces_.reset();
  } else {
    gl::uploadBuffer<glm::vec3>(texturePlaces_, GL_ARRAY_BUFFER, vertices.texture);
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  }
  glBindVertexArray(0);
}

void SurfaceArrays::draw(std::size_t first, std::size_t count) const {
  glBindVertexArray(vertexArray_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(3 * first * sizeof(Index)));
  glBindVertexArray(0);
}

SurfaceMesh::SurfaceMesh(const Mesh& mesh) : triangleCount_(mesh.triangleCount()) {
  // Pieces may face different ways, so only a single one tells which side is outside.
  culled_ = mesh.closed() && mesh.componentCount() == 1;
  insideOut_ = culled_ && signedVolume(mesh) < 0;
  innerSides_.upload<std::uint8_t>(GL_R8UI, innerSides(mesh));
}

void SurfaceMesh::setVertices(const SurfaceVertices& vertices) {
  arrays_.upload(vertices);
  viewAsTexture(vertexTexture_, GL_RGBA32F, arrays_.vertices());
  viewAsTexture(indexTexture_, GL_R32UI, arrays_.indices());
}

void SurfaceMesh::setSimple(const SimpleSurface& simple) {
  simple_.emplace();
  simple_->arrays.upload(simple.surface);
  simple_->triangles.upload<Index>(GL_R32UI, simple.triangles);
  simple_->count = simple.triangles.size();
  simple_->detail = simple.detail;
}

void SurfaceMesh::draw(const SurfaceArrays& arrays, bool outsideAlone, std::size_t first,
                       std::size_t count) const {
  glFrontFace(insideOut_ ? GL_CW : GL_CCW);
  if (culled_ && outsideAlone) glEnable(GL_CULL_FACE);
  arrays.draw(first, count);
  glDisable(GL_CULL_FACE);
  glFrontFace(GL_CCW);
}

void SurfaceMesh::draw(bool outsideAlone, std::size_t first, std::size_t count) const {
  draw(arrays_, outsideAlone, first, count);
}

void SurfaceMesh::drawSimple(bool outsideAlone, std::size_t first, std::size_t count) const {
  draw(simple_->arrays, outsideAlone, first, count);
}

void SurfaceMesh::bindSimple(GLuint unit) const { simple_->triangles.bind(unit); }

void SurfaceMesh::bindArrays(GLuint vertexUnit, GLuint indexUnit, GLuint innerSideUnit) const {
  glActiveTexture(GL_TEXTURE0 + vertexUnit);
  glBindTexture(GL_TEXTURE_BUFFER, vertexTexture_.id());
  glActiveTexture(GL_TEXTURE0 + indexUnit);
  glBindTexture(GL_TEXTURE_BUFFER, indexTexture_.id());
  innerSides_.bind(innerSideUnit);
}

}  // namespace chartflood
