#include "figures/names.h"

namespace cleave {
namespace {

template <typename Value, size_t n>
std::string nameIn(const std::array<std::pair<const char*, Value>, n>& table, Value value) {
    for (const auto& [name, known] : table)
        if (known == value) return name;
    return "";
}

}  // namespace

std::string nameOf(Builder builder) { return std::string(builder.name); }
std::string nameOf(AxisChoice axes) { return nameIn(kAxes, axes); }
std::string nameOf(Traversal traversal) { return nameIn(kTraversals, traversal); }
std::string nameOf(TriangleTest test) { return nameIn(kTriangleTests, test); }

}  // namespace cleave
