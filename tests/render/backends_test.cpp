#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/gl/offscreen_context.h"
#include "render/passes/offscreen_render.h"
#include "render/passes/renderer.h"
#include "tests/render/scene.h"
#include "tests/render/shapes.h"

namespace chartflood {
namespace {

Image drawWith(gl::OffscreenBackend backend) {
  const auto context = gl::createOffscreenContext(backend);
  const gl::CurrentScope current(*context);
  Renderer renderer;
  const auto mesh = test::ball(10);
  renderer.show(test::sceneOf(mesh));
  Camera camera;
  camera.look(StandardView::Oblique);
  camera.frame(mesh->positions(), 1.25);
  RenderSettings settings;
  settings.colorMode = ColorMode::Shaded;
  settings.edges = true;
  return renderImage(renderer, camera, settings, {250, 200, 1, 4});
}

bool works(gl::OffscreenBackend backend) {
  try {
    gl::createOffscreenContext(backend);
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(Backends, AtLeastOneWorks) { EXPECT_NO_THROW(drawWith(gl::OffscreenBackend::Auto)); }

TEST(Backends, OsmesaAndEglDrawTheSamePicture) {
  if (!works(gl::OffscreenBackend::OSMesa) || !works(gl::OffscreenBackend::Egl)) {
    GTEST_SKIP() << "OSMesa and EGL are not both here";
  }
  const Image osmesa = drawWith(gl::OffscreenBackend::OSMesa);
  const Image egl = drawWith(gl::OffscreenBackend::Egl);
  EXPECT_EQ(compareImages(osmesa, egl).differentPixels, 0u);
  // And OSMesa again after EGL has been current.
  EXPECT_EQ(drawWith(gl::OffscreenBackend::OSMesa), osmesa);
}

TEST(Backends, TwoContextsKeepTheirOwnThings) {
  const auto first = gl::createOffscreenContext();
  const auto second = gl::createOffscreenContext();
  const auto mesh = test::cube(2);
  Camera camera;
  camera.look(StandardView::Oblique);
  camera.frame(mesh->positions(), 1);
  const auto makeRenderer = [&](gl::Context& context, const std::shared_ptr<const Mesh>& shown) {
    const gl::CurrentScope current(context);
    auto renderer = std::make_unique<Renderer>();
    renderer->show(test::sceneOf(shown));
    return renderer;
  };
  auto a = makeRenderer(*first, mesh);
  auto b = makeRenderer(*second, nullptr);
  const auto drawIn = [&](gl::Context& context, Renderer& renderer) {
    const gl::CurrentScope current(context);
    return renderImage(renderer, camera, {}, {60, 60, 1, 1});
  };
  const Image cube = drawIn(*first, *a);
  const Image empty = drawIn(*second, *b);
  EXPECT_NE(cube, empty);
  EXPECT_EQ(drawIn(*first, *a), cube);
  {
    const gl::CurrentScope current(*second);
    b.reset();
  }
  EXPECT_EQ(drawIn(*first, *a), cube);
  const gl::CurrentScope current(*first);
  a.reset();
}

TEST(Backends, IdsAreRead) {
  EXPECT_EQ(gl::offscreenBackendFromId("osmesa"), gl::OffscreenBackend::OSMesa);
  EXPECT_EQ(gl::offscreenBackendFromId("egl"), gl::OffscreenBackend::Egl);
  EXPECT_EQ(gl::offscreenBackendFromId("auto"), gl::OffscreenBackend::Auto);
  EXPECT_THROW(gl::offscreenBackendFromId("glx"), UsageError);
}

}  // namespace
}  // namespace chartflood
