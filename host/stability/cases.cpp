#include "stability/cases.h"

namespace cleave {

std::span<const StabilityCase> stabilityCases() {
    static const std::vector<StabilityCase> cases = [] {
        std::vector<StabilityCase> all;
        for (const auto group : {tinyCases(), planarCases(), thinCases(), scaleCases(), denseCases()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return cases;
}

}  // namespace cleave
