// Runs the decoders of Draco's library, within the limits of what was announced.
#pragma once

#include <draco/mesh/mesh.h>

#include <span>
#include <string>

#include "scene/draco_mesh.h"

namespace cleave {

// Fills `mesh`, which is empty. Throws Error, as decompressDracoMesh does, before anything is allocated or counted that
// goes beyond the request. What the mesh then holds is still to be checked.
void decodeDraco(std::span<const unsigned char> bytes, const DracoRequest& request, const std::string& where,
                 draco::Mesh& mesh);

}  // namespace cleave
