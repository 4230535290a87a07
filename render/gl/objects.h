#pragma once
/// Move-only owners of GL objects. Each is destroyed while its context is current.

#include <cstddef>
#include <span>
#include <utility>

#include <epoxy/gl.h>

namespace chartflood::gl {

/// Owns one GL name made and deleted by `Kind`; empty (0) unless made by `create()`.
template <typename Kind>
class Handle {
 public:
  Handle() = default;
  static Handle create() {
    Handle handle;
    handle.id_ = Kind::create();
    return handle;
  }
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  void reset() {
    if (id_ != 0) Kind::destroy(std::exchange(id_, 0));
  }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

struct BufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct TextureKind {
  static GLuint create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct VertexArrayKind {
  static GLuint create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct RenderbufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct FramebufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};

using Buffer = Handle<BufferKind>;
using Texture = Handle<TextureKind>;
using VertexArray = Handle<VertexArrayKind>;
using Renderbuffer = Handle<RenderbufferKind>;
using FramebufferObject = Handle<FramebufferKind>;

/// Fills a buffer bound to `target` with a copy of `data`; makes it first where it is empty.
template <typename T>
void uploadBuffer(Buffer& buffer, GLenum target, std::span<const T> data,
                  GLenum usage = GL_STATIC_DRAW) {
  if (!buffer) buffer = Buffer::create();
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

/// An array that shaders read by index (samplerBuffer and its integer kinds).
class TextureBuffer {
 public:
  /// Replaces the content; `format` such as GL_R32UI must match the layout of T. An empty array
  /// becomes one zero element, because a buffer texture needs storage.
  template <typename T>
  void upload(GLenum format, std::span<const T> data, GLenum usage = GL_STATIC_DRAW) {
    const T zero{};
    const std::span<const T> content = data.empty() ? std::span<const T>(&zero, 1) : data;
    uploadBuffer(buffer_, GL_TEXTURE_BUFFER, content, usage);
    if (!texture_) texture_ = Texture::create();
    glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer_.id());
  }
  /// Overwrites the elements from `first` on; they must lie inside what was uploaded.
  template <typename T>
  void update(std::size_t first, std::span<const T> data) {
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * sizeof(T)),
                    static_cast<GLsizeiptr>(data.size_bytes()), data.data());
  }
  /// Makes the array readable on a texture unit.
  void bind(GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
  }
  explicit operator bool() const { return static_cast<bool>(texture_); }

 private:
  Buffer buffer_;
  Texture texture_;
};

}  // namespace chartflood::gl
