// Choosing from what a scene has, by name or number.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace cleave {

// Somebody asked for a camera or an animation that the scene does not have; the text lists what it has.
struct NotFound : Error {
    using Error::Error;
};

// Returns the index of the item of that name or, failing that, of that number. Throws NotFound if there is none; `noun`
// is what the items are.
template <typename Named>
size_t findNamed(const std::vector<Named>& items, const std::string& nameOrIndex, const std::string& noun,
                 const std::string& sceneName) {
    for (size_t i = 0; i < items.size(); ++i)
        if (items[i].name == nameOrIndex) return i;
    for (size_t i = 0; i < items.size(); ++i)
        if (std::to_string(i) == nameOrIndex) return i;
    std::string text = "there is no " + noun + " '" + nameOrIndex + "' in '" + sceneName + "': the scene has";
    for (size_t i = 0; i < items.size(); ++i)
        text += (i == 0 ? " " : ", ") + std::to_string(i) + " '" + items[i].name + "'";
    throw NotFound(items.empty() ? text + " no " + noun : text);
}

}  // namespace cleave
