#include "formats/npy.h"

#include <algorithm>
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
constexpr size_t kPrologue = 8;              // magic and version
constexpr uint64_t kMaxHeader = 1u << 20;    // NumPy's are about a hundred bytes
constexpr uint64_t kMaxItems = 0xFFFFFFFFu;  // they are numbered by 32 bits
constexpr size_t kHeaderAlignment = 64;      // of the data, as NumPy aligns it

// What a file must hold: any number of items of float32, of which this is the shape.
struct Wanted {
    const char* items;
    const char* shape;
    std::vector<uint64_t> itemShape;
};

const Wanted kRays{"rays", "(N, 8)", {8}};
const Wanted kPoints{"points", "(N, 3)", {3}};
const Wanted kBoxes{"boxes", "(N, 2, 3)", {2, 3}};

// A file as it is read; `path` names it in messages.
struct Source {
    const Wanted& wanted;
    std::istream& in;
    const fs::path& path;
};

[[noreturn]] void refuse(const Wanted& wanted, const fs::path& file, const std::string& why) {
    throw Error(oneLine(std::string("cannot read ") + wanted.items + " from " + file.string() + ": " + why +
                        "; write them with numpy.save as little-endian float32 of shape " + wanted.shape));
}
[[noreturn]] void refuse(const Source& source, const std::string& why) { refuse(source.wanted, source.path, why); }

// Reads exactly that many bytes, or rejects the file as truncated.
void readExactly(const Source& source, void* to, uint64_t bytes) {
    source.in.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
    if (!source.in || static_cast<uint64_t>(source.in.gcount()) != bytes) refuse(source, "the file is cut short");
}

// Reads what comes before the header text; its length is 2 bytes in version 1, 4 bytes in versions 2 and 3.
uint64_t readHeaderLength(const Source& source) {
    unsigned char prologue[kPrologue];
    readExactly(source, prologue, kPrologue);
    if (std::memcmp(prologue, kMagic.data(), kMagic.size()) != 0) refuse(source, "it does not begin as a .npy file");
    const unsigned major = prologue[6];
    if (major < 1 || major > 3 || prologue[7] != 0)
        refuse(source, "its format version " + std::to_string(major) + "." + std::to_string(prologue[7]) +
                           " is not known (1.0, 2.0, 3.0)");
    unsigned char length[4] = {};
    readExactly(source, length, major == 1 ? 2 : 4);
    return length[0] | uint64_t{length[1]} << 8 | uint64_t{length[2]} << 16 | uint64_t{length[3]} << 24;
}

// Number of items that the header declares.
uint64_t itemCount(const NpyHeader& header, const Source& source) {
    constexpr size_t kShown = 40;  // the text is the file's own, and may be of any length
    if (header.descr != "<f4") refuse(source, "its type is '" + header.descr.substr(0, kShown) + "', not '<f4'");
    if (header.fortranOrder) refuse(source, "it is in Fortran order");
    const std::vector<uint64_t>& item = source.wanted.itemShape;
    if (header.shape.size() != 1 + item.size() || !std::equal(item.begin(), item.end(), header.shape.begin() + 1))
        refuse(source, std::string("its shape is not ") + source.wanted.shape);
    if (header.shape[0] > kMaxItems)
        refuse(source, "it announces more than " + std::to_string(kMaxItems) + " " + source.wanted.items);
    return header.shape[0];
}

template <class Item>
std::vector<Item> readItems(const Source& source, uint64_t size) {
    const uint64_t length = readHeaderLength(source);
    const auto start = static_cast<uint64_t>(source.in.tellg());
    if (length > kMaxHeader || length > size - start)
        refuse(source, "its header is longer than the file or than 1 MiB");
    std::string text(length, '\0');
    readExactly(source, text.data(), length);
    std::string why;
    const std::optional<NpyHeader> header = parseNpyHeader(text, why);
    if (!header) refuse(source, why);
    const uint64_t count = itemCount(*header, source);
    const uint64_t data = size - start - length;
    if (data != count * sizeof(Item))
        refuse(source, "it announces " + std::to_string(count) + " " + source.wanted.items + ", which is " +
                           std::to_string(count * sizeof(Item)) + " bytes, and holds " + std::to_string(data));
    std::vector<Item> items(count);
    readExactly(source, items.data(), data);
    return items;
}

template <class Item>
std::vector<Item> readItems(const Wanted& wanted, const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error))
        throw Error(std::string("cannot read ") + wanted.items + ": there is no file " + file.string() +
                    "; check the name");
    if (!fs::is_regular_file(file, error)) refuse(wanted, file, "it is no ordinary file");
    const uint64_t size = fs::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    if (error || !in) refuse(wanted, file, "it may not be opened");
    return readItems<Item>({wanted, in, file}, size);
}

template <class Item>
std::vector<std::byte> bytesOf(const std::string& descr, const std::string& shape, std::span<const Item> items) {
    std::string header = "{'descr': " + descr + ", 'fortran_order': False, 'shape': " + shape + ", }";
    const size_t before = kPrologue + 2;
    while ((before + header.size() + 1) % kHeaderAlignment != 0) header += ' ';
    header += '\n';
    std::string start(kMagic);
    start += {'\x01', '\x00', static_cast<char>(header.size() & 0xFF), static_cast<char>(header.size() >> 8)};
    start += header;
    std::vector<std::byte> bytes(start.size() + items.size_bytes());
    std::memcpy(bytes.data(), start.data(), start.size());
    if (!items.empty()) std::memcpy(bytes.data() + start.size(), items.data(), items.size_bytes());
    return bytes;
}

constexpr const char* kHit = "[('t', '<f4'), ('prim', '<u4'), ('u', '<f4'), ('v', '<f4')]";
constexpr const char* kNearest = "[('distance', '<f4'), ('prim', '<u4'), ('u', '<f4'), ('v', '<f4')]";

std::string row(size_t count) { return "(" + std::to_string(count) + ",)"; }
std::string table(size_t rows, size_t columns) {
    return "(" + std::to_string(rows) + ", " + std::to_string(columns) + ")";
}

}  // namespace

std::vector<Ray> readRays(const fs::path& file) { return readItems<Ray>(kRays, file); }
std::vector<Ray> readRays(std::istream& in, uint64_t size, const fs::path& file) {
    return readItems<Ray>({kRays, in, file}, size);
}
std::vector<vec3> readPoints(const fs::path& file) { return readItems<vec3>(kPoints, file); }
std::vector<Box> readBoxes(const fs::path& file) { return readItems<Box>(kBoxes, file); }

std::vector<std::byte> npyOf(std::span<const Hit> hits) { return bytesOf(kHit, row(hits.size()), hits); }
std::vector<std::byte> npyOf(std::span<const Hit> hits, uint32_t hitsPerRow) {
    return bytesOf(kHit, table(hits.size() / hitsPerRow, hitsPerRow), hits);
}
std::vector<std::byte> npyOfNearest(std::span<const Hit> nearest) {
    return bytesOf(kNearest, row(nearest.size()), nearest);
}
std::vector<std::byte> npyOfCounts(std::span<const int32_t> counts) {
    return bytesOf("'<i4'", row(counts.size()), counts);
}
std::vector<std::byte> npyOfBools(std::span<const uint8_t> values) {
    return bytesOf("'|b1'", row(values.size()), values);
}
std::vector<std::byte> npyOfPairs(std::span<const uvec2> pairs) {
    return bytesOf("'<u4'", table(pairs.size(), 2), pairs);
}

}  // namespace cleave
