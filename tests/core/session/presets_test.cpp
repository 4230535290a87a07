// Presets do what they say: the one for hard surfaces puts no less of the creases on borders than
// the defaults do.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/charts/crease_share.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/session/session.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

std::shared_ptr<const Results> finished(const std::shared_ptr<const Mesh>& mesh,
                                        const Parameters& parameters) {
  Session session(Session::Worker::Inline);
  Document document = session.document();
  document.parameters = parameters;
  session.openMesh(mesh);
  session.setDocument(document);
  session.step(StepUnit::Converged);
  session.waitIdle();
  return session.results();
}

/// By the preset's own creases, with as many charts as the defaults make and with given numbers.
void expectCreasesKept(const std::shared_ptr<const Mesh>& mesh, const std::string& name) {
  const Preset* preset = findPreset("hard-surface");
  ASSERT_NE(preset, nullptr);
  for (const int charts : {0, 8, 20, 50}) {
    Parameters plain;
    if (charts > 0) askCharts(plain, charts);
    const Parameters hard = applyPreset(plain, *preset);
    const GaussArea gauss = computeGaussArea(*mesh, hard.sharpAngle);
    const auto before = finished(mesh, plain), after = finished(mesh, hard);
    ASSERT_TRUE(before->segmentation && after->segmentation) << name;
    EXPECT_EQ(after->segmentation->chartCount, before->segmentation->chartCount) << name;
    EXPECT_GE(creaseShare(*mesh, gauss, after->segmentation->label) + 1e-4,
              creaseShare(*mesh, gauss, before->segmentation->label))
        << name << ", charts " << charts;
  }
}

class HardSurfaceOfSample : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, HardSurfaceOfSample,
                         testing::Values("gear", "knot", "rocket", "cube", "l-block", "cylinder"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::erase(name, '-');
                           return name;
                         });
TEST_P(HardSurfaceOfSample, KeepsNoLessCreasesThanTheDefaults) {
  expectCreasesKept(test::sampleMesh(GetParam(), 30000), GetParam());
}

class HardSurfaceOfMesh : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Meshes, HardSurfaceOfMesh,
                         testing::Values("fandisk.obj", "casting.off", "anchor_dense.off",
                                         "bracket-3.stl", "tray-ascii.stl", "cheese.off",
                                         "fuze.obj", "greek-helmet-quads.obj"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           name = name.substr(0, name.find('.'));
                           std::erase_if(name, [](char c) { return c == '-' || c == '_'; });
                           return name;
                         });
TEST_P(HardSurfaceOfMesh, KeepsNoLessCreasesThanTheDefaults) {
  const auto mesh = test::realMesh(GetParam());
  if (!mesh) GTEST_SKIP() << "no folder of real meshes";
  expectCreasesKept(mesh, GetParam());
}

}  // namespace
}  // namespace chartflood
