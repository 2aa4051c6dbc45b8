#include "app/saved_tree.h"

#include <fstream>

#include "base/error.h"
#include "formats/write_file.h"
#include "tree/tree_bytes.h"

namespace cleave {
namespace {

std::vector<std::byte> bytesOf(const std::filesystem::path& file) {
    std::error_code failed;
    const uintmax_t size = std::filesystem::file_size(file, failed);
    std::ifstream in(file, std::ios::binary);
    std::vector<std::byte> bytes(failed ? 0 : static_cast<size_t>(size));
    if (failed || !in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
        throw Error("cannot read the tree " + file.string() + "; name a file that info --save-tree wrote");
    return bytes;
}

}  // namespace

void saveTree(const std::filesystem::path& file, const KdTree& tree, std::span<const Triangle> world) {
    writeFile(file, bytesOfTree(tree, world));
}

KdTree readTree(const std::filesystem::path& file, std::span<const Triangle> world, const TriangleSet& set) {
    const std::vector<std::byte> bytes = bytesOf(file);
    try {
        return treeOfBytes(bytes, world, set);
    } catch (const Error& error) {
        throw Error(file.string() + ": " + error.what());
    }
}

}  // namespace cleave
