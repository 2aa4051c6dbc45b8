// The heads of image files, made here byte by byte, and those of an encoder.
#include "scene/image_file.h"

#include <gtest/gtest.h>

#include "gltf_text.h"

namespace cleave::test {
namespace {

std::string bigEndian(uint32_t value, int size) {
    std::string bytes;
    for (int i = size - 1; i >= 0; --i) bytes += char(value >> (8 * i) & 255);
    return bytes;
}

// A PNG file up to its header's check sum, which nobody reads here.
std::string png(uint32_t width, uint32_t height) {
    return "\x89PNG\r\n\x1A\n" + bigEndian(13, 4) + "IHDR" + bigEndian(width, 4) + bigEndian(height, 4) +
           std::string("\x08\x06\0\0\0crc!", 9);
}

std::string segment(unsigned char marker, const std::string& data) {
    return "\xFF" + std::string(1, char(marker)) + bigEndian(uint32_t(data.size()) + 2, 2) + data;
}

// What comes before a frame's header: an application's segment, which holds bytes that look like one, and tables.
std::string jpegStart() {
    return "\xFF\xD8" + segment(0xE1, "Exif \xFF\xC0 1234567") + "\xFF\xFF" + segment(0xDB, std::string(65, 'q')) +
           segment(0xC4, std::string(30, 'h'));
}

std::string frame(unsigned char marker, uint32_t width, uint32_t height) {
    return segment(marker, "\x08" + bigEndian(height, 2) + bigEndian(width, 2) + std::string("\x01\x01\x11\0", 4));
}

ImageHead headOf(const std::string& bytes) {
    return readImageHead({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

std::string refusalOf(const std::string& bytes) {
    try {
        headOf(bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ImageFile, readsTheSizeOfPng) {
    const ImageHead head = headOf(png(300, 16384));
    EXPECT_EQ(head.format, ImageFormat::png);
    EXPECT_EQ(head.width, 300u);
    EXPECT_EQ(head.height, 16384u);
}

// Of baseline, extended and progressive frames.
TEST(ImageFile, readsTheSizeOfJpeg) {
    for (const int marker : {0xC0, 0xC1, 0xC2}) {
        const ImageHead head = headOf(jpegStart() + frame(static_cast<unsigned char>(marker), 640, 3));
        EXPECT_EQ(head.format, ImageFormat::jpeg);
        EXPECT_EQ(head.width, 640u);
        EXPECT_EQ(head.height, 3u);
    }
}

TEST(ImageFile, refusesWhatItCannotTrust) {
    EXPECT_NE(refusalOf(png(0, 5)).find("0 x 5 pixels"), std::string::npos);
    EXPECT_NE(refusalOf(png(5, 16385)).find("5 x 16385 pixels, and a side must have from 1 to 16384"),
              std::string::npos);
    EXPECT_NE(refusalOf(png(0xFFFFFFFF, 0xFFFFFFFF)).find("4294967295 x 4294967295"), std::string::npos);
    EXPECT_NE(refusalOf(jpegStart() + frame(0xC0, 65535, 1)).find("65535 x 1 pixels"), std::string::npos);
    EXPECT_NE(refusalOf(jpegStart() + frame(0xC0, 640, 0)).find("640 x 0 pixels"), std::string::npos);
    for (const std::string& bytes : {std::string(), std::string("GIF89a....."), std::string("RIFF....WEBP")})
        EXPECT_NE(refusalOf(bytes).find("neither a PNG nor a JPEG"), std::string::npos);
    std::string other = png(1, 1);
    other[12] = 'J';
    EXPECT_NE(refusalOf(other).find("PNG file without a header"), std::string::npos);
    EXPECT_NE(refusalOf(jpegStart() + segment(0xDA, "scan") + frame(0xC0, 1, 1)).find("without the header of a frame"),
              std::string::npos);
    EXPECT_NE(refusalOf(jpegStart() + std::string("\xFF\xC0\0\1", 4)).find("without the header"), std::string::npos);
    for (const std::string& good : {png(3, 3), jpegStart() + frame(0xC0, 3, 3)})
        for (size_t size = 0; size < good.size(); ++size) EXPECT_NE(refusalOf(good.substr(0, size)), "") << size;
}

TEST(ImageFile, isReadByUriOrBufferView) {
    Document document = triangleDocument();
    const int view = document.addView("....." + png(7, 8));
    document.json["bufferViews"][size_t(view)]["byteOffset"] = document.data.size() - png(7, 8).size();
    document.json["bufferViews"][size_t(view)]["byteLength"] = png(7, 8).size();
    document.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}},
                               {{"uri", "data:image/png;base64," + base64(png(1, 2))}},
                               {{"uri", "sub/a%20b.jpg"}},
                               {{"uri", "none.png"}},
                               Json::object(),
                               {{"uri", "data:image/png;base64,AAAA"}}};
    const Folder folder;
    folder.write("sub/a b.jpg", jpegStart() + frame(0xC2, 5, 6));
    const Scene scene = loadGltf(folder.write("scene.gltf", document.text()));
    EXPECT_EQ(readImageFile(scene, 0).head.width, 7u);
    EXPECT_EQ(bytesOf(readImageFile(scene, 0).bytes), png(7, 8));
    EXPECT_EQ(readImageFile(scene, 1).head.height, 2u);
    EXPECT_EQ(readImageFile(scene, 2).head.height, 6u);
    const std::vector<std::pair<uint32_t, const char*>> refused = {
        {3, "cannot read images[3] of '"}, {4, "neither a URI nor a bufferView"}, {5, "neither a PNG nor a JPEG"}};
    for (const auto& [image, message] : refused) {
        try {
            readImageFile(scene, image);
            FAIL() << image;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace cleave::test
