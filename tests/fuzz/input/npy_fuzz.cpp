// Any bytes are rays or an Error of one line; rays are the file's last bytes, unchanged.
#include <cstring>
#include <sstream>

#include "base/error.h"
#include "formats/npy.h"
#include "harness.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace cleave::fuzz;
    const TimeLimit limit;
    std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const std::vector<cleave::Ray> rays = cleave::readRays(stream, size, "rays.npy");
        const size_t bytes = rays.size() * sizeof(cleave::Ray);
        require(bytes < size, "rays come after a header");
        if (bytes > 0) require(std::memcmp(rays.data(), data + size - bytes, bytes) == 0, "rays are the file's bytes");
        const std::string head(reinterpret_cast<const char*>(data), size - bytes);
        require(head.starts_with("\x93NUMPY") && head.find("<f4") != std::string::npos &&
                    head.find(std::to_string(rays.size())) != std::string::npos &&
                    head.find("True") == std::string::npos,
                "rays are announced");
    } catch (const cleave::Error& error) {
        requireOneLine(error.what());
    }
    return 0;
}
