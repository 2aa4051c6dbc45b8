// Tiny pictures, rendered by the program and compared with ones that a person has looked at. To look at new ones:
// CLEAVE_GOLDEN_WRITE=1 build/bin/golden_test writes them into tests/golden.
#include <gtest/gtest.h>

#include <stb/stb_image.h>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/program.h"

namespace {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<unsigned char> rgb;
};

Image load(const std::string& file) {
    Image image;
    int channels = 0;
    unsigned char* data = stbi_load(file.c_str(), &image.width, &image.height, &channels, 3);
    if (data) image.rgb.assign(data, data + image.width * image.height * 3);
    stbi_image_free(data);
    return image;
}

void expectGolden(const std::string& name, const std::string& arguments) {
    SCOPED_TRACE(name);
    const std::string golden = std::string(CLEAVE_SOURCE) + "/tests/golden/" + name + ".png";
    const bool writes = std::getenv("CLEAVE_GOLDEN_WRITE") != nullptr;
    const cleave::test::TemporaryFolder folder;  // of this run: others may be under way
    const std::string out = writes ? golden : (folder / (name + ".png")).string();
    const std::string command = "CLEAVE_VALIDATION=1 " CLEAVE_PROGRAM " render " CLEAVE_SOURCE "/scenes/" + arguments +
                                " --size 96x64 --quiet -o " + out;
    ASSERT_EQ(std::system(command.c_str()), 0);
    const Image want = load(golden);
    const Image got = load(out);
    ASSERT_FALSE(want.rgb.empty());
    ASSERT_EQ(got.width, want.width);
    ASSERT_EQ(got.height, want.height);
    int differing = 0;
    for (size_t i = 0; i < want.rgb.size(); i += 3) {
        int most = 0;
        for (size_t c = 0; c < 3; c++) most = std::max(most, std::abs(int(want.rgb[i + c]) - int(got.rgb[i + c])));
        differing += most > 2;
    }
    EXPECT_LE(differing, want.width * want.height / 200) << "of " << want.width * want.height << " pixels";
}

}  // namespace

TEST(Golden, ShadedStillLife) { expectGolden("still_life", "still_life.glb"); }
TEST(Golden, ShadedDefaultScene) { expectGolden("default", "default.glb"); }
TEST(Golden, ShadedCornell) { expectGolden("cornell", "cornell.glb"); }
TEST(Golden, ShadedBySamples) { expectGolden("alpha_samples", "features/alpha.glb --spp 16"); }
TEST(Golden, Normals) { expectGolden("shells_normals", "shells.glb --view normals"); }
TEST(Golden, Depth) { expectGolden("stack_depth", "stack.glb --view depth"); }
TEST(Golden, Steps) { expectGolden("cornell_steps", "cornell.glb --view steps --traversal restart"); }
TEST(Golden, Leaves) { expectGolden("still_life_leaves", "still_life.glb --view leaves"); }
TEST(Golden, Empty) { expectGolden("empty", "empty.gltf"); }
