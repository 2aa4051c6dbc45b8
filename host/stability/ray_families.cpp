#include "stability/ray_families.h"

namespace cleave {

std::span<const RayFamily> rayFamilies() {
    static const std::vector<RayFamily> families = [] {
        std::vector<RayFamily> all;
        for (const auto group : {generalFamilies(), edgeFamilies(), treeFamilies()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return families;
}

}  // namespace cleave
