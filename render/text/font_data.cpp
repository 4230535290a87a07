#include "render/text/font_data.h"

// The assembler copies the files in: a C++ array of this size would take seconds to compile.
asm(R"(
.pushsection .rodata
.balign 16
chartfloodInterRegular:
.incbin ")" CHARTFLOOD_INTER_REGULAR R"("
chartfloodInterRegularEnd:
.balign 16
chartfloodInterSemiBold:
.incbin ")" CHARTFLOOD_INTER_SEMIBOLD R"("
chartfloodInterSemiBoldEnd:
.globl chartfloodInterRegular, chartfloodInterRegularEnd
.globl chartfloodInterSemiBold, chartfloodInterSemiBoldEnd
.popsection
)");

// NOLINTBEGIN(readability-identifier-naming): symbols of the assembler text above
extern "C" {
extern const unsigned char chartfloodInterRegular[];
extern const unsigned char chartfloodInterRegularEnd[];
extern const unsigned char chartfloodInterSemiBold[];
extern const unsigned char chartfloodInterSemiBoldEnd[];
}
// NOLINTEND(readability-identifier-naming)

namespace chartflood {

std::span<const unsigned char> interRegular() {
  return {chartfloodInterRegular, chartfloodInterRegularEnd};
}

std::span<const unsigned char> interSemiBold() {
  return {chartfloodInterSemiBold, chartfloodInterSemiBoldEnd};
}

}  // namespace chartflood
