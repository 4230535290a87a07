#include "render/gl/framebuffer.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "core/base/error.h"

namespace chartflood::gl {

namespace {

void checkComplete(int width, int height) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error("The graphics driver refused a picture of " + std::to_string(width) + " x " +
              std::to_string(height) + " pixels; ask for a smaller one.");
}

Texture makeColorTexture(int width, int height) {
  Texture texture = Texture::create();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

}  // namespace

Framebuffer::Framebuffer(int width, int height, int samples)
    : width_(std::max(width, 1)), height_(std::max(height, 1)) {
  const FramebufferScope keep;
  GLint maxSamples = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &maxSamples);
  samples_ = std::clamp(samples, 1, std::max(maxSamples, 1));

  resolvedColor_ = makeColorTexture(width_, height_);
  depth_ = Renderbuffer::create();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_ > 1 ? samples_ : 0,
                                   GL_DEPTH_COMPONENT24, width_, height_);
  draw_ = FramebufferObject::create();
  glBindFramebuffer(GL_FRAMEBUFFER, draw_.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  if (samples_ == 1) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolvedColor_.id(),
                           0);
    checkComplete(width_, height_);
    return;
  }
  color_ = Renderbuffer::create();
  glBindRenderbuffer(GL_RENDERBUFFER, color_.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, width_, height_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.id());
  checkComplete(width_, height_);
  resolved_ = FramebufferObject::create();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolvedColor_.id(),
                         0);
  checkComplete(width_, height_);
}

void Framebuffer::bindForDrawing() const {
  static std::atomic<std::uint32_t> drawings{0};  // contexts of several threads may draw
  drawing_ = ++drawings;
  merged_ = false;
  glBindFramebuffer(GL_FRAMEBUFFER, draw_.id());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::resolve() const {
  if (samples_ > 1) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, draw_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
    if (!merged_) {
      glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
      merged_ = true;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  } else {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, draw_.id());
  }
}

FramebufferScope::FramebufferScope() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
}

FramebufferScope::~FramebufferScope() {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

}  // namespace chartflood::gl
