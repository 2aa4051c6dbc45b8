#include "formats/exr.h"

#include <gtest/gtest.h>
#include <tinyexr.h>

#include <cstdlib>

namespace cleave::test {
namespace {

// Read back by the library: what was written, bright, dark and in every channel.
TEST(Exr, KeepsRadianceAsItIs) {
    std::vector<glm::vec3> pixels;
    for (int i = 0; i < 40 * 33; ++i)
        pixels.emplace_back(static_cast<float>(i) * 1e3f, 1.0f / static_cast<float>(1 + i), i % 7 == 0 ? 0.0f : 1e-20f);
    const std::vector<std::byte> bytes = exrOf(40, 33, pixels);
    float* read = nullptr;
    int width = 0, height = 0;
    const char* why = nullptr;
    ASSERT_EQ(LoadEXRFromMemory(&read, &width, &height, reinterpret_cast<const unsigned char*>(bytes.data()),
                                bytes.size(), &why),
              TINYEXR_SUCCESS)
        << (why != nullptr ? why : "");
    EXPECT_EQ(width, 40);
    EXPECT_EQ(height, 33);
    for (size_t i = 0; i < pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_EQ(read[4 * i + static_cast<size_t>(c)], pixels[i][c]) << "pixel " << i;
    std::free(read);
    EXPECT_EQ(bytes, exrOf(40, 33, pixels)) << "the same bytes every time";
}

}  // namespace
}  // namespace cleave::test
