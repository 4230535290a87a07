#pragma once
/// ZIP archives for tests.

#include <string>
#include <utility>
#include <vector>

namespace chartflood::test {

/// Names and contents of the files in an archive, in their order.
using ZipFiles = std::vector<std::pair<std::string, std::string>>;

/// The bytes of an archive of these files. \throws std::runtime_error
std::string zipArchive(const ZipFiles& files);

/// A 3MF package whose main part is this text, beside further files.
std::string package3mf(const std::string& model, const ZipFiles& more = {});

/// The elements of a cube with 8 vertices and 12 triangles, its lower corner at x.
std::string cubeMesh3mf(int x = 0);

/// The text of a model part: resources and build.
std::string model3mf(const std::string& resources, const std::string& build,
                     const std::string& attributes = "");

}  // namespace chartflood::test
