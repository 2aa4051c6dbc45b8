// The questions that a ray can ask.
#pragma once

namespace cleave {

// The nearest triangle that the ray hits, or whether it hits any.
enum class Query { closest, any };

}  // namespace cleave
