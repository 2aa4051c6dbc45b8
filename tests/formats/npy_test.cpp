#include "formats/npy.h"

#include <gtest/gtest.h>

#include <cstring>

#include "base/error.h"
#include "support/program.h"

namespace cleave::test {
namespace {

std::string npy(const std::string& header, const std::string& data, char major = 1, char minor = 0) {
    std::string bytes = std::string("\x93NUMPY") + major + minor;
    const size_t size = header.size();
    for (int i = 0; i < (major == 1 ? 2 : 4); ++i) bytes += static_cast<char>(size >> (8 * i) & 0xFF);
    return bytes + header + data;
}

std::string headerOf(const std::string& shape, const std::string& descr = "'<f4'", const std::string& order = "False") {
    return "{'descr': " + descr + ", 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
}

std::string bytesOf(const std::vector<Ray>& rays) {
    return {reinterpret_cast<const char*>(rays.data()), rays.size() * sizeof(Ray)};
}

std::vector<Ray> someRays() {
    std::vector<Ray> rays(3);
    for (size_t i = 0; i < rays.size(); ++i) {
        const auto f = static_cast<float>(i);
        rays[i] = {vec3(f, f + 1, f + 2), f + 3, vec3(f + 4, f + 5, f + 6), infinity()};
    }
    return rays;
}

class Npy : public testing::Test {
  protected:
    std::vector<Ray> read(const std::string& bytes) {
        put(folder_ / "rays.npy", bytes);
        return readRays(folder_ / "rays.npy");
    }
    // Why the bytes are refused; empty if they are not.
    std::string refusal(const std::string& bytes) {
        try {
            read(bytes);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
    void expectRefused(const std::string& bytes, const std::string& why) {
        const std::string text = refusal(bytes);
        EXPECT_NE(text.find(why), std::string::npos) << "refusal: '" << text << "', wanted: " << why;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
    TemporaryFolder folder_;
};

TEST_F(Npy, ReadsWhatNumpyWrites) {
    const std::vector<Ray> rays = someRays();
    for (const char major : {'\1', '\2', '\3'}) {
        const std::vector<Ray> got = read(npy(headerOf("(3, 8)"), bytesOf(rays), major));
        ASSERT_EQ(got.size(), 3u);
        EXPECT_EQ(std::memcmp(got.data(), rays.data(), sizeof(Ray) * 3), 0);
    }
    EXPECT_TRUE(read(npy(headerOf("(0, 8)"), "")).empty());
}

TEST_F(Npy, ToleratesWhiteSpaceQuotesAndOrder) {
    const std::string data = bytesOf(someRays());
    EXPECT_EQ(read(npy("{ \"shape\" : ( 3 ,8, ) ,'fortran_order':False,'descr':'<f4'}   \n", data)).size(), 3u);
}

TEST_F(Npy, RefusesOtherShapesAndTypes) {
    const std::string data = bytesOf(someRays());
    for (const char* shape :
         {"(3, 7)", "(24,)", "(3, 8, 1)", "()", "(8, 3)", "3", "(3 8)", "(3, -8)", "(3, 8", "[3, 8]"})
        expectRefused(npy(headerOf(shape), data), "shape");
    for (const char* descr : {"'<f8'", "'>f4'", "'<i4'", "'|f4'", "'=f4'", "[('t', '<f4')]", "None"})
        expectRefused(npy(headerOf("(3, 8)", descr), data), "type");
    expectRefused(npy(headerOf("(3, 8)", "'<f4'", "True"), data), "Fortran");
    expectRefused(npy(headerOf("(3, 8)", "'<f4'", "0"), data), "fortran_order");
}

// Found by fuzzing: the type is the file's own text.
TEST_F(Npy, RefusalsAreOneShortLineWhateverTheTypeSays) {
    for (const std::string& descr :
         {std::string("'<f4\r'"), std::string("'\x1b[2J'"), "'" + std::string(60000, 'f') + "'"}) {
        const std::string text = refusal(npy(headerOf("(0, 8)", descr), ""));
        EXPECT_NE(text.find("type"), std::string::npos) << text;
        EXPECT_EQ(text.find_first_of("\r\n\x1b"), std::string::npos) << text;
        EXPECT_LT(text.size(), 500u);
    }
}

TEST_F(Npy, RefusesSizesThatDoNotFitTheFile) {
    const std::string data = bytesOf(someRays());
    expectRefused(npy(headerOf("(4, 8)"), data), "announces 4 rays");
    expectRefused(npy(headerOf("(2, 8)"), data), "announces 2 rays");
    expectRefused(npy(headerOf("(3, 8)"), data + "x"), "holds 97");
    expectRefused(npy(headerOf("(3, 8)"), data.substr(1)), "holds 95");
    // 2^59 rays are 2^64 bytes, which is 0 where a product wraps.
    expectRefused(npy(headerOf("(576460752303423488, 8)"), ""), "more than");
    expectRefused(npy(headerOf("(4294967295, 8)"), ""), "announces 4294967295 rays");
    expectRefused(npy(headerOf("(99999999999999999999, 8)"), ""), "shape");
}

TEST_F(Npy, RefusesBadBeginnings) {
    const std::string good = npy(headerOf("(3, 8)"), bytesOf(someRays()));
    expectRefused("", "cut short");
    expectRefused(good.substr(0, 7), "cut short");
    expectRefused(good.substr(0, 9), "cut short");
    expectRefused(good.substr(0, 20), "longer than the file");
    expectRefused("PK\3\4" + good.substr(4), "does not begin");
    expectRefused(npy(headerOf("(3, 8)"), "", 4), "version 4.0");
    expectRefused(npy(headerOf("(3, 8)"), "", 1, 1), "version 1.1");
    expectRefused(std::string("\x93NUMPY\2\0\xff\xff\xff\xff{}", 14), "longer than the file");
}

TEST_F(Npy, RefusesHeadersThatAreNoSuchDictionary) {
    const std::string entries = "'fortran_order': False, 'shape': (0, 8)";
    expectRefused(npy("{'descr': '<f4', 'descr': '<f4', " + entries + "}", ""), "twice");
    expectRefused(npy("{'descr': '<f4', 'more': '', " + entries + "}", ""), "unknown key");
    expectRefused(npy("{" + entries + "}", ""), "lacks");
    expectRefused(npy("{'descr': '<f4', " + entries + "} + {}", ""), "goes on");
    expectRefused(npy("{'descr': '<f4', " + entries, ""), "no dictionary");
    expectRefused(npy("{'descr' '<f4', " + entries + "}", ""), "bad key");
    expectRefused(npy("{'descr", ""), "bad key");
    expectRefused(npy("", ""), "no dictionary");
    expectRefused(npy(std::string("{'descr': '<f4', ") + '\0' + entries + "}", ""), "bad key");
}

TEST_F(Npy, RefusesWhatIsNoFile) {
    EXPECT_THROW(readRays(folder_ / "none.npy"), Error);
    EXPECT_THROW(readRays(folder_.path()), Error);
    EXPECT_THROW(readRays("/dev/zero"), Error);
}

TEST(NpyOf, WritesTheHitsThatNumpyReads) {
    std::vector<Hit> hits(2);
    hits[0] = {1.5f, 7, 0.25f, 0.5f};
    hits[1] = missedHit();
    const std::vector<std::byte> bytes = npyOf(hits);
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_EQ(text.substr(0, 8), std::string("\x93NUMPY\1\0", 8));
    const size_t length = static_cast<unsigned char>(text[8]) + 256u * static_cast<unsigned char>(text[9]);
    EXPECT_EQ((10 + length) % 64, 0u);
    const std::string header = text.substr(10, length);
    EXPECT_EQ(header.back(), '\n');
    EXPECT_EQ(header.substr(0, header.find('}') + 1),
              "{'descr': [('t', '<f4'), ('prim', '<u4'), ('u', '<f4'), ('v', '<f4')], 'fortran_order': False, 'shape': "
              "(2,), }");
    ASSERT_EQ(text.size(), 10 + length + 2 * sizeof(Hit));
    EXPECT_EQ(std::memcmp(text.data() + 10 + length, hits.data(), 2 * sizeof(Hit)), 0);
    EXPECT_EQ(npyOf({}).size() % 64, 0u);
}

// The header's dictionary, then the data behind it.
void expectFile(const std::vector<std::byte>& bytes, const std::string& dictionary, const void* data, size_t size) {
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_EQ(text.substr(10, text.find('}') - 9), dictionary);
    ASSERT_EQ(text.size() % 64, size % 64);
    ASSERT_GE(text.size(), size);
    EXPECT_EQ(std::memcmp(text.data() + text.size() - size, data, size), 0);
}

TEST(NpyOf, WritesTheAnswersOfAllQueries) {
    const std::vector<Hit> hits{{1, 2, 3, 4}, {5, 6, 7, 8}, missedHit(), missedHit()};
    const std::string order = "'fortran_order': False, 'shape': ";
    expectFile(npyOf(hits, 2),
               "{'descr': [('t', '<f4'), ('prim', '<u4'), ('u', '<f4'), ('v', '<f4')], " + order + "(2, 2), }",
               hits.data(), 64);
    expectFile(npyOfNearest(hits),
               "{'descr': [('distance', '<f4'), ('prim', '<u4'), ('u', '<f4'), ('v', '<f4')], " + order + "(4,), }",
               hits.data(), 64);
    const std::vector<int32_t> counts{1, -2};
    expectFile(npyOfCounts(counts), "{'descr': '<i4', " + order + "(2,), }", counts.data(), 8);
    const std::vector<uint8_t> values{1, 0, 1};
    expectFile(npyOfBools(values), "{'descr': '|b1', " + order + "(3,), }", values.data(), 3);
    const std::vector<uvec2> pairs{{1, 2}, {1, 3}, {4, 0}};
    expectFile(npyOfPairs(pairs), "{'descr': '<u4', " + order + "(3, 2), }", pairs.data(), 24);
}

TEST_F(Npy, ReadsPointsAndBoxes) {
    const std::vector<float> data{1, 2, 3, 4, 5, 6};
    const std::string bytes(reinterpret_cast<const char*>(data.data()), 24);
    put(folder_ / "points.npy", npy(headerOf("(2, 3)"), bytes));
    put(folder_ / "boxes.npy", npy(headerOf("(1, 2, 3)"), bytes));
    const std::vector<vec3> points = readPoints(folder_ / "points.npy");
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1], vec3(4, 5, 6));
    const std::vector<Box> boxes = readBoxes(folder_ / "boxes.npy");
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_EQ(boxes[0].lo, vec3(1, 2, 3));
    EXPECT_EQ(boxes[0].hi, vec3(4, 5, 6));
    EXPECT_THROW(readPoints(folder_ / "boxes.npy"), Error);
    EXPECT_THROW(readBoxes(folder_ / "points.npy"), Error);
    EXPECT_THROW(readBoxes(folder_ / "none.npy"), Error);
    put(folder_ / "wrong.npy", npy(headerOf("(1, 3, 2)"), bytes));
    EXPECT_THROW(readBoxes(folder_ / "wrong.npy"), Error);
}

}  // namespace
}  // namespace cleave::test
