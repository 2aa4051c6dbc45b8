// Rays as a NumPy file, written without the code that is tested; and files that are nearly that.
#pragma once

#include <string>
#include <vector>

#include "shared/ray.h"

namespace cleave::test {

inline std::string bytesOf(const std::vector<Ray>& rays) {
    return {reinterpret_cast<const char*>(rays.data()), rays.size() * sizeof(Ray)};
}

inline std::string npy(const std::string& shape, const std::string& data, const std::string& descr = "<f4",
                       const std::string& fortran = "False") {
    const std::string header =
        "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }\n";
    return std::string("\x93NUMPY\1\0", 8) + static_cast<char>(header.size()) + '\0' + header + data;
}

inline std::string rayFile(const std::vector<Ray>& rays) {
    return npy("(" + std::to_string(rays.size()) + ", 8)", bytesOf(rays));
}

}  // namespace cleave::test
