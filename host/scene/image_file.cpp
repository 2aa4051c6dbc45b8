#include "scene/image_file.h"

#include <algorithm>
#include <array>
#include <optional>

#include "scene/check_values.h"
#include "scene/refuse.h"
#include "scene/triangle_count.h"
#include "scene/uri_bytes.h"

namespace cleave {
namespace {

using Bytes = std::span<const unsigned char>;

const char* const kAdvice = "save the image once more, as PNG or JPEG";

uint32_t bigEndian(Bytes bytes, size_t at, size_t size) {
    uint32_t value = 0;
    for (size_t i = 0; i < size; ++i) value = value << 8 | bytes[at + i];
    return value;
}

bool startsWith(Bytes bytes, Bytes start) {
    return bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
}

constexpr std::array<unsigned char, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<unsigned char, 3> kJpeg = {0xFF, 0xD8, 0xFF};

// Portable Network Graphics, sections 5.3 and 11.2.2: the first chunk has 13 bytes and is the header.
ImageHead pngHead(Bytes bytes) {
    constexpr std::array<unsigned char, 8> kHeader = {0, 0, 0, 13, 'I', 'H', 'D', 'R'};
    const bool good = bytes.size() >= 33 && startsWith(bytes.subspan(8), kHeader);
    if (!good) refuseGltf("it is a PNG file without a header", kAdvice);
    return {ImageFormat::png, bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
}

// ITU T.81, table B.1: frames begin by SOF0 to SOF15, among which are three markers of other things.
bool isFrame(unsigned char marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// Those that stand alone: TEM, RST0 to RST7, SOI.
bool hasNoLength(unsigned char marker) { return marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8); }

// ITU T.81, section B.1.1: segments of a marker (0xFF, its code, perhaps after more 0xFF), a length, and data.
ImageHead jpegHead(Bytes bytes) {
    constexpr unsigned char kScan = 0xDA;
    constexpr unsigned char kEnd = 0xD9;
    size_t at = 2;
    while (at + 2 <= bytes.size() && bytes[at] == 0xFF) {
        const unsigned char marker = bytes[at + 1];
        if (marker == 0xFF) {
            ++at;
            continue;
        }
        at += 2;
        if (hasNoLength(marker)) continue;
        if (marker == kScan || marker == kEnd || at + 2 > bytes.size()) break;
        const size_t length = bigEndian(bytes, at, 2);
        if (length < 2 || length > bytes.size() - at) break;
        if (isFrame(marker) && length >= 8)
            return {ImageFormat::jpeg, bigEndian(bytes, at + 5, 2), bigEndian(bytes, at + 3, 2)};
        at += length;
    }
    refuseGltf("it is a JPEG file without the header of a frame", kAdvice);
}

std::vector<unsigned char> bytesOf(const Scene& scene, const gltf::Image& image) {
    if (!image.view) {
        if (image.uri.empty()) refuseGltf("it has neither a URI nor a bufferView");
        return bytesOfUri(scene.folder, image.uri);
    }
    if (!hasBytesOfView(scene, *image.view)) refuseGltf("its buffer is not there");
    const gltf::BufferView& view = scene.bufferViews[*image.view];
    const Bytes bytes = Bytes(scene.buffers[view.buffer].bytes).subspan(view.byteOffset, view.byteLength);
    return {bytes.begin(), bytes.end()};
}

}  // namespace

ImageHead readImageHead(Bytes bytes) {
    const bool isPng = startsWith(bytes, kPng);
    if (!isPng && !startsWith(bytes, kJpeg)) refuseGltf("it is neither a PNG nor a JPEG file", kAdvice);
    const ImageHead head = isPng ? pngHead(bytes) : jpegHead(bytes);
    const auto isSide = [](uint32_t side) { return side >= 1 && side <= kLargestImageSide; };
    if (!isSide(head.width) || !isSide(head.height))
        refuseGltf("it has " + std::to_string(head.width) + " x " + std::to_string(head.height) +
                       " pixels, and a side must have from 1 to " + std::to_string(kLargestImageSide),
                   "scale the image");
    return head;
}

ImageFile readImageFile(const Scene& scene, uint32_t index) {
    return naming("cannot read " + at("images", index) + " of '" + scene.name + "'", [&] {
        ImageFile file;
        file.bytes = bytesOf(scene, scene.images.at(index));
        file.head = readImageHead(file.bytes);
        return file;
    });
}

}  // namespace cleave
