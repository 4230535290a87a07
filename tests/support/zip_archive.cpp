#include "tests/support/zip_archive.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <zip.h>

#include "tests/support/temporary_folder.h"

namespace chartflood::test {

std::string zipArchive(const ZipFiles& files) {
  const TemporaryFolder folder;
  const std::string place = folder / "archive.zip";
  zip_t* archive = zip_open(place.c_str(), ZIP_CREATE, nullptr);
  if (archive == nullptr) throw std::runtime_error("zip_open failed");
  for (const auto& [name, text] : files) {
    zip_source_t* source = zip_source_buffer(archive, text.data(), text.size(), 0);
    const zip_int64_t entry = zip_file_add(archive, name.c_str(), source, 0);
    if (entry < 0) throw std::runtime_error("zip_file_add failed");
    // The same bytes whenever the test runs.
    zip_file_set_dostime(archive, static_cast<zip_uint64_t>(entry), 0, 0x21, 0);
  }
  if (zip_close(archive) != 0) throw std::runtime_error("zip_close failed");
  std::ifstream stream(place, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string package3mf(const std::string& model, const ZipFiles& more) {
  ZipFiles files = {
      {"[Content_Types].xml",
       R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"/>)"},
      {"_rels/.rels",
       R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/Main.model" Id="r0"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
      {"3D/Main.model", model}};
  files.insert(files.end(), more.begin(), more.end());
  return zipArchive(files);
}

std::string cubeMesh3mf(int x) {
  std::string text = "<mesh><vertices>";
  for (int corner = 0; corner < 8; ++corner) {
    text += "<vertex x=\"" + std::to_string(x + (corner & 1)) + "\" y=\"" +
            std::to_string((corner >> 1) & 1) + "\" z=\"" + std::to_string(corner >> 2) + "\"/>";
  }
  text += "</vertices><triangles>";
  for (const char* triangle :
       {"021", "123", "456", "576", "014", "154", "273", "267", "042", "246", "135", "375"}) {
    text += std::string("<triangle v1=\"") + triangle[0] + "\" v2=\"" + triangle[1] + "\" v3=\"" +
            triangle[2] + "\"/>";
  }
  return text + "</triangles></mesh>";
}

std::string model3mf(const std::string& resources, const std::string& build,
                     const std::string& attributes) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" " +
         attributes + ">\n<resources>" + resources + "</resources><build>" + build +
         "</build></model>\n";
}

}  // namespace chartflood::test
