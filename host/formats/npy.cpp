#include "formats/npy.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <istream>
#include <string>

#include "base/error.h"
#include "base/text.h"
#include "formats/npy_header.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "rays and hits are written as they lie in memory");

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr size_t kPrologue = 8;             // magic and version
constexpr uint64_t kMaxHeader = 1u << 20;   // NumPy's are about a hundred bytes
constexpr uint64_t kMaxRays = 0xFFFFFFFFu;  // they are numbered by 32 bits
constexpr size_t kHeaderAlignment = 64;     // of the data, as NumPy aligns it

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
    throw Error(oneLine("cannot read rays from " + file.string() + ": " + why +
                        "; write them with numpy.save as little-endian float32 of shape (N, 8)"));
}

// Reads exactly that many bytes, or rejects the file as truncated.
void readExactly(std::istream& in, const fs::path& file, void* to, uint64_t bytes) {
    in.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
    if (!in || static_cast<uint64_t>(in.gcount()) != bytes) refuse(file, "the file is cut short");
}

// Reads what comes before the header text; its length is 2 bytes in version 1, 4 bytes in versions 2 and 3.
uint64_t readHeaderLength(std::istream& in, const fs::path& file) {
    unsigned char prologue[kPrologue];
    readExactly(in, file, prologue, kPrologue);
    if (std::memcmp(prologue, kMagic.data(), kMagic.size()) != 0) refuse(file, "it does not begin as a .npy file");
    const unsigned major = prologue[6];
    if (major < 1 || major > 3 || prologue[7] != 0)
        refuse(file, "its format version " + std::to_string(major) + "." + std::to_string(prologue[7]) +
                         " is not known (1.0, 2.0, 3.0)");
    unsigned char length[4] = {};
    readExactly(in, file, length, major == 1 ? 2 : 4);
    return length[0] | uint64_t{length[1]} << 8 | uint64_t{length[2]} << 16 | uint64_t{length[3]} << 24;
}

// Number of rays that the header declares.
uint64_t rayCount(const NpyHeader& header, const fs::path& file) {
    constexpr size_t kShown = 40;  // the text is the file's own, and may be of any length
    if (header.descr != "<f4") refuse(file, "its type is '" + header.descr.substr(0, kShown) + "', not '<f4'");
    if (header.fortranOrder) refuse(file, "it is in Fortran order");
    if (header.shape.size() != 2 || header.shape[1] != 8) refuse(file, "its shape is not (N, 8)");
    if (header.shape[0] > kMaxRays) refuse(file, "it announces more than " + std::to_string(kMaxRays) + " rays");
    return header.shape[0];
}

}  // namespace

std::vector<Ray> readRays(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error))
        throw Error("cannot read rays: there is no file " + file.string() + "; check the name");
    if (!fs::is_regular_file(file, error)) refuse(file, "it is no ordinary file");
    const uint64_t size = fs::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    if (error || !in) refuse(file, "it may not be opened");
    return readRays(in, size, file);
}

std::vector<Ray> readRays(std::istream& in, uint64_t size, const fs::path& file) {
    const uint64_t length = readHeaderLength(in, file);
    const auto start = static_cast<uint64_t>(in.tellg());
    if (length > kMaxHeader || length > size - start) refuse(file, "its header is longer than the file or than 1 MiB");
    std::string text(length, '\0');
    readExactly(in, file, text.data(), length);
    std::string why;
    const std::optional<NpyHeader> header = parseNpyHeader(text, why);
    if (!header) refuse(file, why);
    const uint64_t count = rayCount(*header, file);
    const uint64_t data = size - start - length;
    if (data != count * sizeof(Ray))
        refuse(file, "it announces " + std::to_string(count) + " rays, which is " +
                         std::to_string(count * sizeof(Ray)) + " bytes, and holds " + std::to_string(data));
    std::vector<Ray> rays(count);
    readExactly(in, file, rays.data(), data);
    return rays;
}

std::vector<std::byte> npyOf(std::span<const Hit> hits) {
    std::string header =
        "{'descr': [('t', '<f4'), ('prim', '<u4'), ('u', '<f4'), ('v', '<f4')], 'fortran_order': False, 'shape': (" +
        std::to_string(hits.size()) + ",), }";
    const size_t before = kPrologue + 2;
    while ((before + header.size() + 1) % kHeaderAlignment != 0) header += ' ';
    header += '\n';
    std::string start(kMagic);
    start += {'\x01', '\x00', static_cast<char>(header.size() & 0xFF), static_cast<char>(header.size() >> 8)};
    start += header;
    std::vector<std::byte> bytes(start.size() + hits.size_bytes());
    std::memcpy(bytes.data(), start.data(), start.size());
    if (!hits.empty()) std::memcpy(bytes.data() + start.size(), hits.data(), hits.size_bytes());
    return bytes;
}

}  // namespace cleave
