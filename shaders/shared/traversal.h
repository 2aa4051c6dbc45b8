// How rays find their way, as kernels are told: the numbers of cleave::Traversal.
#ifndef CLEAVE_SHARED_TRAVERSAL_H
#define CLEAVE_SHARED_TRAVERSAL_H
#include "language.h"

CLEAVE_BEGIN

CLEAVE_CONST uint kRestartTraversal = 0u;     // without a stack
CLEAVE_CONST uint kStackTraversal = 1u;       // with one
CLEAVE_CONST uint kShortStackTraversal = 2u;  // a few entries, and the restart trail for what does not fit

CLEAVE_END
#endif
