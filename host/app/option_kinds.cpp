#include "app/option_kinds.h"

#include <cmath>

#include "base/text.h"

namespace cleave {

void addNumber(CLI::App& app, const std::string& name, const std::string& text, float& target,
               std::pair<double, const char*> least, std::pair<double, const char*> most) {
    const auto parse = [=](const std::string& given) {
        const std::optional<double> value = parseNumber(given);
        return value && *value >= least.first && *value <= most.first ? value : std::nullopt;
    };
    const std::string fallback = fixed(target, target == std::floor(target) ? 0 : 1);
    addParsed<double>(
        app, name, "X", text + " (" + fallback + ")", parse,
        [&target](double value) { target = static_cast<float>(value); },
        std::string("a number from ") + least.second + " to " + most.second);
}

}  // namespace cleave
