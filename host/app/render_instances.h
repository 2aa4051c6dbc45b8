// render --instances: a picture of meshes in places, in the views that show nothing of triangles.
#pragma once

#include "app/instanced_session.h"

namespace cleave {

void renderInstances(Run& run, InstancedSession session);

}  // namespace cleave
