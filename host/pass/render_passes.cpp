#include "pass/render_passes.h"

#include "shared/dispatch.h"

namespace cleave {

RenderPasses::RenderPasses(Context& c)
    : shadowRays_(c, "shadow_rays", sizeof(ShadePush)), shade_(c, "shade", sizeof(ShadePush)) {}

void RenderPasses::shadowRays(Recorder& r, const ShadePush& push) const {
    r.dispatch(shadowRays_, push, ceilDiv(push.count, kGroup));
}
void RenderPasses::shade(Recorder& r, const ShadePush& push) const {
    r.dispatch(shade_, push, ceilDiv(push.count, kGroup));
}

}  // namespace cleave
