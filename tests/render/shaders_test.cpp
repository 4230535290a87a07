#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/gl/program.h"
#include "render/gl/shader_source.h"
#include "tests/render/scene.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

using Shaders = test::GlTest;

TEST(ShaderSources, EveryShaderAsksForVersion330Core) {
  int stages = 0;
  for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
    if (shader.name.ends_with(".glsl")) {
      EXPECT_EQ(shader.text.find("#version"), std::string_view::npos) << shader.name;
      continue;
    }
    EXPECT_TRUE(shader.text.starts_with("#version 330 core\n")) << shader.name;
    ++stages;
  }
  EXPECT_GE(stages, 12);
}

TEST_F(Shaders, EveryPairCompilesAndLinks) {
  int pairs = 0;
  for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
    if (!shader.name.ends_with(".vert")) continue;
    const std::string stem(shader.name.substr(0, shader.name.size() - 5));
    EXPECT_NO_THROW(
        gl::Program(stem + ".vert", stem + ".frag", fillMacros(SurfaceFill::TriangleValue)))
        << stem;
    ++pairs;
  }
  EXPECT_GE(pairs, 6);
}

TEST_F(Shaders, EveryVariantOfTheSurfaceCompiles) {
  const std::vector<std::vector<std::string>> floods{{}, {"FLOOD"}, {"FLOOD", "PLAY"}};
  const std::vector<std::vector<std::string>> lights{
      {}, {"LIGHT"}, {"LIGHT", "FLAT"}, {"LIGHT", "VERTEX_LIGHT"}};
  int count = 0;
  for (int fill = 0; fill <= static_cast<int>(SurfaceFill::Checker); ++fill) {
    for (const auto& flood : floods) {
      for (const auto& light : lights) {
        std::vector<std::string> macros = fillMacros(static_cast<SurfaceFill>(fill));
        macros.insert(macros.end(), flood.begin(), flood.end());
        macros.insert(macros.end(), light.begin(), light.end());
        if (++count % 2 == 0) macros.push_back("STATES");
        if (count % 3 == 0) macros.push_back("WIRE");
        if (count % 5 == 0) macros.push_back("IN_TEXTURE");
        if (fill == static_cast<int>(SurfaceFill::Checker))
          macros.push_back("CHECKER " + std::to_string(count % 3));
        EXPECT_NO_THROW(gl::Program("surface.vert", "surface.frag", macros))
            << ::testing::PrintToString(macros);
      }
    }
  }
}

/// A fill that the shader has no lines for would be another one in silence.
TEST(ShaderSources, TheSurfaceHasLinesForEveryFill) {
  const gl::ShaderSource source = gl::loadShader("surface.frag", {});
  for (const std::string& macro : fillMacros(SurfaceFill::Plain)) {
    if (!macro.starts_with("FILL_")) continue;
    const std::string name = macro.substr(0, macro.find(' '));
    const bool last = name == "FILL_FLOOD_TIME";  // what is left of the fills of a flood
    EXPECT_EQ(source.text.find("== " + name + '\n') == std::string::npos, last) << name;
  }
}

class ShaderFolder : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    write("a.vert", "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n");
    gl::setShaderFolder(folder_.path());
  }
  void TearDown() override {
    gl::setShaderFolder({});
    GlTest::TearDown();
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  const TemporaryFolder folder_;
};

TEST_F(ShaderFolder, ErrorsNameTheIncludedFileAndItsLine) {
  write("part.glsl", "float one() {\n  return wrong;\n}\n");
  write(
      "a.frag",
      "#version 330 core\n#include \"part.glsl\"\nout vec4 c;\nvoid main() { c = vec4(one()); }\n");
  try {
    const gl::Program program("a.vert", "a.frag");
    FAIL() << "a broken shader compiled";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("part.glsl:2"), std::string::npos) << error.what();
  }
}

TEST_F(ShaderFolder, LinesAfterAnIncludeKeepTheirNumber) {
  write("part.glsl", "float one() {\n  return 1.0;\n}\n");
  write("a.frag",
        "#version 330 core\n#include \"part.glsl\"\nout vec4 c;\nvoid main() { c = wrong; }\n");
  try {
    const gl::Program program("a.vert", "a.frag");
    FAIL() << "a broken shader compiled";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a.frag:4"), std::string::npos) << error.what();
  }
}

TEST_F(ShaderFolder, AMissingFileIsNamed) {
  write("a.frag", "#version 330 core\n#include \"nowhere.glsl\"\nvoid main() {}\n");
  try {
    const gl::Program program("a.vert", "a.frag");
    FAIL() << "a missing file was not noticed";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere.glsl"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace chartflood
