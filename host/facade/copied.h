// Converts between the structs of the public headers and those that kernels share with the host: the same bytes.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace cleave {

template <class To, class From>
std::vector<To> copied(std::span<const From> items) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    std::vector<To> result(items.size());
    if (!items.empty()) std::memcpy(result.data(), items.data(), items.size_bytes());
    return result;
}

}  // namespace cleave
