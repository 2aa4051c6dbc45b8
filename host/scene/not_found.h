// A name or number that a scene does not have.
#pragma once

#include "error.h"

namespace cleave {

// Somebody asked for a camera or an animation by a name or number that the scene does not have; the text lists what it
// has.
struct NotFound : Error {
    using Error::Error;
};

}  // namespace cleave
