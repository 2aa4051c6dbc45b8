#include "formats/decode_image.h"

#include <png.h>
#include <turbojpeg.h>

#include <climits>
#include <csetjmp>
#include <cstring>
#include <memory>
#include <string>

#include "base/error.h"
#include "base/one_line.h"

namespace cleave {
namespace {

using Bytes = std::span<const unsigned char>;

[[noreturn]] void refuse(const std::string& why) {
    // The reason may quote the file.
    throw Error("its pixels cannot be decoded (" + oneLine(why) + "); save it anew");
}

// libpng leaves a function by longjmp where it finds a fault, so that nothing here has a destructor.
struct PngReading {
    png_structp png = nullptr;
    png_infop info = nullptr;
    Bytes left;
    char fault[128] = {};
};

void readBytes(png_structp png, png_bytep to, size_t count) {
    auto& reading = *static_cast<PngReading*>(png_get_io_ptr(png));
    if (count > reading.left.size()) png_error(png, "the file ends too early");
    std::memcpy(to, reading.left.data(), count);
    reading.left = reading.left.subspan(count);
}

[[noreturn]] void onFault(png_structp png, png_const_charp what) {
    auto& reading = *static_cast<PngReading*>(png_get_error_ptr(png));
    std::strncpy(reading.fault, what, sizeof(reading.fault) - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

// False: a fault.
bool readPng(PngReading& reading, uint32_t width, uint32_t height, uint32_t* pixels) {
    png_structp png = reading.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_read_fn(png, &reading, readBytes);
    png_set_user_limits(png, width, height);
    // Not read: a small file could have any amount of compressed text.
    static constexpr png_byte kIgnored[] = "iCCP\0zTXt\0iTXt\0tEXt\0eXIf\0sPLT";
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kIgnored, sizeof(kIgnored) / 5);
    png_read_info(png, reading.info);
    if (png_get_image_width(png, reading.info) != width || png_get_image_height(png, reading.info) != height)
        png_error(png, "it has another size than its head says");
    png_set_expand(png);
    png_set_strip_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, reading.info);
    for (int pass = 0; pass < passes; pass++)
        for (uint32_t y = 0; y < height; y++)
            png_read_row(png, reinterpret_cast<png_bytep>(pixels + size_t{width} * y), nullptr);
    return true;
}

void decodePng(Bytes bytes, uint32_t width, uint32_t height, std::vector<uint32_t>& pixels) {
    PngReading reading;
    reading.left = bytes;
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, onFault, onWarning);
    reading.info = reading.png ? png_create_info_struct(reading.png) : nullptr;
    const bool done = reading.info && readPng(reading, width, height, pixels.data());
    png_destroy_read_struct(&reading.png, &reading.info, nullptr);
    if (!done) refuse(reading.fault);
}

// What can be decoded in spite of a warning is shown, as other viewers do.
void decodeJpeg(Bytes bytes, uint32_t width, uint32_t height, std::vector<uint32_t>& pixels) {
    const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), &tjDestroy);
    if (!decoder) throw std::bad_alloc();
    const auto size = static_cast<unsigned long>(bytes.size());
    int columns = 0, rows = 0, subsampling = 0, colours = 0;
    const auto isGood = [&](int result) { return result == 0 || tjGetErrorCode(decoder.get()) == TJERR_WARNING; };
    if (!isGood(tjDecompressHeader3(decoder.get(), bytes.data(), size, &columns, &rows, &subsampling, &colours)))
        refuse(tjGetErrorStr2(decoder.get()));
    if (static_cast<uint32_t>(columns) != width || static_cast<uint32_t>(rows) != height)
        refuse("it has another size than its head says");
    // A limit of scans: a small file could make a large picture pass by many times.
    if (!isGood(tjDecompress2(decoder.get(), bytes.data(), size, reinterpret_cast<unsigned char*>(pixels.data()),
                              columns, 0, rows, TJPF_RGBA, TJFLAG_LIMITSCANS)))
        refuse(tjGetErrorStr2(decoder.get()));
}

}  // namespace

std::vector<uint32_t> decodeImage(Bytes bytes, uint32_t width, uint32_t height) {
    std::vector<uint32_t> pixels(size_t{width} * height);  // bytes R, G, B, A: little-endian
    const bool isPng = bytes.size() >= 8 && png_sig_cmp(bytes.data(), 0, 8) == 0;
    if (isPng)
        decodePng(bytes, width, height, pixels);
    else
        decodeJpeg(bytes, width, height, pixels);
    return pixels;
}

}  // namespace cleave
