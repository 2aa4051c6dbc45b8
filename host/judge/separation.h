// Exact test whether a triangle meets a box, for the validator; builders clip by other means.
#pragma once

#include "shared/box.h"
#include "shared/triangle.h"

namespace cleave {

// The kind of contact that counts: with the open interior of the box only, or with its boundary too.
enum class Contact { interior, closed };

// Separating axis test (Gottschalk et al. 1996; Akenine-Moeller 2001) over the 13 normals that the faces of box minus
// triangle can have. A closed triangle misses an open box iff one of these axes separates them weakly, and a closed box
// iff one does so strictly. Signs come from double where its error bound decides, else from exact sums. The triangle
// has an area; a box for Contact::interior has a volume.
bool meets(const Triangle& triangle, const Box& box, Contact contact);

// The same in the plane, for a triangle of constant coordinate `axis`: does it meet the open rectangle that the box has
// along the other two axes?
bool meetsRectangle(const Triangle& triangle, const Box& box, int axis);

}  // namespace cleave
